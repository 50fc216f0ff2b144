// What all formats say in the same way. Internal to tests/grader/report.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/formats/formats.hpp"
#include "grader/report/text.hpp"

namespace grader {

/// May the student read it now?
bool isShown(const Check& check);
/// How many are not.
std::size_t hiddenChecks(const Report& report);
/// "2 more checks are not shown here." or ""
std::string hiddenSentence(const Report& report);

/// "graded", "not_gradable", "infrastructure": as in report.json.
const char* statusName(ReportStatus status);
/// A sign that says the same without colour.
const char* signFor(CheckStatus status);

/// Score, or why there is none: one or two sentences.
std::string headline(const Report& report);
/// Score over what can be reached, 0 to 1.
double fraction(const Report& report);

/// Everything that a student is told about a check, as plain text: a line for each, harmless.
std::vector<std::string> feedbackLines(const Report& report, const Check& check);
/// "Slides 29, 30, 37", or "".
std::string slidesToReread(Language language, const std::vector<int>& slides);

/// The image of this id; null if the report has none.
const ReportImage* findImage(const Report& report, const std::string& id);
/// The bytes of a PNG of the report's folder; empty if there is no such file, it is no PNG, or its name leads elsewhere.
std::string pngBytes(const ReportImage& image, const std::filesystem::path& folder);
/// "data:image/png;base64,..." of these bytes.
std::string dataUrl(const std::string& png);

}  // namespace grader
