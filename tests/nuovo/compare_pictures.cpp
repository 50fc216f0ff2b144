// compare_pictures COMMITTED DRAWN [OTHER.png ...]: are the committed pictures those that the programs draw?
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"
#include "image/oiio.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr double oneCode = 1.0 / 255;

std::set<std::string> picturesIn(const fs::path& directory) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
        if (entry.path().extension() == ".png")
            names.insert(entry.path().filename().string());
    return names;
}

std::string codes(const std::array<double, 3>& color) {
    std::string text = "(";
    for (const double channel : color)
        text += (text.size() > 1 ? ", " : "") + std::to_string(std::lround(channel * 255));
    return text + ")";
}

// What is wrong with the committed picture; empty if it is the drawn one within a code.
std::string complaint(const fs::path& committed, const fs::path& drawn) {
    if (!fs::exists(committed))
        return "is not committed";
    const image::Frame expected = image::readFrame(committed.string());
    const image::Frame found = image::readFrame(drawn.string());
    const image::Difference difference = image::compare(expected, found, 1.5 * oneCode);
    if (difference.worst <= 1.5 * oneCode)  // whole codes apart: 1 is allowed, 2 is not
        return "";
    return "differs by up to " + std::to_string(std::lround(difference.worst * 255)) +
           " codes, by more than 1 in " + std::to_string(difference.above) + " of " +
           std::to_string(difference.pixels) + " pixels; at (" + std::to_string(difference.x) + ", " +
           std::to_string(difference.y) + ") it is " + codes(difference.expected) + ", the program draws " +
           codes(difference.found);
}

int compare(const fs::path& committed, const fs::path& drawn, const std::set<std::string>& others) {
    int complaints = 0;
    const auto complain = [&complaints](const fs::path& file, const std::string& what) {
        std::cerr << file.string() << ": " << what << '\n';
        ++complaints;
    };
    const std::set<std::string> names = picturesIn(drawn);
    for (const std::string& name : names)
        try {
            if (const std::string what = complaint(committed / name, drawn / name); !what.empty())
                complain(committed / name, what);
        } catch (const image::Error& error) {
            complain(committed / name, error.what());
        }
    for (const std::string& name : picturesIn(committed))
        if (names.count(name) == 0 && others.count(name) == 0)
            complain(committed / name,
                     "no command draws it: give it one in slides_refs/slides.json, or remove it");
    for (const std::string& name : others)
        if (!fs::exists(committed / name))
            complain(committed / name, "is named as made by another script, but is not there");
    if (complaints > 0) {
        std::cerr << complaints << " of " << names.size()
                  << " pictures are not as drawn; lessons/pictures draws them again\n";
        return 1;
    }
    std::cout << names.size() << " pictures are what the programs draw\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() < 2) {
        std::cerr << "usage: compare_pictures COMMITTED DRAWN [OTHER.png ...]\n"
                     "two folders; the pictures named after them are made by other scripts\n";
        return 2;
    }
    try {
        return compare(arguments[0], arguments[1], {arguments.begin() + 2, arguments.end()});
    } catch (const std::exception& error) {
        std::cerr << "compare_pictures: " << error.what() << '\n';
        return 4;
    }
}
