// Aspects of a scene in words.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/judge/scene_difference.hpp"
#include "grader/report/report.hpp"

#include <string>

namespace grader {

/// "point light 1: its exponent k is 0 here"; says what was found, never what was expected.
std::string inWords(const std::string& aspect, const Aspect& value, Language language);

}  // namespace grader
