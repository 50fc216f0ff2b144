// Row G16: a light close to a sphere of few triangles.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/rows.hpp"

namespace stability {

/// A light at 1.05 radii of a sphere of 32 segments, whose brightest point is 255 codes: the frame against the true sphere (at
/// most 41 codes), the shading of each pixel against the reference at the same point and normal (16 u S).
void nearSphere(Outcome& outcome);

}  // namespace stability
