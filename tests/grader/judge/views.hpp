// Hidden views: cameras, times and small changes of a lesson's scene that no student has seen, from a seed.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/judge/rubric.hpp"

#include <string>
#include <vector>

namespace grader {

/// One frame that a lesson's program is asked for.
struct View {
    std::string name;  ///< in words, for reports: "view 2", "view 2, slider"; says nothing of its numbers
    const Variant* variant;  ///< of the rubric
    std::vector<std::string>
        options;  ///< of the lab's command line; not --frame, --size, --time, the lamp's state
    double time = 0;  ///< for --time, seconds
};

/// The rubric's views, each in all variants; the same for the same seed everywhere. The rubric must outlive them.
std::vector<View> hiddenViews(const Rubric& rubric, std::uint64_t seed, bool italian);
/// The one that students may see: the lesson's own camera, its start, nothing moved.
std::vector<View> publicViews(const Rubric& rubric, bool italian);

/// The options of a view with its lamp, whose state file is to be found as `lampFile`.
std::vector<std::string> optionsOf(const View& view, const std::string& lampFile);
/// A state file (--state) that adds one directional light to a lesson's scene.
std::string lampState(const std::string& lesson, int size);

}  // namespace grader
