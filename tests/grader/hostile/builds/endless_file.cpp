// Includes a file without an end.
// SPDX-License-Identifier: MIT
#include "/dev/zero"

int main() {}
