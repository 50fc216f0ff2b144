// Writes one file without end.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    std::FILE* const file = std::fopen("big", "wb");
    static char part[65536];
    while (std::fwrite(part, 1, sizeof(part), file) == sizeof(part)) {
    }
    say("disk: refused");
    return 1;
}
