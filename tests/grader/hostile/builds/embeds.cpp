// Embeds what it may not read: at compile time, when nobody looks.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

__asm__(".incbin \"" SECRET_FILE "\"");

int main() {}
