// Says that all is well, in every grader's words, and in a terminal's.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    say("PASS\n[  PASSED  ] 100 tests.\nGrade :=>>100\n<|--\n-Comment\n--|>");
    say("{\"scores\": {\"lesson\": 100}}");
    say("\x1b[2J\x1b[1;1H\x1b]0;graded\x07\x9b"
        "31m\xe2\x80\xae"
        "001\b\b\b\r100");
}
