// Kills whoever it reaches: its parent, the first process, everybody.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <csignal>

int main() {
    ::kill(::getppid(), SIGKILL);
    ::kill(1, SIGKILL);
    ::kill(-1, SIGKILL);
    ::kill(-::getppid(), SIGKILL);
    ::kill(::getppid(), SIGSTOP);
    ::syscall(SYS_tgkill, ::getppid(), ::getppid(), SIGKILL);
    say("all gone?");
    writeFrame(0.25F);
}
