// What `grade` and `check` have in common on their command lines.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/grading/grader.hpp"

namespace grader {

/// "it", "en", or empty: the locale's.
Language languageOf(const std::string& text);
/// "bubblewrap", ..., or empty: none asked for.
std::optional<Walls> wallsOf(const std::string& text);
/// Points and checks of a report in a few lines for a terminal.
std::string summary(const Report& report);
/// writeReport in place of a folder that an earlier one made. Throws UsageError if the folder holds something else.
void replaceReport(const Graded& graded, const std::filesystem::path& folder, const std::string& formats);

}  // namespace grader
