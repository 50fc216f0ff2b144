// How much two frames differ, in numbers and as a picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace image {

// Differences are absolute and on the scale where 1 is a screen's white, 1/255 one 8-bit code; between two
// frames of codes they are exact multiples of 1/255. Where either value is NaN, or just one is infinite, the
// difference is infinite, so that no bound can be met by it; equal infinities do not differ.
struct Difference {
    std::array<double, 3> maximum = {};  // per channel R, G, B
    double worst = 0;  // largest of maximum
    double mean = 0;  // over all compared values
    double rms = 0;  // root of the mean square, over all compared values
    double psnr = 0;  // dB against a peak of 1: infinite for equal frames, minus infinite if rms is infinite
    std::size_t pixels = 0;  // how many were compared
    std::size_t above = 0;  // pixels with a channel that differs by more than the threshold
    std::size_t nonfinite = 0;  // pixels with a NaN or infinite value in either frame

    // The first pixel, from the top row, that has the worst difference, and its values R, G, B in both
    // frames.
    int x = 0;
    int y = 0;
    std::array<double, 3> expected = {};
    std::array<double, 3> found = {};
};

// Compares the pixels whose mask entry is not 0; an empty mask compares all. threshold is what `above` counts
// from. Throws Error if sizes differ, the mask is neither empty nor one byte a pixel, or it leaves nothing to
// compare.
Difference compare(const Frame& expected, const Frame& found, double threshold = 0,
                   std::span<const std::uint8_t> mask = {});

// Writes expected, found and gain times their absolute difference side by side, in any format of write(). In
// this picture a pixel that is not finite is magenta. Throws Error as compare() and write() do.
void writeDifferencePicture(const std::string& path, const Frame& expected, const Frame& found, float gain);

}  // namespace image
