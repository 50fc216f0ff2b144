// What `check` says of a submission, in a terminal and in its window.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/grading/grader.hpp"
#include "lab/panel.hpp"

namespace grader {

/// Whether there is nothing left to do.
bool allRight(const Report& report);
/// In one line: "all right ...", "not right yet", why nothing could be judged.
std::string verdictOf(const Report& report);
/// Everything, for a terminal: summary(), what compiler or program say, the legend of the difference, the verdict.
std::string textOf(const Graded& graded);
/// What matters first, for a window, broken into lines of so many letters; where these are more than `most`, with less detail.
std::vector<lab::Line> linesOf(const Graded& graded, std::size_t letters, std::size_t most);
/// Lines of so many letters, broken at blanks; those after the first begin with two more blanks than it.
std::vector<std::string> wrapped(const std::string& text, std::size_t letters);

}  // namespace grader
