// Folders within folders, deeper than a path is long, and closed to everybody.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <string>

int main() {
    for (int i = 0; i < 80; ++i) {
        const std::string name(200, 'd');
        if (::mkdir(name.c_str(), 0700) != 0 || ::chdir(name.c_str()) != 0) {
            return 1;
        }
    }
    ::close(::open("x\ny \xff", O_WRONLY | O_CREAT, 0));
    return ::chmod(".", 0);
}
