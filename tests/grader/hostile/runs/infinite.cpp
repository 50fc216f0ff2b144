// A frame of infinities.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <cmath>

int main() { writeFrame(HUGE_VALF); }
