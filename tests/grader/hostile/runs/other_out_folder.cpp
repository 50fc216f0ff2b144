// Puts a link in the place of the folder that frames are read from.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    writeFrame(0.5F);
    ::rename("out/0.pfm", "0.pfm");
    ::rename("out", "old");
    return ::symlink(".", "out");
}
