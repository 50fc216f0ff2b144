// Numbers about a class, gathered once. Internal to tests/grader/report.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/formats/html_parts.hpp"

#include <map>

namespace grader {

/// How one check went over the class.
struct CheckCount {
    std::string id, title;
    std::array<std::size_t, 4> with{};  ///< how many, by CheckStatus
    std::size_t all() const { return with[0] + with[1] + with[2] + with[3]; }
};

/// A misconception, and whose work it explains.
struct MisconceptionCount {
    std::string ids, name;
    std::vector<std::string> submissions;  ///< sorted, none twice
};

struct ClassNumbers {
    std::vector<double> shares;  ///< scores over what can be reached, of the graded, sorted
    std::vector<CheckCount> checks;  ///< in the reports' order
    std::vector<MisconceptionCount> misconceptions;  ///< commonest first
    double compileSeconds = 0, framesSeconds = 0, judgeSeconds = 0;
};

ClassNumbers count(const std::vector<const ClassMember*>& members);

/// Scores in ten columns, as SVG.
std::string histogram(Language language, const std::vector<double>& shares);
/// A row of four colours for each check, with the numbers.
std::string checkBars(Language language, const std::vector<CheckCount>& checks);

}  // namespace grader
