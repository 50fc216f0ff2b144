// Ends well, without a frame.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() { return 0; }
