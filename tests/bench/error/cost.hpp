// What the methods cost: processor time, in turns, counted from the flat-colour frame.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/error/methods.hpp"

#include <functional>
#include <vector>

namespace bench::error {

/// A method to time and what its cost is counted from.
struct Timed {
    Drawer* frame;
    Drawer* floor;  ///< several may share one: it is drawn once a round
};

/// What came out, in milliseconds of the whole process's processor time.
struct Cost {
    double frame = 0;  ///< median of the whole frame
    double lighting = 0;  ///< median of the frame less the floor of the same round
    double spread = 0;  ///< half of what lies between the quartiles of `lighting`
    double overFloor = 0;  ///< median of the frame divided by the floor of the same round
    int rounds = 0;  ///< how often it was drawn
};

/// Draws all in turns, some frames without counting first, until `milliseconds` of processor time are spent, but at least three times
/// each. What is many times as slow as the others has fewer turns.
std::vector<Cost> measure(const std::vector<Timed>& timed, double milliseconds);

}  // namespace bench::error
