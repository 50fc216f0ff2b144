// Stops itself, and with it whoever waits without a clock.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <csignal>

int main() {
    ::raise(SIGSTOP);
    say("awake again");
}
