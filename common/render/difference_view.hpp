// Two pictures of the same size, compared: how many 8-bit codes apart each pixel is, as a colour.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

namespace render {

/// What differenceView finds. Codes are those of 8-bit pictures; of a pixel the channel counts that differs most.
struct DifferenceView {
    image::Frame frame;  ///< 8-bit codes: the colours of legend(lighting::ViewMode::difference)
    int largest = 0;  ///< codes, 0 to 255
    int x = 0,
        y = 0;  ///< where it is, from the top left: the first such pixel in reading order; 0,0 where nothing differs
    double share = 0;  ///< of the pixels that differ at all, 0 to 1
};

/// Compares as screens show them: floats are rounded to codes first. Throws image::Error if the sizes differ or a float is NaN.
DifferenceView differenceView(const image::Frame& a, const image::Frame& b);

}  // namespace render
