// Autolab reads the last line of stdout. What others wrote stands indented, so that no line of theirs can be that one.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/common.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

namespace grader {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longestLog = 20000;

void addLog(std::string& text, const char* title, const std::string& log) {
    if (log.empty())
        return;
    text += std::string("\n") + title + "\n";
    std::istringstream lines(shortened(harmless(log), longestLog));
    for (std::string line; std::getline(lines, line);)
        text += "  | " + line + "\n";
}

std::string checksAsText(const Report& report) {
    std::string text;
    for (const Check& check : report.checks) {
        if (!isShown(check))
            continue;
        text += std::string("\n") + signFor(check.status) + " " + oneLine(check.title) + ": " +
                wordFor(report.language, check.status) + ", " + points(check.score) + " / " +
                points(check.maxScore) + "\n";
        for (const std::string& line : feedbackLines(report, check))
            text += "    " + line + "\n";
    }
    return text;
}

// The optional line before the last: a table of what passed.
Json semantic(const Report& report) {
    Json build = Json::object();
    Json test = Json::object();
    for (const Check& check : report.checks) {
        if (!isShown(check))
            continue;
        Json entry = {{"passed", check.status == CheckStatus::pass}};
        if (check.status != CheckStatus::pass)
            entry["hint"] = oneLine(check.hint.empty() ? check.message : check.hint);
        (check.id == "builds" ? build : test)[oneLine(check.title)] = entry;
    }
    return {{"_presentation", "semantic"}, {"stages", {"Build", "Test"}}, {"Build", build}, {"Test", test}};
}

std::string line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string autolab(const Report& report) {
    std::string text = headline(report) + "\n";
    if (report.status != ReportStatus::graded)
        return text +
               line({{"scores", Json::object()}});  // Autolab says that there are none, and keeps no mark
    text += checksAsText(report);
    if (const std::string hidden = hiddenSentence(report); !hidden.empty())
        text += "\n" + hidden + "\n";
    addLog(text, say(report.language, "What the compiler said", "Che cosa ha detto il compilatore"),
           report.buildLog);
    addLog(text, say(report.language, "What the program said", "Che cosa ha detto il programma"),
           report.said);
    Json scores = Json::object();  // the course's problems have the checks' ids as names
    for (const Check& check : report.checks)
        scores[oneLine(check.id)] = check.score;
    return text + line(semantic(report)) + line({{"scores", scores}});
}

}  // namespace grader
