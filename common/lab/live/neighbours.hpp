// Neighbours: the pictures that the next key or click may ask for, so that their shaders can be ready before.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/session.hpp"

#include <optional>

namespace lab {

/// The plan of the picture that is one step away: with a term switched, another switch, view or light. `number` counts from 0; none
/// after the last one, and none at all for scenes so large that planning would be felt. The scene is left as it was.
std::optional<lighting::FramePlan> neighbourPlan(Session& session, std::size_t number);

}  // namespace lab
