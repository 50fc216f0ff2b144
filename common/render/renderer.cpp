// Puts frames together.
// SPDX-License-Identifier: MIT
#include "render/renderer.hpp"

#include <algorithm>
#include <string>

namespace render {

image::Frame sideBySide(const image::Frame& left, const image::Frame& right, int column) {
    if (left.width != right.width || left.height != right.height ||
        left.pixels.index() != right.pixels.index() || column < 0 || column > left.width)
        throw image::Error("two halves of a picture are " + std::to_string(left.width) + "x" +
                           std::to_string(left.height) + " and " + std::to_string(right.width) + "x" +
                           std::to_string(right.height) + ", to be joined at column " +
                           std::to_string(column) +
                           "; expected frames of one size and kind, and a column of theirs.");
    image::Frame both = right;
    std::visit(
        [&](auto& pixels) {
            const auto& from = std::get<std::decay_t<decltype(pixels)>>(left.pixels);
            const auto row = static_cast<std::ptrdiff_t>(left.width) * 3;
            for (std::ptrdiff_t y = 0; y < left.height; ++y)
                std::copy_n(from.begin() + y * row, static_cast<std::ptrdiff_t>(column) * 3,
                            pixels.begin() + y * row);
        },
        both.pixels);
    return both;
}

}  // namespace render
