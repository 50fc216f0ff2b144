// What a rubric's views fail to show: nobody could be told right from wrong by it.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/judge/expected.hpp"
#include "grader/judge/rubric.hpp"

#include <string>
#include <vector>

namespace grader {

/// The meshes and lights that a new step asks for, and that could be left out without any frame being the worse for it, as
/// "directional[0] of step 36.3". `frames`: those of all views of the rubric, of the lesson's own scene.
std::vector<std::string> unseen(const Rubric& rubric, const std::vector<ExpectedFrame>& frames);

}  // namespace grader
