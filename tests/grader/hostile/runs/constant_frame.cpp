// A picture that was computed elsewhere: a frame, and judged as one.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() { writeFrame(0.25F); }
