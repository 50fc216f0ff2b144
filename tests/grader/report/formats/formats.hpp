// A report in the form that a gradebook, a build server or a reader wants it in.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/report.hpp"

namespace grader {

enum class Format { gradescope, prairielearn, autolab, coderunner, vpl, junit, csv, html };

/// For the command line: "gradescope", ...
const char* nameOf(Format format);
/// What it is called beside report.json: "gradescope.json", ... Gradescope and PrairieLearn both want results.json in the end.
const char* fileNameOf(Format format);
/// All that there are.
std::vector<Format> allFormats();
/// "gradescope,junit" in that order, none twice. Throws std::runtime_error that says which name is unknown, and which are known.
std::vector<Format> parseFormats(const std::string& list);

/// The report in that form; pictures are read from `folder`, and one that is missing is left out. Whatever the texts hold, the
/// result is valid, and nobody's text is taken for ours. Without marks (ReportStatus) no form holds a score.
std::string format(const Report& report, const std::filesystem::path& folder, Format format);

// One for each, in a file of its own.
std::string gradescope(const Report& report, const std::filesystem::path& folder);
std::string prairielearn(const Report& report, const std::filesystem::path& folder);
std::string autolab(const Report& report);
std::string coderunner(const Report& report, const std::filesystem::path& folder);
std::string vpl(const Report& report);
std::string junit(const Report& report);
std::string csv(const Report& report);
std::string html(const Report& report, const std::filesystem::path& folder);

/// marks.csv of a class: a row for each submission, sorted by the bytes of their names; a column for each check, in the order in which
/// the rows mention them. No times: the same marks give the same bytes.
std::string marksCsv(const std::vector<Report>& reports);

/// A report, and where its student's page is, as a path from the overview's folder.
struct ClassMember {
    Report report;
    std::string page;
};

/// overview.html: the whole class, for the instructor only.
std::string overview(const std::vector<ClassMember>& members, Language language);

}  // namespace grader
