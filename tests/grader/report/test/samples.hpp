// Reports for tests: what a class hands in, from full marks to hostile names, with the pictures they refer to.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/report.hpp"

namespace grader::samples {

/// Everything right.
Report fullMarks();
/// Two checks wrong; two misconceptions that no picture can tell apart explain one of them. With pictures, in Italian if asked.
Report partialMarks(Language language = Language::en);
/// The compiler's errors, and every other check skipped.
Report doesNotBuild();
/// The grader's own trouble.
Report infrastructure();
/// A broken zip.
Report notGradable();
/// Every text holds what breaks HTML, XML, JSON, CSV, terminals and the gradebooks' tags.
Report hostile();

/// All of the above.
std::vector<Report> all();

/// all(), and as many as a class has, with all kinds of scores.
std::vector<Report> aClass();

/// Writes the pictures that `report` refers to into `folder`, side pixels high and wide.
void writeImages(const Report& report, const std::filesystem::path& folder, int side = 192);

/// An empty folder of this name for a test's files.
std::filesystem::path folderFor(const std::string& name);

}  // namespace grader::samples
