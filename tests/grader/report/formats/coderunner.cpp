// What a combinator template grader of Moodle's CodeRunner prints; it refuses fields that it does not know.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/rich_text.hpp"

#include <nlohmann/json.hpp>

namespace grader {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longestLog = 20000;

std::string folded(const char* title, const std::string& text) {
    return text.empty() ? ""
                        : "<details><summary>" + escaped(title) + "</summary><pre>" +
                              escaped(shortened(harmless(text), longestLog)) + "</pre></details>";
}

std::string epilogue(const Report& report) {
    return folded(say(report.language, "What the compiler said", "Che cosa ha detto il compilatore"),
                  report.buildLog) +
           folded(say(report.language, "What the program said", "Che cosa ha detto il programma"),
                  report.said);
}

}  // namespace

std::string coderunner(const Report& report, const std::filesystem::path& folder) {
    const Language language = report.language;
    Json json = Json::object();
    // Without a fraction CodeRunner reports a broken grader and gives no mark; showoutputonly would give full marks.
    if (report.status != ReportStatus::graded) {
        json["prologuehtml"] = "<p>" + escaped(headline(report)) + "</p>";
        return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    }
    Json files = Json::object();
    const auto source = [&](const ReportImage& image) {
        const std::string png = pngBytes(image, folder);
        if (png.empty())
            return std::string();
        files[image.file] = base64(png);
        return image.file;
    };
    json["fraction"] = fraction(report);
    json["prologuehtml"] = "<p>" + escaped(headline(report)) + "</p>";
    Json rows = Json::array();
    rows.push_back({"iscorrect", say(language, "Check", "Controllo"), say(language, "Points", "Punti"),
                    say(language, "Feedback", "Commento"), "ishidden"});
    for (const Check& check : report.checks) {
        const double share = check.maxScore > 0                  ? check.score / check.maxScore
                             : check.status == CheckStatus::pass ? 1
                                                                 : 0;
        const std::string feedback = isShown(check) ? richText(report, check, source) : "";
        rows.push_back({share, oneLine(check.title), points(check.score) + " / " + points(check.maxScore),
                        feedback, isShown(check) ? 0 : 1});
    }
    json["testresults"] = rows;
    json["columnformats"] = {"%s", "%s", "%h"};  // of the columns but iscorrect and ishidden
    json["epiloguehtml"] = epilogue(report);
    if (!files.empty())
        json["files"] = files;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader
