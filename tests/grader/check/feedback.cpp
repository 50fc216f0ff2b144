// Feedback in words: what is wrong comes first, and never by its colour alone.
// SPDX-License-Identifier: MIT
#include "grader/check/feedback.hpp"

#include "grader/grading/command_line.hpp"
#include "grader/judge/evidence.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace grader {

namespace {

constexpr std::size_t mostChecks = 3;  // in a window: the rest waits until these are right
constexpr std::size_t lettersInTerminal = 100;
constexpr std::size_t linesInWindow = 6, linesInTerminal = 20;  // of the compiler

std::vector<std::string> linesIn(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> some(std::vector<std::string> lines, std::size_t most) {
    if (lines.size() > most) {
        lines.resize(most);
        lines.emplace_back("...");
    }
    return lines;
}

bool isGate(const Check& check) { return check.id == "builds" || check.id == "runs" || check.id == "draws"; }

bool failed(const Report& report, const std::string& id) {
    return std::any_of(report.checks.begin(), report.checks.end(), [&](const Check& check) {
        return check.id == id && check.status == CheckStatus::fail;
    });
}

// Of the compiler from the first error on, where it does not build; of the program or its shaders, where it does not draw.
std::vector<std::string> diagnosis(const Report& report) {
    const auto fromError = [](std::vector<std::string> lines) {
        const auto first = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
            return line.find("error:") != std::string::npos;
        });
        if (first != lines.end())
            lines.erase(lines.begin(), first);
        return lines;
    };
    if (failed(report, "builds"))
        return fromError(linesIn(report.buildLog));
    if (failed(report, "runs") || failed(report, "draws"))
        return fromError(linesIn(report.said));
    return {};
}

// As far as a line of a terminal goes.
void append(std::string& list, const char* between, const std::string& word) {
    constexpr std::size_t most = 40;
    if (list.size() < most)
        list += between + word;
    else if (!list.ends_with(" ..."))
        list += " ...";
}

// Where no frame came back, checks that have not passed for one and the same reason are told as one.
Report merged(Report report) {
    if (!failed(report, "builds") && !failed(report, "runs") && !failed(report, "draws"))
        return report;
    std::vector<Check> checks;
    for (Check& check : report.checks) {
        Check* const last = checks.empty() ? nullptr : &checks.back();
        if (last == nullptr || check.status == CheckStatus::pass || last->status != check.status ||
            last->message != check.message || last->hint != check.hint || last->explanation) {
            checks.push_back(std::move(check));
            continue;
        }
        append(last->id, ", ", check.id);
        append(last->title, "; ", check.title);
        last->slides.clear();
        last->expected.clear();
        last->score += check.score;
        last->maxScore += check.maxScore;
    }
    report.checks = std::move(checks);
    return report;
}

std::string slidesOf(const Check& check) {
    std::string text;
    for (const int slide : check.slides)
        text += (text.empty() ? " (slide " : ", ") + std::to_string(slide);
    return text.empty() ? "" : text + ")";
}

std::vector<std::string> worstOf(const WorstPixel& worst, Language language) {
    std::vector<std::string> lines{"pixel " + std::to_string(worst.x) + "," + std::to_string(worst.y) + " (" +
                                   regionName(language, worst.region) +
                                   "): " + say(language, "yours ", "il tuo ") + colorText(worst.found) +
                                   say(language, ", expected ", ", atteso ") + colorText(worst.expected)};
    std::string numbers;
    for (const TermNumber& number : worst.numbers)
        numbers += (numbers.empty() ? "" : ",  ") + number.symbol + " = " + number.value;
    if (!numbers.empty())
        lines.push_back((worst.ownScene ? say(language, "there your scene has ", "lì la tua scena ha ")
                                        : say(language, "there it should be ", "lì dovrebbe essere ")) +
                        numbers);
    return lines;
}

// The lines of a window.
class Page {
  public:
    explicit Page(std::size_t letters) : letters_(letters) {}
    void add(const std::string& text, lab::Tone tone = lab::Tone::plain) {
        for (std::string& line : wrapped(harmless(text), letters_))
            lines_.push_back({{std::move(line), tone}});
    }
    void addWrong(const Check& check, Language language) {
        const bool partly = check.status == CheckStatus::partial;
        add(std::string(partly ? "\u2248 " : "\u2717 ") +
                (partly ? say(language, "in part: ", "in parte: ") : "") + check.title + slidesOf(check),
            lab::Tone::wrong);
        add("    " + check.message);
        if (check.explanation && check.message.find(check.explanation->name) == std::string::npos)
            add("    " + std::string(say(language, "It looks like this: ", "Sembra questo: ")) +
                check.explanation->name);
        if (!check.expected.empty())
            add("    " + std::string(say(language, "To be seen: ", "Da vedere: ")) + check.expected);
        if (!check.hint.empty() && check.hint != hint_)
            add("    " + check.hint, lab::Tone::idle);
        hint_ = check.hint;
    }
    // Without the compiler's excerpts, which need letters of one width.
    void addSaid(const Report& report) {
        std::vector<std::string> said = diagnosis(report);
        said.erase(std::remove_if(said.begin(), said.end(),
                                  [](const std::string& line) { return line.empty() || line[0] == ' '; }),
                   said.end());
        for (const std::string& line : some(std::move(said), linesInWindow))
            add("    " + line);
    }
    void addNames(const char* mark, const Report& report, CheckStatus status) {
        std::string names;
        for (const Check& check : report.checks)
            if (check.status == status)
                names += (names.empty() ? mark : "; ") + check.title;
        if (!names.empty())
            add(names, lab::Tone::idle);
    }
    std::vector<lab::Line> take() { return std::move(lines_); }

  private:
    std::size_t letters_;
    std::string hint_;  // the last one: many checks have the same
    std::vector<lab::Line> lines_;
};

enum class Detail { all, noNumbers, firstCheck };

std::vector<lab::Line> pageOf(const Graded& graded, std::size_t letters, Detail detail) {
    const Report report = merged(graded.report);
    const bool right = allRight(report);
    const std::size_t most = detail == Detail::firstCheck ? 1 : mostChecks;
    Page page(letters);
    page.add((right ? "\u2713 " : "\u2717 ") + verdictOf(report),
             right ? lab::Tone::title : lab::Tone::wrong);
    std::size_t wrong = 0;
    const WorstPixel* worst = nullptr;
    for (const Check& check : report.checks) {
        if (check.status != CheckStatus::fail && check.status != CheckStatus::partial)
            continue;
        if (wrong++ >= most)
            continue;
        page.addWrong(check, report.language);
        if (isGate(check))
            page.addSaid(report);
        if (worst == nullptr && check.worst)
            worst = &*check.worst;
    }
    if (wrong > most)
        page.add(say(report.language, "and more: ", "e altro: ") + std::to_string(wrong - most));
    if (worst != nullptr && detail != Detail::firstCheck) {
        const std::vector<std::string> lines = worstOf(*worst, report.language);
        for (std::size_t i = 0; i < (detail == Detail::all ? lines.size() : 1); ++i)
            page.add(lines[i]);
    }
    page.addNames(say(report.language, "\u2026 not looked at yet: ", "\u2026 non ancora guardati: "), report,
                  CheckStatus::skipped);
    if (detail != Detail::firstCheck)
        page.addNames("\u2713 ", report, CheckStatus::pass);
    return page.take();
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, std::size_t letters) {
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    std::vector<std::string> lines;
    std::string line(begin, ' '), word;
    std::size_t length = begin, wordLength = 0;
    bool empty = true;
    const auto place = [&] {
        if (word.empty())
            return;
        if (!empty && length + 1 + wordLength > letters) {
            lines.push_back(std::exchange(line, std::string(begin + 2, ' ')));
            length = begin + 2;
            empty = true;
        }
        line += (empty ? "" : " ") + word;
        length += wordLength + (empty ? 0 : 1);
        empty = false;
        word.clear();
        wordLength = 0;
    };
    for (std::size_t i = begin; i < text.size(); ++i) {
        if (text[i] == ' ') {
            place();
            continue;
        }
        word += text[i];
        wordLength += (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80 ? 1 : 0;  // code points
    }
    place();
    lines.push_back(line);
    return lines;
}

bool allRight(const Report& report) {
    return report.status == ReportStatus::graded &&
           std::all_of(report.checks.begin(), report.checks.end(),
                       [](const Check& check) { return check.status == CheckStatus::pass; });
}

std::string verdictOf(const Report& report) {
    if (report.status != ReportStatus::graded)
        return report.reason;
    if (allRight(report))
        return say(report.language, "all right from here; marks come from other views too",
                   "tutto giusto da qui; i punti vengono anche da altre viste");
    return say(report.language, "not right yet", "non è ancora giusto");
}

std::string textOf(const Graded& graded) {
    const Report report = merged(graded.report);
    std::string text = summary(report);
    for (const std::string& line : some(diagnosis(report), linesInTerminal))
        text += line + "\n";
    for (const Check& check : report.checks)
        if (check.status != CheckStatus::pass && check.worst) {
            for (const std::string& line : worstOf(*check.worst, report.language))
                for (const std::string& piece : wrapped(line, lettersInTerminal))
                    text += piece + "\n";
            break;
        }
    if (!allRight(report) && std::any_of(graded.pictures.begin(), graded.pictures.end(),
                                         [](const Picture& one) { return one.image.role == "difference"; }))
        text += differenceLegend(report.language) + "\n";
    return harmless(text + "check: " + verdictOf(report) + "\n");
}

std::vector<lab::Line> linesOf(const Graded& graded, std::size_t letters, std::size_t most) {
    std::vector<lab::Line> lines;
    for (const Detail detail : {Detail::all, Detail::noNumbers, Detail::firstCheck}) {
        lines = pageOf(graded, letters, detail);
        if (lines.size() <= most)
            break;
    }
    return lines;
}

}  // namespace grader
