// Calls itself without end.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int deeper(int n) {
    volatile char room[4096];
    room[0] = static_cast<char>(n);
    return deeper(n + 1) + room[0];
}

int main() { return deeper(0); }
