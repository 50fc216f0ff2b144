// Waits for ever, with every signal ignored that can be.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <csignal>

int main() {
    for (int signal = 1; signal < 65; ++signal) {
        ::signal(signal, SIG_IGN);
    }
    for (;;) {
        ::pause();
    }
}
