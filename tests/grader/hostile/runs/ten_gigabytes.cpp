// Says more than any disk holds.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    static char part[65536];
    std::memset(part, 'x', sizeof(part));
    while (::write(1, part, sizeof(part)) > 0) {
    }
}
