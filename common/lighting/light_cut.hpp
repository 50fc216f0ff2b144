// --light-cut: the one skip that is not exact, with a bound on what every pixel may lack.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

namespace lighting {

/// Gives each light the reach beyond which it adds less than its share of settings.lightCut, and drops lights that add less
/// than that everywhere (plan.cutCodes counts these). Together they take no more than settings.lightCut from any channel of any
/// pixel, in 8-bit codes before rounding. Does nothing where the cut is 0, or where nothing is to be skipped.
///
/// The bound: a light of color L adds at most (D + K) L / d^k at distance d, D the largest albedo in the frame and K the
/// strongest highlight; cosines, powers and windows are at most 1.
void cutLights(FramePlan& plan, const Settings& settings);

}  // namespace lighting
