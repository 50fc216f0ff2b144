// Starts threads until it may not.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <pthread.h>

void* wait(void*) {
    ::pause();
    return nullptr;
}

int main() {
    int count = 0;
    for (pthread_t thread{}; count < 10'000 && ::pthread_create(&thread, nullptr, wait, nullptr) == 0;) {
        ++count;
    }
    say(count < 200 ? "threads: refused" : "threads: thousands");
    ::_exit(0);
}
