// A rendered frame in memory, in floats or in 8-bit codes, and the facts that travel with it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace image {

// Everything that goes wrong with a picture. what() says where, what was expected and found, and what to do
// next.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

using Floats = std::vector<float>;  // linear, not clamped: 1 is the brightest that a screen shows (slide 39)
using Bytes = std::vector<std::uint8_t>;  // the codes that an 8-bit target held: code / 255 is the value

struct Frame {
    int width = 0;  // pixels, at least 1
    int height = 0;  // pixels, at least 1
    // R, G, B of each pixel, left to right, top row first: width * height * 3 numbers, without padding.
    std::variant<Floats, Bytes> pixels;
};

// Ordered pairs of a key (lesson, terms, renderer, version) and its value in UTF-8. A key is 1 to 79 of the
// characters A-Z a-z 0-9 _ - . and a value holds no NUL: that is what every format can keep.
using Metadata = std::vector<std::pair<std::string, std::string>>;

// Throws Error unless both sizes are at least 1 and pixels holds width * height * 3 numbers.
void check(const Frame& frame);

// The frame's values as floats; a code c becomes the float nearest to c / 255.
Floats toFloats(const Frame& frame);

// The frame's codes; a float is clamped to [0,1] and 255 times it, in float, rounded, halves to even, as drivers do. A NaN throws
// Error, which names the first such pixel; infinities clamp as other numbers do.
Bytes toBytes(const Frame& frame);

// "R", "G" or "B", for messages; channel is 0, 1 or 2.
const char* channelName(std::size_t channel);

}  // namespace image
