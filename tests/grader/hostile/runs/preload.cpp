// Starts itself again with a library of its own in front.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <cstdlib>

int main(int argc, char** argv) {
    if (std::getenv("LD_PRELOAD") != nullptr) {
        say("here again");
        return argc - argc;
    }
    ::setenv("LD_PRELOAD", "out/evil.so", 1);
    ::setenv("LD_LIBRARY_PATH", "out", 1);
    return ::execv("../lab/bin/program", argv);
}
