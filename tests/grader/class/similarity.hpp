// Submissions that render from the same source: told to the instructor, never judged.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/class/result.hpp"

namespace grader {

/// Fills Report::similar of all, and only in memory: no student's page says it. What counts: a file equal byte for byte; one equal but for
/// comments and blanks, where enough of it is the student's own (Graded::sources); wrong frames equal to the last bit that no named
/// misconception explains and that at most four share. What equals the lab's solution or starter never counts, and neither do right
/// short solutions: short steps leave little choice.
void findSimilar(std::vector<Result>& results, Language language);

}  // namespace grader
