// Mine, expected and difference: three pictures beside each other, in a file or a window.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/grading/grader.hpp"
#include "image/frame.hpp"

#include <array>

namespace grader {

/// The pictures of one part of a submission, as 8-bit codes; where one is missing, its width is 0.
struct Trio {
    std::string part;  ///< "lesson" or "terms"
    std::string view;  ///< in words
    std::array<image::Frame, 3> pictures;  ///< mine, expected, difference
};

/// One for each part that has pictures; a part where something is wrong comes first.
std::vector<Trio> triosOf(const Graded& graded);

/// Where the three squares are in a picture, pixels.
struct Places {
    std::array<int, 3> left{};
    int top = 0, size = 0;
    bool operator==(const Places&) const = default;
};
/// As large as they can be in a window between `above` and `below`, pixels, but never hardly visible.
Places placesIn(int width, int height, int above, int below);

/// The three at their places on a plain ground; null: the ground alone. What is missing is a crossed square.
image::Frame drawn(const Trio* trio, int width, int height, const Places& places, bool light);

/// The three as they are, beside each other, for a file.
image::Frame pictureOf(const Trio& trio);
/// pictureOf() as a PNG (or what the name asks for), with what it shows in its metadata. Throws image::Error.
void writePicture(const std::string& file, const Trio& trio, const Report& report);

}  // namespace grader
