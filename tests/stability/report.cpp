// Writes the stability report: stability_report PAGE.md PICTURE.png. tests/stability/report builds and runs it.
// SPDX-License-Identifier: MIT
#include "image/write.hpp"
#include "stability/picture.hpp"

#include <exception>
#include <iostream>

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "usage: stability_report PAGE.md PICTURE.png\n";
        return 2;
    }
    try {
        const std::vector<stability::Line> lines = stability::tableLines();
        image::writeText(arguments[1], stability::markdown(lines));
        stability::drawTable(lines, arguments[2]);
        for (const stability::Line& line : lines)
            if (line[stability::verdict].verdict == stability::Peer::wrong)
                std::cerr << "row " << line[stability::id].text
                          << " misses its bound: bin/test_stability says by how much\n";
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 5;
    }
}
