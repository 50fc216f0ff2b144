// An object that fills the disk.
// SPDX-License-Identifier: MIT
int giant[500'000'000] = {1};

int main() { return giant[3]; }
