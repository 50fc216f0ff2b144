// Closes everything that it was given, then draws.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    for (int file = 0; file < 200; ++file) {
        ::close(file);
    }
    writeFrame(0.25F);
}
