// A process of its own session that ignores every signal outlives its parents.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <csignal>
#include <sys/prctl.h>

int main() {
    if (::fork() != 0) {
        return 0;
    }
    ::setsid();
    if (::fork() != 0) {
        return 0;
    }
    ::prctl(PR_SET_NAME, "hostile-daemon");
    for (int signal = 1; signal < 65; ++signal) {
        ::signal(signal, SIG_IGN);
    }
    for (;;) {
        ::sleep(1000);
    }
}
