// Takes memory until it gets no more.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <cstdlib>

int main() {
    for (int megabytes = 0; megabytes < 20'000; megabytes += 16) {
        void* const memory = std::malloc(16 << 20);
        if (memory == nullptr) {
            say(megabytes < 1000 ? "memory: refused" : "memory: too late");
            return 1;
        }
        std::memset(memory, 1, 16 << 20);
    }
    say("memory: all that there is");
}
