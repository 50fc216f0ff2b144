// Checks of frames and conversions between their two kinds of pixels.
// SPDX-License-Identifier: MIT
#include "image/frame.hpp"

#include <algorithm>
#include <cmath>

namespace image {

namespace {

[[noreturn]] void refuseNan(const Frame& frame, std::size_t index) {
    const std::size_t pixel = index / 3;
    const auto width = static_cast<std::size_t>(frame.width);
    throw Error("pixel (" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) +
                ") is NaN in " + channelName(index % 3) +
                "; expected numbers, 8 bits cannot hold NaN; write an .exr to see which pixels are NaN");
}

}  // namespace

const char* channelName(std::size_t channel) {
    const char* const names[] = {"R", "G", "B"};
    return names[channel];
}

void check(const Frame& frame) {
    const std::size_t found = std::visit([](const auto& pixels) { return pixels.size(); }, frame.pixels);
    const std::string size = std::to_string(frame.width) + "x" + std::to_string(frame.height);
    if (frame.width < 1 || frame.height < 1) {
        throw Error("the frame is " + size + "; expected at least 1x1; render it before writing it");
    }
    const std::size_t expected =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height) * 3;
    if (found != expected) {
        throw Error("the frame is " + size + " but holds " + std::to_string(found) + " numbers; expected " +
                    std::to_string(expected) + ", 3 a pixel; fill Frame::pixels before writing it");
    }
}

Floats toFloats(const Frame& frame) {
    if (const auto* floats = std::get_if<Floats>(&frame.pixels)) {
        return *floats;
    }
    const Bytes& codes = std::get<Bytes>(frame.pixels);
    Floats floats(codes.size());
    std::transform(codes.begin(), codes.end(), floats.begin(),
                   [](std::uint8_t code) { return static_cast<float>(code) / 255.0F; });
    return floats;
}

Bytes toBytes(const Frame& frame) {
    if (const auto* codes = std::get_if<Bytes>(&frame.pixels)) {
        return *codes;
    }
    const Floats& floats = std::get<Floats>(frame.pixels);
    Bytes codes(floats.size());
    for (std::size_t i = 0; i < floats.size(); ++i) {
        if (std::isnan(floats[i])) {
            refuseNan(frame, i);
        }
        // In float, halves to even: as graphics drivers do, so that a value has the same code wherever it comes from.
        codes[i] = static_cast<std::uint8_t>(std::nearbyint(std::clamp(floats[i], 0.0F, 1.0F) * 255.0F));
    }
    return codes;
}

}  // namespace image
