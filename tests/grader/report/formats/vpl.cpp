// Lines for Moodle's VPL: comments in a block, then the grade. Its tags are defaced in all other text.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/common.hpp"

#include <sstream>

namespace grader {

namespace {

constexpr std::size_t longestLog = 20000;

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

std::string defaced(std::string text) {
    replaceAll(text, ":=>>", ":=> >");
    replaceAll(text, "<|--", "<| --");
    replaceAll(text, "--|>", "-- |>");
    return text;
}

// In a block a line with "-" in front is a title, one with ">" is text as it is.
std::string title(const std::string& text) { return "-" + defaced(oneLine(text)) + "\n"; }

std::string asItIs(const std::string& text) {
    std::string result;
    std::istringstream lines(shortened(harmless(text), longestLog));
    for (std::string line; std::getline(lines, line);)
        result += ">" + defaced(line) + "\n";
    return result;
}

}  // namespace

std::string vpl(const Report& report) {
    const Language language = report.language;
    std::string text = "<|--\n" + title(headline(report));
    if (report.status != ReportStatus::graded)  // without a Grade line VPL proposes none
        return text + "--|>\n";
    for (const Check& check : report.checks) {
        if (!isShown(check))
            continue;
        text += title(std::string(signFor(check.status)) + " " + check.title + ": " +
                      wordFor(language, check.status) + ", " + points(check.score) + " / " +
                      points(check.maxScore));
        for (const std::string& line : feedbackLines(report, check))
            text += asItIs(line);
    }
    if (const std::string hidden = hiddenSentence(report); !hidden.empty())
        text += title(hidden);
    if (!report.buildLog.empty())
        text += title(say(language, "What the compiler said", "Che cosa ha detto il compilatore")) +
                asItIs(report.buildLog);
    if (!report.said.empty())
        text += title(say(language, "What the program said", "Che cosa ha detto il programma")) +
                asItIs(report.said);
    return text + "--|>\nGrade :=>> " + number(report.score) +
           "\n";  // the activity's maximum is the report's
}

}  // namespace grader
