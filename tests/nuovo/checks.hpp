// The rules that make the chain of lessons a promise, and the report of what breaks them.
// SPDX-License-Identifier: MIT
#pragma once

#include "input.hpp"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace nuovo {

/// Each rule by its name in the report.
enum class Rule {
    Number,  ///< lesson_NN_name.cpp: from 00 on, no number missing, none twice
    Chain,  ///< before(lesson) is plain(previous lesson), byte for byte
    Count,  ///< lesson 00 has no NUOVO line; every later one has 1 to 20, and at most 3 PRIMA
    Slides,  ///< a cited slide and item is in slides.json and among the header's slides
    Items,  ///< a slide's code is in its lesson alone: every line, in order, nothing else tagged with it
    Comment,  ///< a run of NUOVO lines opens with a comment, save #include and a line with comment or PRIMA
    Width,  ///< at most 84 columns before the tag, so that no tool wraps a tagged line
    Tags,  ///< every mark is spelled as lesson_file.hpp says
    Place  ///< only the chain's lessons have marks
};

/// A broken rule: where, what, and how to mend it.
struct Failure {
    Rule rule = Rule::Chain;
    std::string row;  ///< the report's row: a lesson's stem or one of the two last rows
    std::filesystem::path file;
    int line = 1;  ///< in file, from 1
    std::string what;
    std::vector<std::string> expected;
    std::vector<std::string> found;
    std::string remedy;
};

/// What `check` found; `rows` holds what the report lists, each with the rules that concern it.
struct Report {
    std::vector<std::pair<std::string, std::vector<Rule>>> rows;
    std::vector<Failure> failures;
    std::string summary;  ///< how much was looked at
    bool ok() const { return failures.empty(); }
};

/// "chain", "count", ...
const char* name(Rule rule);
/// Applies every rule. Never throws: what cannot be read was refused before.
Report check(const LessonSet& lessons, const Slides& slides);
/// One line per row with ok or FAILED per rule, then the summary.
void printMatrix(const Report& report, std::ostream& out);
/// Every failure as file:line, rule, expected and found lines, and what to do.
void printFailures(const Report& report, std::ostream& out);

}  // namespace nuovo
