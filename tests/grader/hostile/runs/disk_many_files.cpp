// Writes files of a size that is allowed, without end.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <string>

int main() {
    static char part[1 << 20];
    for (int i = 0; i < 500; ++i) {
        std::FILE* const file = std::fopen(std::to_string(i).c_str(), "wb");
        if (file == nullptr || std::fwrite(part, 1, sizeof(part), file) != sizeof(part) ||
            std::fclose(file) != 0) {
            say("disk: refused");
            return 1;
        }
    }
    ::pause();
}
