// Writes to nowhere.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    int* volatile nowhere = nullptr;
    *nowhere = 1;
}
