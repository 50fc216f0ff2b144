// Ignores that its processor time is over.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <csignal>

int main() {
    ::signal(SIGXCPU, SIG_IGN);
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}
