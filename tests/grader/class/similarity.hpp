// Submissions that render from the same source: told to the instructor, never judged.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/class/result.hpp"

namespace grader {

/// Fills Report::similar of all. Files equal byte for byte, or but for comments and blanks, and wrong frames that are equal to the last bit
/// count; what equals the lab's solution or starter does not (short steps leave little choice).
void findSimilar(std::vector<Result>& results, Language language);

}  // namespace grader
