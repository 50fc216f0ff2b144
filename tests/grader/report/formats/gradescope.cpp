// Gradescope's results.json. It takes pictures only as <img> in HTML and may drop them, so the text stands alone.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/rich_text.hpp"

#include <nlohmann/json.hpp>

namespace grader {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longestLog = 20000;

Json testOf(const Report& report, const Check& check, const std::filesystem::path& folder) {
    const auto source = [&](const ReportImage& image) {
        const std::string png = pngBytes(image, folder);
        return png.empty() ? std::string() : dataUrl(png);
    };
    Json test = {{"name", oneLine(check.title)},
                 {"name_format", "text"},
                 {"score", check.score},
                 {"max_score", check.maxScore}};
    if (check.status == CheckStatus::pass)
        test["status"] = "passed";
    else if (check.status != CheckStatus::partial)  // in part: its score gives the colour
        test["status"] = "failed";
    test["tags"] = {oneLine(check.id)};
    test["output_format"] = "html";
    test["output"] = "<p><b>" + escaped(signFor(check.status)) + " " +
                     wordFor(report.language, check.status) + "</b></p>" + richText(report, check, source);
    test["visibility"] = check.visibility;
    return test;
}

// A test without a score is shown for information.
void addLog(Json& tests, const char* name, const std::string& text) {
    if (!text.empty())
        tests.push_back(
            {{"name", name}, {"output", shortened(harmless(text), longestLog)}, {"output_format", "text"}});
}

}  // namespace

std::string gradescope(const Report& report, const std::filesystem::path& folder) {
    Json json = {{"output", headline(report)},
                 {"output_format", "text"},
                 {"stdout_visibility", "hidden"},
                 {"execution_time", report.compileSeconds + report.framesSeconds + report.judgeSeconds},
                 {"tests", Json::array()}};
    // Without any score Gradescope takes the run as failed and keeps no mark: there is no other way to say so.
    if (report.status == ReportStatus::graded) {
        json["score"] = report.score;
        for (const Check& check : report.checks)
            json["tests"].push_back(testOf(report, check, folder));
        addLog(json["tests"],
               say(report.language, "What the compiler said", "Che cosa ha detto il compilatore"),
               report.buildLog);
        addLog(json["tests"], say(report.language, "What the program said", "Che cosa ha detto il programma"),
               report.said);
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader
