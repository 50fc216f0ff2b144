// From checks to points.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/report.hpp"

namespace grader {

/// What the starter had already counts only as far as the new steps are done: nobody gets points for handing in a starter. Changes
/// the scores of one part's checks accordingly and says so in their messages.
void countOldOnlyWithNew(std::vector<Check>& checks, Language language);

/// Scales the checks so that those of a faultless submission add up to `points`, and sets the report's score and maxScore. All in hundredths
/// of a point; only who lost nothing has all of them.
void addUp(Report& report, double points);

}  // namespace grader
