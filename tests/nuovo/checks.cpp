// The rules, one function each, over lessons and slides that are already read.
// SPDX-License-Identifier: MIT
#include "checks.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace nuovo {
namespace {

constexpr int kMostNew = 20;
constexpr int kMostOld = 3;
constexpr int kMostColumns = 84;
constexpr std::size_t kDiffLines = 3;
constexpr const char* kOthersRow = "other .cpp files";
constexpr const char* kSlidesRow = "slides.json";

std::string lineName(const Lesson& lesson, int line) { return lesson.stem + ".cpp:" + std::to_string(line); }

Failure failureIn(const Lesson& lesson, Rule rule, int line, std::string what) {
    return {rule, lesson.number < 0 ? kOthersRow : lesson.stem, lesson.file, line, std::move(what), {}, {},
            {}};
}

/// Characters, not bytes: the lessons' comments are Italian.
int columns(std::string_view text) {
    return static_cast<int>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool isComment(const Line& line) { return trimmed(line.code).substr(0, 2) == "//"; }

/// The code of a line or of a slide, without its trailing comment and the blanks around it.
std::string_view bareCode(std::string_view code) { return trimmed(code.substr(0, commentStart(code))); }

void checkNumbers(const LessonSet& lessons, Report& report) {
    int expected = 0;
    for (const Lesson& lesson : lessons.chain) {
        if (lesson.number != expected) {
            Failure failure =
                failureIn(lesson, Rule::Number, 1,
                          lesson.number < expected ? "a number that another lesson has"
                                                   : "a number of the chain is missing before this lesson");
            failure.expected = {"lesson " + std::to_string(expected)};
            failure.found = {"lesson " + std::to_string(lesson.number)};
            failure.remedy = "rename the files: the chain counts 00, 01, 02, ... without gap or repetition";
            report.failures.push_back(std::move(failure));
        }
        expected = lesson.number + 1;
    }
    for (const Lesson& other : lessons.others) {
        if (other.stem.rfind("lesson", 0) == 0) {
            Failure failure =
                failureIn(other, Rule::Number, 1, "a lesson's file that the chain does not see");
            failure.expected = {"lesson_NN_name.cpp, NN two digits, name of letters, digits and _"};
            failure.found = {other.stem + ".cpp"};
            failure.remedy = "rename the file";
            report.failures.push_back(std::move(failure));
        }
    }
}

/// At most kDiffLines of lines[from, to), each with its place.
std::vector<std::string> excerpt(const Lesson& lesson, const std::vector<PlainLine>& lines, std::size_t from,
                                 std::size_t to) {
    std::vector<std::string> result;
    for (std::size_t i = from; i < std::min(to, from + kDiffLines); ++i) {
        result.push_back(lineName(lesson, lines[i].number) + ": " + lines[i].text);
    }
    if (to > from + kDiffLines) {
        result.push_back("and " + std::to_string(to - from - kDiffLines) + " more lines");
    } else if (from == to) {
        result.push_back(lesson.stem + ".cpp: nothing");
    }
    return result;
}

void checkChain(const Lesson& previous, const Lesson& lesson, Report& report) {
    const auto expected = plain(previous);
    const auto found = before(lesson);
    const auto same = [&](const PlainLine& a, const PlainLine& b) {
        return withoutOwnName(a.text, previous.stem) == withoutOwnName(b.text, lesson.stem);
    };
    const auto first = std::mismatch(expected.begin(), expected.end(), found.begin(), found.end(), same);
    const auto start = static_cast<std::size_t>(first.first - expected.begin());
    if (start == expected.size() && start == found.size()) {
        return;
    }
    std::size_t expectedEnd = expected.size();
    std::size_t foundEnd = found.size();
    while (expectedEnd > start && foundEnd > start && same(expected[expectedEnd - 1], found[foundEnd - 1])) {
        --expectedEnd;
        --foundEnd;
    }
    const int lastLine = std::max(1, static_cast<int>(lesson.lines.size()));
    Failure failure = failureIn(lesson, Rule::Chain, start < found.size() ? found[start].number : lastLine,
                                "without its step this lesson is not " + previous.stem);
    failure.expected = excerpt(previous, expected, start, expectedEnd);
    failure.found = excerpt(lesson, found, start, foundEnd);
    failure.remedy =
        start == expectedEnd
            ? "tag what is new with `// NUOVO <slide>[.<item>]`, or add it to the previous lesson"
        : start == foundEnd
            ? "put the line back, or keep it as `// PRIMA <old line>` below the NUOVO line that replaces it"
            : "make the lines equal, or tag the new one and keep the old one below it as `// PRIMA <old "
              "line>`";
    report.failures.push_back(std::move(failure));
}

/// The line of the n-th line of this kind (from 0), or 1.
int lineOf(const Lesson& lesson, LineKind kind, int n) {
    for (const Line& line : lesson.lines) {
        if (line.kind == kind && n-- == 0) {
            return line.number;
        }
    }
    return 1;
}

void checkCount(const Lesson& lesson, Report& report) {
    const auto fail = [&](int line, const std::string& expected, const std::string& found,
                          const char* remedy) {
        Failure failure = failureIn(lesson, Rule::Count, line, "the size of the step");
        failure.expected = {expected};
        failure.found = {found};
        failure.remedy = remedy;
        report.failures.push_back(std::move(failure));
    };
    const int news = lesson.count(LineKind::New);
    const int olds = lesson.count(LineKind::Old);
    if (lesson.number == 0 && news > 0) {
        fail(lineOf(lesson, LineKind::New, 0), "no NUOVO line in lesson 00, where all is new",
             std::to_string(news), "take the tags off");
    } else if (lesson.number > 0 && news == 0) {
        fail(1, "1 to 20 NUOVO lines", "none", "tag the lines of the step with `// NUOVO <slide>[.<item>]`");
    } else if (news > kMostNew) {
        fail(lineOf(lesson, LineKind::New, kMostNew), "1 to 20 NUOVO lines", std::to_string(news),
             "split the step into two lessons");
    }
    if (olds > kMostOld) {
        fail(lineOf(lesson, LineKind::Old, kMostOld), "at most 3 PRIMA lines", std::to_string(olds),
             "let the step insert lines instead of replacing them");
    }
}

void checkSlides(const Lesson& lesson, const Slides& slides, Report& report) {
    for (const Line& line : lesson.lines) {
        if (line.kind != LineKind::New) {
            continue;
        }
        const std::string cited = toString(line.cites);
        const auto fail = [&](const std::string& expected, const std::string& remedy) {
            Failure failure = failureIn(lesson, Rule::Slides, line.number, "the tag cites " + cited);
            failure.expected = {expected};
            failure.found = {line.raw};
            failure.remedy = remedy;
            report.failures.push_back(std::move(failure));
        };
        if (slides.titles.count(line.cites.slide) == 0) {
            fail("a slide that slides.json has", "correct the tag, or add the slide to slides.json");
        } else if (line.cites.item > 0 && slides.find(cited) == nullptr) {
            fail("a code item that slides.json has",
                 "correct the tag, cite the slide alone, or add the item to slides.json");
        } else if (!lesson.slides.empty() &&
                   std::none_of(lesson.slides.begin(), lesson.slides.end(),
                                [&](const SlideRange& range) { return range.contains(line.cites); })) {
            fail("a slide of the header's line `Slides ...`",
                 "add it to the lesson's header, or correct the tag");
        }
    }
}

/// The lines of code that the lesson tags with this item; comments tagged with it explain them.
std::vector<const Line*> claimedLines(const Lesson& lesson, const std::string& item) {
    std::vector<const Line*> result;
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::New && toString(line.cites) == item && !isComment(line)) {
            result.push_back(&line);
        }
    }
    return result;
}

void checkClaimed(const Lesson& lesson, const CodeItem& item, Report& report) {
    const auto claimed = claimedLines(lesson, item.item);
    const auto first =
        std::mismatch(item.cpp.begin(), item.cpp.end(), claimed.begin(), claimed.end(),
                      [](const std::string& a, const Line* b) { return bareCode(a) == bareCode(b->code); });
    const bool slideEnds = first.first == item.cpp.end();
    const bool lessonEnds = first.second == claimed.end();
    if (slideEnds && lessonEnds) {
        return;
    }
    const int near = claimed.empty() ? 1 : claimed.back()->number;
    Failure failure = failureIn(lesson, Rule::Items, lessonEnds ? near : (*first.second)->number,
                                "the code of item " + item.item + " is not the slide's, line by line");
    failure.expected = {slideEnds ? "no further line of this item" : *first.first};
    failure.found = {lessonEnds ? "no further line tagged " + item.item : (*first.second)->code};
    failure.remedy = slideEnds ? "cite another slide where the line is not on this one"
                               : "write the line as slides.json has it, tagged `// NUOVO " + item.item + "`";
    report.failures.push_back(std::move(failure));
}

/// No other lesson may claim the item.
void checkUnclaimed(const Lesson& lesson, const CodeItem& item, Report& report) {
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::New && toString(line.cites) == item.item) {
            Failure failure =
                failureIn(lesson, Rule::Items, line.number, "item " + item.item + " is another lesson's");
            failure.expected = {"tags of " + item.item + " in " + item.lesson + " only"};
            failure.found = {line.raw};
            failure.remedy = "cite another slide, or correct the item's lesson in slides.json";
            report.failures.push_back(std::move(failure));
        }
    }
}

void checkItems(const LessonSet& lessons, const Slides& slides, Report& report) {
    for (const CodeItem& item : slides.items) {
        bool claimed = false;
        for (const Lesson& lesson : lessons.chain) {
            claimed = claimed || lesson.stem == item.lesson;
            lesson.stem == item.lesson ? checkClaimed(lesson, item, report)
                                       : checkUnclaimed(lesson, item, report);
        }
        // A lesson still to come has a number after the last one's; any other name is a mistake.
        if (!claimed && chainNumber(item.lesson) <= lessons.chain.back().number) {
            Failure failure{Rule::Items, kSlidesRow, slides.file, 1, "item " + item.item + " has no lesson",
                            {},          {},         {}};
            failure.expected = {"the name of a lesson of the chain, or of one that continues it"};
            failure.found = {item.lesson};
            failure.remedy = "correct `lesson` of this item in slides.json";
            report.failures.push_back(std::move(failure));
        }
    }
}

/// A line with its own comment, or one that stands in for an old line, which shows what it changes.
bool explainsItself(const Lesson& lesson, const Line& line) {
    const auto next = static_cast<std::size_t>(line.number);
    return commentStart(line.code) != std::string::npos ||
           (next < lesson.lines.size() && lesson.lines[next].kind == LineKind::Old);
}

void checkComments(const Lesson& lesson, Report& report) {
    for (std::size_t i = 0; i < lesson.lines.size();) {
        std::vector<const Line*> run;
        for (; i < lesson.lines.size(); ++i) {
            const Line& line = lesson.lines[i];
            const bool include = trimmed(line.code).substr(0, 8) == "#include";
            if (line.kind == LineKind::New && !include) {
                run.push_back(&line);
            } else if (line.kind != LineKind::Blank && line.kind != LineKind::Old) {
                ++i;
                break;
            }
        }
        if (!run.empty() && !isComment(*run[0]) && !(run.size() == 1 && explainsItself(lesson, *run[0]))) {
            Failure failure =
                failureIn(lesson, Rule::Comment, run[0]->number, "a run of NUOVO lines without its comment");
            failure.expected = {"a comment line tagged NUOVO, saying what the slide asks"};
            failure.found = {run[0]->raw};
            failure.remedy =
                "put a tagged comment line first, or give a run of one line its own trailing comment";
            report.failures.push_back(std::move(failure));
        }
    }
}

void checkWidth(const Lesson& lesson, Report& report) {
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::New && columns(line.code) > kMostColumns) {
            Failure failure = failureIn(lesson, Rule::Width, line.number, "a long line before its tag");
            failure.expected = {"at most " + std::to_string(kMostColumns) + " columns"};
            failure.found = {std::to_string(columns(line.code)) + " columns: " + line.code};
            failure.remedy = "shorten the line, or break it into two tagged lines";
            report.failures.push_back(std::move(failure));
        }
    }
}

void checkTags(const Lesson& lesson, Report& report) {
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::Faulty) {
            Failure failure = failureIn(lesson, Rule::Tags, line.number, line.problem);
            failure.expected = {"<code>  // NUOVO <slide>[.<item>]   or   // PRIMA <old line>"};
            failure.found = {line.raw};
            failure.remedy = "spell the mark exactly so, or say it in other words if it is none";
            report.failures.push_back(std::move(failure));
        }
    }
}

void checkPlace(const Lesson& other, Report& report) {
    for (const Line& line : other.lines) {
        if (line.kind == LineKind::New || line.kind == LineKind::Old || line.kind == LineKind::Faulty) {
            Failure failure =
                failureIn(other, Rule::Place, line.number, "a mark outside the chain of lessons");
            failure.expected = {"NUOVO and PRIMA in lesson_NN_*.cpp only"};
            failure.found = {line.raw};
            failure.remedy = "take the mark off";
            report.failures.push_back(std::move(failure));
        }
    }
}

}  // namespace

Report check(const LessonSet& lessons, const Slides& slides) {
    Report report;
    int news = 0;
    int olds = 0;
    for (std::size_t i = 0; i < lessons.chain.size(); ++i) {
        const Lesson& lesson = lessons.chain[i];
        report.rows.push_back({lesson.stem,
                               {Rule::Number, Rule::Chain, Rule::Count, Rule::Slides, Rule::Items,
                                Rule::Comment, Rule::Width, Rule::Tags}});
        if (i > 0) {
            checkChain(lessons.chain[i - 1], lesson, report);
        }
        checkCount(lesson, report);
        checkSlides(lesson, slides, report);
        checkComments(lesson, report);
        checkWidth(lesson, report);
        checkTags(lesson, report);
        news += lesson.count(LineKind::New);
        olds += lesson.count(LineKind::Old);
    }
    report.rows.push_back({kOthersRow, {Rule::Number, Rule::Place}});
    report.rows.push_back({kSlidesRow, {Rule::Items}});
    checkNumbers(lessons, report);
    checkItems(lessons, slides, report);
    for (const Lesson& other : lessons.others) {
        checkPlace(other, report);
    }
    report.summary = std::to_string(lessons.chain.size()) + " lessons, " + std::to_string(news) +
                     " NUOVO lines, " + std::to_string(olds) + " PRIMA, " +
                     std::to_string(slides.items.size()) + " code items";
    return report;
}

}  // namespace nuovo
