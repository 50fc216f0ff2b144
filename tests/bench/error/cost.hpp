// What the methods cost: processor time, in turns, counted from the flat-colour frame.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/error/methods.hpp"

#include <functional>
#include <vector>

namespace bench::error {

/// What came out, in milliseconds of the whole process's processor time.
struct Cost {
    double frame = 0;  ///< median of the whole frame
    double lighting = 0;  ///< median of the frame less the floor of the same round
    double spread = 0;  ///< half of what lies between the quartiles of `lighting`
    double overFloor = 0;  ///< median of the frame divided by the floor of the same round
    int rounds = 0;  ///< how often it was drawn
};

/// Draws all in random turns, some frames without counting first, until `milliseconds` of processor time are spent, but at least three times
/// each. What is slower than most has fewer turns. `floor` draws the flat-colour frame with the shaders, for all
/// methods alike: what a method needs beyond that is its cost, be it other passes or another renderer.
std::vector<Cost> measure(Drawer& floor, const std::vector<Drawer*>& frames, double milliseconds);

}  // namespace bench::error
