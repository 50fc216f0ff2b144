// Never ends.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}
