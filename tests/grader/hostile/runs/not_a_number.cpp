// A frame of NaN, which no comparison finds larger than any tolerance.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <cmath>

int main() { writeFrame(std::nanf("")); }
