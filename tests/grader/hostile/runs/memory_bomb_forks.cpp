// Many processes, each of them within its own limit of memory.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <cstdlib>

int main() {
    for (int i = 0; i < 20; ++i) {
        if (::fork() == 0) {
            void* const memory = std::malloc(100 << 20);
            std::memset(memory, 1, 100 << 20);
            ::pause();
        }
    }
    ::pause();
}
