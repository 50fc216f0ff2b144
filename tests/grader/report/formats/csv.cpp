// Marks as CSV (RFC 4180), with nothing in it that a spreadsheet would evaluate.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/common.hpp"

#include <algorithm>

namespace grader {

namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

// A cell with others' text. What would be a formula gets an apostrophe, which makes it text.
std::string cell(const std::string& text) {
    const std::string line = oneLine(text);
    const std::size_t first = line.find_first_not_of(' ');
    const bool formula =
        first != std::string::npos && std::string("=+-@").find(line[first]) != std::string::npos;
    const bool tab = !text.empty() && (text[0] == '\t' || text[0] == '\r');
    return quoted(formula || tab ? "'" + line : line);
}

std::string rowOf(const Report& report, const std::vector<std::string>& ids) {
    const bool graded = report.status == ReportStatus::graded;
    std::string row = cell(report.submission) + "," + cell(report.lesson) + "," + statusName(report.status) +
                      "," + (graded ? number(report.score) : "") + "," + number(report.maxScore);
    for (const std::string& id : ids) {
        const auto check = std::find_if(report.checks.begin(), report.checks.end(),
                                        [&](const Check& each) { return each.id == id; });
        row += "," + (graded && check != report.checks.end() ? number(check->score) : "");
    }
    return row + "\r\n";
}

}  // namespace

std::string marksCsv(const std::vector<Report>& reports) {
    std::vector<const Report*> sorted;
    for (const Report& report : reports)
        sorted.push_back(&report);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Report* a, const Report* b) { return a->submission < b->submission; });
    std::vector<std::string> ids;
    for (const Report* report : sorted)
        for (const Check& check : report->checks)
            if (std::find(ids.begin(), ids.end(), check.id) == ids.end())
                ids.push_back(check.id);
    std::string text = "submission,lesson,status,score,max_score";
    for (const std::string& id : ids)
        text += "," + cell(id);
    text += "\r\n";
    for (const Report* report : sorted)
        text += rowOf(*report, ids);
    return text;
}

std::string csv(const Report& report) { return marksCsv({report}); }

}  // namespace grader
