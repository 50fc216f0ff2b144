// Shows what the parts of tests/bench measured: bench_summary table DIR, or bench_summary readme README.md RESULTS_DIR NAME
// SPDX-License-Identifier: MIT
//
// `readme` rewrites README's section from the JSON files of RESULTS_DIR, which README calls NAME.
#include "bench/summary.hpp"
#include "image/write.hpp"

#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>

int main(int count, char** arguments) {
    try {
        if (count == 3 && std::strcmp(arguments[1], "table") == 0) {
            std::cout << bench::terminalTable(bench::readParts(arguments[2]));
            return 0;
        }
        if (count == 5 && std::strcmp(arguments[1], "readme") == 0) {
            std::ostringstream text;
            text << std::ifstream(arguments[2]).rdbuf();
            image::writeText(arguments[2], bench::withMarkedPart(
                                               text.str(), bench::readmeSection(arguments[3], arguments[4])));
            return 0;
        }
    } catch (const std::exception& error) {
        std::cerr << "bench_summary: " << error.what() << '\n';
        return 1;
    }
    std::cerr << "usage: bench_summary table DIR | readme README.md RESULTS_DIR NAME\n";
    return 2;
}
