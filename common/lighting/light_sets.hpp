// Which lights each draw's sum has, and where its shader has their numbers from.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

namespace lighting {

/// Sorts the plan's lights, gives each lit draw those that reach it, and completes its variant: light counts, storage, and the
/// terms without those that cannot matter. What is left out stands in plan.skipped.
void distributeLights(FramePlan& plan, const Settings& settings, bool hasAmbient);

}  // namespace lighting
