// Its frame has a second name.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    writeFrame(0.5F);
    return ::link("out/0.pfm", "out/1.pfm");
}
