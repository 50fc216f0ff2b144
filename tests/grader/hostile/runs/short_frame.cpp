// A frame that lacks its end.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() { writeFrame(0.5F, "PF\n16 8\n-1.0\n", 100); }
