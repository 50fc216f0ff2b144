// Its frame is a folder.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() { return ::mkdir("out/0.pfm", 0777); }
