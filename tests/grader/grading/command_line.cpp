// Command lines and terminals.
// SPDX-License-Identifier: MIT
#include "grader/grading/command_line.hpp"

#include "grader/grading/scratch.hpp"
#include "grader/report/formats/formats.hpp"
#include "lab/options.hpp"

#include <algorithm>
#include <set>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t wordWidth = 10;  // "non ancora"

// Whether a folder holds a report and nothing else, so that it may go.
bool isReport(const fs::path& folder) {
    std::set<std::string> names{"report.json"};
    for (const Format one : allFormats())
        names.insert(fileNameOf(one));
    if (!fs::is_regular_file(folder / "report.json"))
        return false;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool picture =
            name.ends_with(".png") && (name.starts_with("lesson-") || name.starts_with("terms-"));
        if (!entry.is_regular_file() || (!picture && names.count(name) == 0))
            return false;
    }
    return true;
}

}  // namespace

Language languageOf(const std::string& text) {
    const bool it = text.empty() ? lab::languageOfLocale() == lab::Language::it : text == "it";
    return it ? Language::it : Language::en;
}

std::optional<Walls> wallsOf(const std::string& text) {
    for (const Walls walls : {Walls::bubblewrap, Walls::landlock, Walls::limits})
        if (text == name(walls))
            return walls;
    return std::nullopt;
}

std::string summary(const Report& report) {
    const bool it = report.language == Language::it;
    std::string text;
    for (const Check& check : report.checks) {
        std::string word = wordFor(report.language, check.status);
        word.resize(std::max(word.size(), wordWidth), ' ');
        text += word + "  " + check.id + "  " + check.title;
        if (check.maxScore > 0)
            text += "  " + points(check.score) + "/" + points(check.maxScore);
        if (check.status != CheckStatus::pass)
            text += "\n          " + check.message + (check.hint.empty() ? "" : "\n          " + check.hint);
        text += "\n";
    }
    if (report.status == ReportStatus::graded)
        text += std::string(it ? "punti " : "points ") + points(report.score) + "/" +
                points(report.maxScore) + "\n";
    else
        text += report.reason + "\n";
    return harmless(text);
}

void replaceReport(const Graded& graded, const fs::path& folder, const std::string& formats) {
    const fs::path clean = (folder / "").parent_path();
    if (fs::exists(clean) && !fs::is_empty(clean)) {
        if (!isReport(clean))
            throw UsageError(clean.string() + ": holds something that is no report; expected a new folder, "
                                              "an empty one, or an earlier report");
    }
    sweep(clean.has_parent_path() ? clean.parent_path() : fs::path("."));
    writeReport(graded, clean, formats);
}

}  // namespace grader
