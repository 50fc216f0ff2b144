// Judges frames of the graphics driver by the double-precision reference.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace support {

/// How far a frame is from the reference, away from edges.
struct Judgement {
    double worst = 0;  ///< largest |error| / max(S, 1/255); S is the pixel's sum with every n . w taken as 1
    double mean = 0;  ///< of the same
    int x = 0, y = 0;  ///< where `worst` is, from the top left
    int codes = 0;  ///< largest difference of the 8-bit frames
    long long judged = 0;  ///< pixels that were compared
    long long masked = 0;  ///< pixels within one pixel of an edge, which were not
    long long outside = 0;  ///< values of masked pixels more than 1 code off: told, not judged

    double maskedShare() const { return static_cast<double>(masked) / static_cast<double>(judged + masked); }
};

/// Draws the scene with the graphics driver, in floats and in 8 bits, and with Reference<double>, and compares.
/// Edges are masked by the reference's own information: see lighting/reference/reference.hpp.
Judgement judge(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options = {});

/// "worst 1.2e-6 at 3,4, mean 2e-8, 8 bit 0 codes, 4.1 % masked", for tests to print.
std::string describe(const Judgement& judgement);

/// Sets the settings' focus to `target`, as the programs do for what the camera looks at.
void lookAt(THREE::PerspectiveCamera& camera, const THREE::Vector3& target, DrawOptions& options);

}  // namespace support
