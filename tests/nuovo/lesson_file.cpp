// Parsing of lesson lines and header, and the two transforms that undo the marks.
// SPDX-License-Identifier: MIT
#include "lesson_file.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace nuovo {
namespace {

constexpr std::string_view kTag = "// NUOVO ";
constexpr std::string_view kPrima = "// PRIMA ";

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWord(char c) { return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string_view trimmedLeft(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(" \t\r"), text.size()));
}

std::string_view trimmedRight(std::string_view text) {
    return text.substr(0, text.find_last_not_of(" \t\r") + 1);  // npos + 1 is 0
}

bool startsWithIgnoringCase(std::string_view text, std::string_view word) {
    return text.size() >= word.size() &&
           std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) { return a == lower(b); });
}

/// Whole-word search; `from` is where to begin.
std::size_t findWord(std::string_view text, std::string_view word, std::size_t from = 0) {
    for (auto at = text.find(word, from); at != std::string_view::npos;
         at = text.find(word, at + word.size())) {
        const auto end = at + word.size();
        if ((at == 0 || !isWord(text[at - 1])) && (end == text.size() || !isWord(text[end]))) {
            return at;
        }
    }
    return std::string_view::npos;
}

/// Whether some // comment of the line opens with text of which `test` holds.
template <class Test>
bool anyComment(std::string_view line, Test test) {
    auto at = line.find("//");
    while (at != std::string_view::npos) {
        const auto text = std::min(line.find_first_not_of('/', at), line.size());
        if (test(trimmedLeft(line.substr(text)))) {
            return true;
        }
        at = line.find("//", text);
    }
    return false;
}

/// "nuovo" and "prima" are everyday Italian words: in small letters they count only where a mark would stand.
bool resemblesTag(std::string_view line) {
    return line.find("NUOV") != std::string_view::npos || anyComment(line, [](std::string_view comment) {
               if (!startsWithIgnoringCase(comment, "nuov") || comment.size() < 5 ||
                   std::string_view("oaie").find(lower(comment[4])) == std::string_view::npos) {
                   return false;
               }
               const auto rest = trimmedLeft(comment.substr(5));
               return rest.empty() || rest[0] == ':' || isDigit(rest[0]);
           });
}

bool resemblesPrima(std::string_view line) {
    return findWord(line, "PRIMA") != std::string_view::npos ||
           anyComment(line, [](std::string_view comment) {
               return startsWithIgnoringCase(comment, "prima") &&
                      trimmedLeft(comment.substr(5)).substr(0, 1) == ":";
           });
}

/// The tag at the end of the line, with the place where it starts.
std::optional<std::pair<std::size_t, Citation>> tagOf(std::string_view line) {
    const auto at = line.rfind(kTag);
    if (at == std::string_view::npos) {
        return std::nullopt;
    }
    const auto citation = parseCitation(line.substr(at + kTag.size()));
    return citation ? std::optional(std::pair(at, *citation)) : std::nullopt;
}

void fault(Line& line, std::string problem) {
    line.kind = LineKind::Faulty;
    line.problem = std::move(problem);
}

void classifyTagged(Line& line, std::size_t tagAt, const Citation& citation) {
    const std::string_view head = std::string_view(line.raw).substr(0, tagAt);
    const std::string_view code = trimmedRight(head);
    if (code.empty()) {
        fault(line, "the tag stands alone and marks nothing");
    } else if (code.size() == head.size()) {
        fault(line, "no blank between the code and its tag");
    } else if (resemblesTag(code)) {
        fault(line, "two tags on one line");
    } else if (resemblesPrima(code)) {
        fault(line, "NUOVO and PRIMA on one line");
    } else {
        line.kind = LineKind::New;
        line.code = code;
        line.cites = citation;
    }
}

void classifyPrima(Line& line, LineKind previous) {
    const std::string_view raw = line.raw;
    const auto at = raw.size() - trimmedLeft(raw).size();
    if (raw.substr(at, kPrima.size()) != kPrima) {
        fault(line, "resembles a PRIMA comment: it stands on a line of its own, as `// PRIMA <old line>`");
        return;
    }
    const std::string_view old = raw.substr(at + kPrima.size());
    if (trimmed(old).empty()) {
        fault(line, "PRIMA without the old line");
    } else if (resemblesTag(old) || resemblesPrima(old)) {
        fault(line, "a mark inside a PRIMA comment: keep the old line without its tag");
    } else if (previous != LineKind::New && previous != LineKind::Old) {
        fault(line, "PRIMA without a NUOVO line just above it");
    } else {
        line.kind = LineKind::Old;
        line.code = std::string(raw.substr(0, at)).append(old);
    }
}

Line classify(int number, std::string_view raw, bool inHeader, LineKind previous) {
    Line line{number, LineKind::Same, std::string(raw), std::string(raw), {}, {}};
    const auto tag = tagOf(raw);
    if (inHeader) {
        line.kind = LineKind::Header;
        if (tag) {
            fault(line,
                  "a tag in the header comment, which is no part of the step (a blank line ends the header)");
        }
    } else if (trimmed(raw).empty()) {
        line.kind = LineKind::Blank;
    } else if (tag) {
        classifyTagged(line, tag->first, tag->second);
    } else if (tagOf(trimmedRight(raw))) {
        fault(line, "blanks or a Windows line end after the tag");
    } else if (resemblesTag(raw)) {
        fault(line,
              "resembles a tag: it is spelled `// NUOVO <slide>[.<item>]`, in capitals, and ends the line");
    } else if (resemblesPrima(raw)) {
        classifyPrima(line, previous);
    }
    return line;
}

/// Takes a range off the front of `text`: "16-30", "36.3-36.4" or "38", with a hyphen or an en dash.
std::optional<SlideRange> takeRange(std::string_view& text) {
    const auto takeCitation = [&text]() -> std::optional<Citation> {
        auto end = std::min(text.find_first_not_of("0123456789."), text.size());
        while (end > 0 && text[end - 1] == '.') {  // the full stop of a sentence
            --end;
        }
        const auto citation = parseCitation(text.substr(0, end));
        text.remove_prefix(citation ? end : 0);
        return citation;
    };
    const auto first = takeCitation();
    if (!first) {
        return std::nullopt;
    }
    for (const std::string_view dash : {"-", "\xE2\x80\x93"}) {
        if (text.substr(0, dash.size()) == dash) {
            text.remove_prefix(dash.size());
            return SlideRange{*first, takeCitation().value_or(*first)};
        }
    }
    return SlideRange{*first, *first};
}

std::vector<SlideRange> parseSlidesLine(std::string_view comment) {
    std::vector<SlideRange> ranges;
    if (!startsWithIgnoringCase(comment, "slide")) {
        return ranges;
    }
    comment.remove_prefix(5);
    comment.remove_prefix(startsWithIgnoringCase(comment, "s") ? 1 : 0);
    while (true) {
        comment.remove_prefix(std::min(comment.find_first_not_of(" :,;\t"), comment.size()));
        const auto range = takeRange(comment);
        if (!range) {
            return ranges;
        }
        ranges.push_back(*range);
    }
}

void parseHeader(Lesson& lesson) {
    for (const Line& line : lesson.lines) {
        if (line.kind != LineKind::Header) {
            break;
        }
        std::string_view text = trimmed(std::string_view(line.raw).substr(2));
        if (line.number == 1) {
            const bool named = text.substr(0, lesson.stem.size()) == lesson.stem;
            text.remove_prefix(named ? lesson.stem.size() : 0);
            text.remove_prefix(named ? std::min(text.find_first_not_of(" :-"), text.size()) : 0);
            lesson.title = text;
        }
        if (lesson.slides.empty()) {
            lesson.slides = parseSlidesLine(text);
        }
    }
}

}  // namespace

std::string toString(const Citation& citation) {
    std::string text = std::to_string(citation.slide);
    return citation.item > 0 ? text.append(".").append(std::to_string(citation.item)) : text;
}

std::optional<Citation> parseCitation(std::string_view text) {
    const auto take = [&text](int& value) {
        const auto length = std::min(text.find_first_not_of("0123456789"), text.size());
        if (length == 0 || length > 4 || text[0] == '0') {
            return false;
        }
        std::from_chars(text.data(), text.data() + length, value);
        text.remove_prefix(length);
        return true;
    };
    Citation citation;
    if (!take(citation.slide)) {
        return std::nullopt;
    }
    if (!text.empty() && text[0] == '.') {
        text.remove_prefix(1);
        if (!take(citation.item)) {
            return std::nullopt;
        }
    }
    return text.empty() ? std::optional(citation) : std::nullopt;
}

bool SlideRange::contains(const Citation& citation) const {
    const auto cut = [&citation](const Citation& end) {  // an item bounds only where both sides name one
        return end.slide == citation.slide && end.item > 0 && citation.item > 0;
    };
    return citation.slide >= first.slide && citation.slide <= last.slide &&
           (!cut(first) || citation.item >= first.item) && (!cut(last) || citation.item <= last.item);
}

std::string toString(const SlideRange& range) {
    std::string text = toString(range.first);
    return range.first == range.last ? text : text.append("-").append(toString(range.last));
}

int Lesson::count(LineKind kind) const {
    return static_cast<int>(
        std::count_if(lines.begin(), lines.end(), [kind](const Line& line) { return line.kind == kind; }));
}

std::vector<PlainLine> plain(const Lesson& lesson) {
    std::vector<PlainLine> result;
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::Same || line.kind == LineKind::New || line.kind == LineKind::Faulty) {
            result.push_back({line.number, line.code});
        }
    }
    return result;
}

std::vector<PlainLine> before(const Lesson& lesson) {
    std::vector<PlainLine> result;
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::Same || line.kind == LineKind::Old || line.kind == LineKind::Faulty) {
            result.push_back({line.number, line.code});
        }
    }
    return result;
}

std::string withoutOwnName(std::string_view text, std::string_view stem) {
    std::string result;
    std::size_t from = 0;
    for (auto at = findWord(text, stem); at != std::string_view::npos; at = findWord(text, stem, from)) {
        result.append(text.substr(from, at - from)).append("\x1f");  // a byte that no source text has
        from = at + stem.size();
    }
    return result.append(text.substr(from));
}

std::size_t commentStart(std::string_view code) {
    char quote = 0;
    for (std::size_t i = 0; i + 1 < code.size(); ++i) {
        const char c = code[i];
        if (quote != 0) {
            i += c == '\\' ? 1 : 0;
            quote = c == quote ? char{0} : quote;
        } else if (c == '"' || (c == '\'' && (i == 0 || !isWord(code[i - 1])))) {  // 1'000 opens no quote
            quote = c;
        } else if (c == '/' && code[i + 1] == '/') {
            return i;
        }
    }
    return std::string_view::npos;
}

std::string_view trimmed(std::string_view text) { return trimmedRight(trimmedLeft(text)); }

int chainNumber(std::string_view stem) {
    if (stem.size() < 11 || stem.substr(0, 7) != "lesson_" || !isDigit(stem[7]) || !isDigit(stem[8]) ||
        stem[9] != '_' || !std::all_of(stem.begin() + 10, stem.end(), isWord)) {
        return -1;
    }
    return (stem[7] - '0') * 10 + (stem[8] - '0');
}

Lesson parseLesson(const std::filesystem::path& file, std::string_view text) {
    Lesson lesson;
    lesson.file = file;
    lesson.stem = file.stem().string();
    lesson.number = chainNumber(lesson.stem);
    bool inHeader = true;
    LineKind previous = LineKind::Blank;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view raw = text.substr(0, end);
        inHeader = inHeader && raw.substr(0, 2) == "//";
        const int number = static_cast<int>(lesson.lines.size()) + 1;
        lesson.lines.push_back(classify(number, raw, inHeader, previous));
        previous = lesson.lines.back().kind;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    parseHeader(lesson);
    return lesson;
}

}  // namespace nuovo
