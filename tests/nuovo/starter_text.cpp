// What stands in place of the lines that a starter takes away: in the lesson and in its shader terms.
// SPDX-License-Identifier: MIT
#include "starter_text.hpp"

#include <algorithm>
#include <sstream>

namespace nuovo {
namespace {

constexpr std::ptrdiff_t kColumns = 100;
constexpr std::string_view kNoBreak = "\xC2\xA0";

std::ptrdiff_t columns(std::string_view text) {
    return std::count_if(text.begin(), text.end(),
                         [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

std::string indentOf(std::string_view line) {
    return std::string(line.substr(0, std::min(line.find_first_not_of(" \t"), line.size())));
}

std::string header(const Lesson& lesson, const std::string& lang) {
    const std::string text = lang == "it" ? "Da completare: funziona già, come la lezione prima di questa. I "
                                            "TODO dicono che cosa chiedono le "
                                            "slide, README.md come si compila, si esegue e si controlla."
                                          : "To be completed: it works already, as the lesson before this "
                                            "one. The TODOs say what the slides "
                                            "ask for, README.md how to build, run and check it.";
    return "// " + lesson.stem + "\n" + commented("", "", text) + "//\n// SPDX-License-Identifier: MIT\n";
}

enum class Directive { None, If, Else, Elif, Endif };

Directive directiveOf(std::string_view line) {
    line = trimmed(line);
    if (line.substr(0, 1) != "#") {
        return Directive::None;
    }
    line = trimmed(line.substr(1));
    return line.substr(0, 2) == "if"      ? Directive::If
           : line.substr(0, 4) == "else"  ? Directive::Else
           : line.substr(0, 4) == "elif"  ? Directive::Elif
           : line.substr(0, 5) == "endif" ? Directive::Endif
                                          : Directive::None;
}

/// An #if block: the lines of its two parts, and the index behind its #endif.
struct Block {
    std::vector<std::string> on, off;
    std::size_t end = 0;
};

Block readBlock(const std::vector<std::string>& lines, std::size_t start, const std::string& file) {
    Block block;
    bool afterElse = false;
    int depth = 0;
    for (std::size_t i = start + 1; i < lines.size(); ++i) {
        const Directive directive = directiveOf(lines[i]);
        if (depth == 0 && directive == Directive::Endif) {
            block.end = i + 1;
            return block;
        }
        if (depth == 0 && directive == Directive::Elif) {
            break;
        }
        depth += directive == Directive::If ? 1 : directive == Directive::Endif ? -1 : 0;
        if (depth == 0 && directive == Directive::Else) {
            afterElse = true;
        } else {
            (afterElse ? block.off : block.on).push_back(lines[i]);
        }
    }
    throw InputError(
        file + ":" + std::to_string(start + 1) +
        ": expected #if, at most one #else, #endif; write the term so, or leave it out of tasks.json");
}

/// The block with its neutral part in both places; nothing is left of helpers, which have no #else.
std::string neutral(const Block& block, const std::string& opening, const std::string& todo) {
    if (block.off.empty() && todo.empty()) {
        return "";
    }
    std::string off;
    for (const std::string& line : block.off) {
        off += line + "\n";
    }
    const std::string indent = block.on.empty() ? "" : indentOf(block.on[0]);
    return opening + "\n" + (todo.empty() ? "" : commented(indent, "TODO:", todo)) + off +
           (off.empty() ? "" : "#else\n" + off) + "#endif\n";
}

}  // namespace

std::string withPlainBlanks(std::string text) {
    for (auto at = text.find(kNoBreak); at != std::string::npos; at = text.find(kNoBreak, at)) {
        text.replace(at, kNoBreak.size(), " ");
    }
    return text;
}

std::string commented(const std::string& indent, const std::string& first, std::string_view text) {
    const std::string next = indent + "//" + (first.empty() ? "" : "    ");
    std::string line = indent + "//" + (first.empty() ? "" : " " + first);
    std::string result;
    std::istringstream paragraphs{std::string(text)};
    for (std::string paragraph; std::getline(paragraphs, paragraph); line = next) {
        std::istringstream words(paragraph);
        for (std::string word; words >> word; line += " " + word) {
            if (columns(line) + 1 + columns(word) > kColumns) {
                result += line + "\n";
                line = next;
            }
        }
        result += line + "\n";
    }
    return withPlainBlanks(std::move(result));
}

std::string starterLesson(const Lesson& lesson, const LessonTasks& tasks, const std::string& lang) {
    const std::vector<NewRun> runs = runsOf(lesson);
    std::string text = header(lesson, lang);
    for (std::size_t i = 0, run = 0; i < lesson.lines.size(); ++i) {
        const Line& line = lesson.lines[i];
        if (line.kind == LineKind::Header) {
            continue;
        }
        if (run < runs.size() && i == runs[run].begin) {
            text +=
                commented(indentOf(line.raw), "TODO " + toString(line.cites) + ":", tasks.runs[run].at(lang));
            i = runs[run++].end - 1;
        } else {
            text += (line.kind == LineKind::Old ? line.code : line.raw) + "\n";
        }
    }
    return text;
}

std::string starterTerm(std::string_view glsl, const std::string& term, const std::string& todo,
                        const std::string& file) {
    std::vector<std::string> lines;
    std::istringstream stream{std::string(glsl)};
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    std::string upper = term;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    const std::string opening = "#if TERM_" + upper;
    std::size_t last = lines.size();  // where the TODO goes
    for (std::size_t i = 0; i < lines.size(); ++i) {
        last = trimmed(lines[i]) == opening ? i : last;
    }
    if (last == lines.size()) {
        throw InputError(file + ": expected a line `" + opening +
                         "`, found none; is it the file of this term?");
    }
    std::string text;
    for (std::size_t i = 0; i < lines.size();) {
        if (trimmed(lines[i]) != opening) {
            text += lines[i++] + "\n";
            continue;
        }
        const Block block = readBlock(lines, i, file);
        text += neutral(block, lines[i], i == last ? todo : "");
        i = block.end;
    }
    return text;
}

}  // namespace nuovo
