// Writes the lessons' table; all in it comes from the lessons' headers and tags and from slides.json.
// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <ostream>

namespace nuovo {
namespace {

struct Words {
    const char* head;
    const char* slide;
    const char* replaces;
};

Words wordsOf(const std::string& lang) {
    return lang == "it"
               ? Words{"| lezione | slide | che cosa c'è di nuovo | righe NUOVO |", "Slide", "al posto di"}
               : Words{"| lesson | slides | what is new | NUOVO lines |", "Slide", "instead of"};
}

/// Text in a table's cell: a bar would end the cell.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result.append(c == '|' ? "\\|" : std::string(1, c));
    }
    return result;
}

/// Code in Markdown; the fence is longer than any run of backticks inside.
std::string codeSpan(std::string_view code) {
    std::size_t longest = 0;
    std::size_t run = 0;
    for (const char c : code) {
        run = c == '`' ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    const std::string fence(longest + 1, '`');
    const char* const gap = longest > 0 ? " " : "";
    return fence + gap + std::string(code) + gap + fence;
}

/// The header's slides, then what tags cite beyond them.
std::string slidesOf(const Lesson& lesson) {
    std::vector<SlideRange> ranges = lesson.slides;
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::New &&
            std::none_of(ranges.begin(), ranges.end(),
                         [&](const SlideRange& range) { return range.contains(line.cites); })) {
            ranges.push_back({line.cites, line.cites});
        }
    }
    std::string result;
    for (const SlideRange& range : ranges) {
        result.append(result.empty() ? "" : ", ").append(toString(range));
    }
    return result;
}

void printStep(const Lesson& lesson, const Slides& slides, const std::string& lang, std::ostream& out) {
    out << "\n### " << lesson.stem << '\n';
    int slide = 0;
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::Old) {
            out << "  - " << wordsOf(lang).replaces << ' ' << codeSpan(trimmed(line.code)) << '\n';
        }
        if (line.kind != LineKind::New) {
            continue;
        }
        if (line.cites.slide != slide) {
            slide = line.cites.slide;
            const auto titles = slides.titles.find(slide);
            const bool titled = titles != slides.titles.end() && titles->second.count(lang) > 0;
            out << '\n'
                << wordsOf(lang).slide << ' ' << slide << (titled ? ": " + titles->second.at(lang) : "")
                << "\n\n";
        }
        out << "- " << toString(line.cites) << ' ' << codeSpan(trimmed(line.code)) << '\n';
    }
}

}  // namespace

void printTable(const LessonSet& lessons, const Slides& slides, const std::string& lang, std::ostream& out) {
    out << wordsOf(lang).head << "\n|---|---|---|---|\n";
    for (const Lesson& lesson : lessons.chain) {
        out << "| " << lesson.stem << " | " << slidesOf(lesson) << " | " << cell(lesson.title) << " | "
            << lesson.count(LineKind::New) << " |\n";
    }
    for (const Lesson& lesson : lessons.chain) {
        if (lesson.count(LineKind::New) > 0) {
            printStep(lesson, slides, lang, out);
        }
    }
}

}  // namespace nuovo
