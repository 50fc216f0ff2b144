// Its frame is a link to a file that the grader can read.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() { return ::symlink("/etc/hostname", "out/0.pfm"); }
