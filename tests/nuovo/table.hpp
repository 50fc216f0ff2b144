// The table of lessons, their slides and their new lines, in Markdown.
// SPDX-License-Identifier: MIT
#pragma once

#include "input.hpp"

#include <iosfwd>
#include <string>

namespace nuovo {

/// Prints one row per lesson of the chain, then each step's new lines under the slide they cite.
/// `lang` is "it" or "en".
void printTable(const LessonSet& lessons, const Slides& slides, const std::string& lang, std::ostream& out);

}  // namespace nuovo
