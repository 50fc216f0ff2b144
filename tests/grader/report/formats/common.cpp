// Sentences that every gradebook gets, and the pictures' bytes.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/common.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace grader {

bool isShown(const Check& check) { return check.visibility == "visible"; }

std::size_t hiddenChecks(const Report& report) {
    const auto hidden = [](const Check& check) { return !isShown(check); };
    return static_cast<std::size_t>(std::count_if(report.checks.begin(), report.checks.end(), hidden));
}

std::string hiddenSentence(const Report& report) {
    const std::size_t count = hiddenChecks(report);
    if (count == 0)
        return "";
    if (count == 1)
        return say(report.language, "One more check is not shown here.",
                   "Un altro controllo non è mostrato qui.");
    return std::to_string(count) + say(report.language, " more checks are not shown here.",
                                       " altri controlli non sono mostrati qui.");
}

const char* statusName(ReportStatus status) {
    switch (status) {
    case ReportStatus::graded:
        return "graded";
    case ReportStatus::notGradable:
        return "not_gradable";
    case ReportStatus::infrastructure:
        break;
    }
    return "infrastructure";
}

const char* signFor(CheckStatus status) {
    switch (status) {
    case CheckStatus::pass:
        return "✓";
    case CheckStatus::partial:
        return "◐";
    case CheckStatus::fail:
        return "✗";
    case CheckStatus::skipped:
        break;
    }
    return "–";
}

double fraction(const Report& report) {
    const double share = report.maxScore > 0 ? report.score / report.maxScore : 0;
    return share >= 0 ? std::min(share, 1.0) : 0;  // NaN becomes 0
}

std::string headline(const Report& report) {
    const Language language = report.language;
    const std::string reason = report.reason.empty() ? "" : " (" + oneLine(report.reason) + ")";
    if (report.status == ReportStatus::infrastructure)
        return say(language,
                   "No marks: the grader had trouble of its own. This says nothing about your program; it "
                   "will be graded again.",
                   "Nessun voto: il correttore ha avuto un problema suo. Non dice nulla del tuo programma, "
                   "che sarà corretto di nuovo.") +
               reason;
    if (report.status == ReportStatus::notGradable)
        return say(language,
                   "No marks: nothing in this submission could be judged. It should not count as an attempt.",
                   "Nessun voto: in questa consegna non c'era nulla da giudicare. Non dovrebbe contare come "
                   "tentativo.") +
               reason;
    return points(report.score) + say(language, " of ", " su ") + points(report.maxScore) +
           say(language, " points.", " punti.");
}

std::string slidesToReread(Language language, const std::vector<int>& slides) {
    std::string text;
    for (const int slide : slides)
        text += (text.empty() ? "" : ", ") + std::to_string(slide);
    if (slides.empty())
        return "";
    return (slides.size() == 1 ? "Slide " : say(language, "Slides ", "Slide ")) + text;
}

std::vector<std::string> feedbackLines(const Report& report, const Check& check) {
    const Language language = report.language;
    std::vector<std::string> lines;
    const auto add = [&](const char* label, const std::string& text) {
        if (!text.empty())
            lines.push_back((*label ? label + std::string(": ") : "") + oneLine(text));
    };
    add("", check.message);
    add(say(language, "Expected", "Atteso"), check.expected);
    add(say(language, "Next step", "Prossimo passo"), check.hint);
    if (const auto& why = check.explanation) {
        add(say(language, "This looks like", "Sembra questo"),
            why->name + " (" + percent(why->explained) +
                say(language, " of the wrong pixels)", " dei pixel sbagliati)"));
        add(say(language, "To think about", "Da pensare"), why->hint);
        add(say(language, "Elsewhere", "Altrove"), why->convention);
    }
    if (const auto& worst = check.worst) {
        add(say(language, "Worst pixel", "Pixel peggiore"),
            worst->frame + ", x " + std::to_string(worst->x) + ", y " + std::to_string(worst->y) + ", " +
                regionName(language, worst->region) + say(language, ": found ", ": trovato ") +
                colorText(worst->found) + say(language, ", expected ", ", atteso ") +
                colorText(worst->expected));
        if (!worst->numbers.empty())
            lines.push_back(worst->ownScene ? say(language, "There, your scene has:", "Lì la tua scena ha:")
                                            : say(language, "There, it should be:", "Lì dovrebbe essere:"));
        for (const TermNumber& term : worst->numbers)
            lines.push_back("    " + oneLine(term.symbol) + " = " + oneLine(term.value));
    }
    for (const RegionShare& region : check.regions)
        lines.push_back("    " + regionName(language, region.name) + ": " + percent(region.right) +
                        say(language, " right", " giusto"));
    if (check.status != CheckStatus::pass)
        add(say(language, "To reread", "Da rileggere"), slidesToReread(language, check.slides));
    return lines;
}

const ReportImage* findImage(const Report& report, const std::string& id) {
    const auto found = std::find_if(report.images.begin(), report.images.end(),
                                    [&](const ReportImage& image) { return image.id == id; });
    return found == report.images.end() ? nullptr : &*found;
}

std::string pngBytes(const ReportImage& image, const std::filesystem::path& folder) {
    const std::filesystem::path name = image.file;
    const std::filesystem::path path = folder / name;
    std::error_code error;
    if (name.empty() || name.filename() != name || !std::filesystem::is_regular_file(path, error))
        return "";
    std::ifstream stream(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return bytes.starts_with("\x89PNG\r\n\x1A\n") ? bytes : "";
}

std::string dataUrl(const std::string& png) { return "data:image/png;base64," + base64(png); }

}  // namespace grader
