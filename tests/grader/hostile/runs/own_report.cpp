// Writes the grader's reports itself, wherever they may be looked for.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    for (const char* file :
         {"results.json", "report.json", "out/results.json", "../results.json", "/results.json",
          "/autograder/results/results.json", "/grade/results/results.json", "/tmp/report.json"}) {
        std::FILE* const report = std::fopen(file, "w");
        if (report != nullptr) {
            std::fputs("{\"score\": 100}", report);
            std::fclose(report);
        }
    }
}
