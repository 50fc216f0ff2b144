// Its frame is a pipe, where a reader waits for ever.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() { return ::mkfifo("out/0.pfm", 0666); }
