// Row C7: a scene whose coordinates are large.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/rows.hpp"

namespace stability {

/// A tilted plane 1e5, 1e7 and 1e8 from the origin, a light 3 and a camera 5 away: at most 2e-4 of a code, in
/// world and in view space.
void farAway(Outcome& outcome);

}  // namespace stability
