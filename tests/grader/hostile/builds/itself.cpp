// Includes itself.
// SPDX-License-Identifier: MIT
#include "itself.cpp"

int main() {}
