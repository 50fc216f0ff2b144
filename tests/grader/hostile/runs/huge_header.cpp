// A frame of the right size whose header says 100,000 x 100,000.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() { writeFrame(0.5F, "PF\n100000 100000\n-1.0", 382); }
