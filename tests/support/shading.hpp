// The error of the shading alone: the driver's pixel against the equation in long double at the driver's own interpolated
// position and normal.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw.hpp"

namespace support {

/// What came out over all pixels of all lit meshes.
struct ShadingError {
    double worst =
        0;  ///< largest |error| in units of u S, S = D (x) (sum f L + L_A), as if every cosine were 1
    double bound = 0;  ///< what design.md 7 promises for this scene, in the same units
    int x = 0, y = 0;  ///< where the worst is
    long long pixels = 0;  ///< how many were judged
};

/// Draws the scene, and its interpolated positions, normals and base colours, in float. Lights count as the floats that the
/// GPU has; what interpolation and transforms do is not in this error. Meshes must be lit and not emissive, lights without
/// `distance`; the background must be black.
ShadingError shadingError(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options);

}  // namespace support
