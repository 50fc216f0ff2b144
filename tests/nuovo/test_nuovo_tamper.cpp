// Tampers with every line of a chain of lessons, one at a time, and requires that the check fails each time.
// SPDX-License-Identifier: MIT
#include "fixture.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

namespace nuovo::test {
namespace {

enum class Change { Drop, Edit, EditCode, Untag, Tag };
constexpr Change kChanges[] = {Change::Drop, Change::Edit, Change::EditCode, Change::Untag, Change::Tag};

const char* name(Change change) {
    constexpr const char* kNames[] = {"drop", "edit", "edit the code of", "untag", "tag"};
    return kNames[static_cast<int>(change)];
}

/// With a character more in front of the tag, and of the line's own comment if code stands before it.
std::string editedBeforeTag(const Line& line) {
    const std::string_view code = line.code;
    const auto bare = trimmed(code.substr(0, commentStart(code)));
    const auto text = bare.empty() ? trimmed(code) : bare;
    const auto end = static_cast<std::size_t>(text.data() - code.data()) + text.size();
    return line.raw.substr(0, end).append("x").append(line.raw, end);
}

/// The changed line with its line end; as it was where the change has nothing to change.
std::string changed(const Line& line, Change change, const std::string& tag) {
    const bool marked = line.kind == LineKind::New || line.kind == LineKind::Old;
    switch (change) {
    case Change::Drop:
        return "";
    case Change::Edit:
        return line.raw + "x\n";
    case Change::EditCode:
        return (line.kind == LineKind::New ? editedBeforeTag(line) : line.raw) + '\n';
    case Change::Untag:
        return (marked ? line.code : line.raw) + '\n';
    case Change::Tag:
        return line.raw + "  // NUOVO " + tag + '\n';
    }
    return "";
}

/// Whether the check may pass nevertheless, and why.
bool exempt(const Lesson& lesson, const Line& line, Change change, bool last, const Slides& slides) {
    if (line.kind == LineKind::Header) {  // prose, each lesson's own; only a tag has no place in it
        return change != Change::Tag;
    }
    if (line.kind == LineKind::Blank) {  // ignored, so that empty lines need no tags
        return change == Change::Drop;
    }
    if (!last) {
        return false;
    }
    if (line.kind ==
        LineKind::Old) {  // the old line comes back as code; only a following lesson would miss it
        return change == Change::Untag;
    }
    // New lines that no slide has (comments, lines that cite no item): only a following lesson knows them.
    const CodeItem* const item = slides.find(toString(line.cites));
    const bool claimed =
        item != nullptr && item->lesson == lesson.stem && trimmed(line.code).substr(0, 2) != "//";
    return line.kind == LineKind::New && !claimed && (change == Change::Drop || change == Change::EditCode);
}

struct Tally {
    int tried = 0;
    int exempt = 0;
};

std::string rebuilt(const Lesson& lesson, const Line& line, const std::string& replacement) {
    std::string text;
    for (const Line& other : lesson.lines) {
        text += other.number == line.number ? replacement : other.raw + '\n';
    }
    return text;
}

/// A citation that the lesson may use: a tag that fails must fail for what it hides, not for what it cites.
std::string citationFor(const Lesson& lesson) {
    for (const Line& line : lesson.lines) {
        if (line.kind == LineKind::New) {
            return std::to_string(line.cites.slide);
        }
    }
    return lesson.slides.empty() ? "36" : toString(lesson.slides[0].first);
}

Tally tamperWithLessons(const LessonSet& valid, const Slides& slides) {
    Tally tally;
    LessonSet set = valid;
    for (std::size_t i = 0; i < valid.chain.size(); ++i) {
        const Lesson& lesson = valid.chain[i];
        const bool last = i + 1 == valid.chain.size();
        for (const Line& line : lesson.lines) {
            for (const Change change : kChanges) {
                const std::string replacement = changed(line, change, citationFor(lesson));
                if (replacement == line.raw + '\n') {
                    continue;
                }
                if (exempt(lesson, line, change, last, slides)) {
                    ++tally.exempt;
                    continue;
                }
                ++tally.tried;
                set.chain[i] = parseLesson(lesson.file, rebuilt(lesson, line, replacement));
                EXPECT_FALSE(check(set, slides).ok()) << lesson.stem << ".cpp:" << line.number << ": to "
                                                      << name(change) << " this line goes unnoticed:\n"
                                                      << line.raw;
            }
        }
        set.chain[i] = lesson;
    }
    return tally;
}

/// Lines of the slides' code, changed or dropped one at a time, for the lessons that exist.
int tamperWithSlides(const LessonSet& lessons, const Slides& valid) {
    int tried = 0;
    Slides slides = valid;
    for (std::size_t i = 0; i < valid.items.size(); ++i) {
        if (chainNumber(valid.items[i].lesson) > lessons.chain.back().number) {
            continue;
        }
        for (std::size_t line = 0; line < valid.items[i].cpp.size(); ++line) {
            auto& cpp = slides.items[i].cpp;
            const std::string place = valid.items[i].item + ", line " + std::to_string(line + 1);
            cpp[line] = std::string("x").append(cpp[line]);
            EXPECT_FALSE(check(lessons, slides).ok()) << "edited: item " << place;
            cpp.erase(cpp.begin() + static_cast<std::ptrdiff_t>(line));
            EXPECT_FALSE(check(lessons, slides).ok()) << "dropped: item " << place;
            cpp = valid.items[i].cpp;
            tried += 2;
        }
    }
    return tried;
}

std::string failuresOf(const Report& report) {
    std::ostringstream text;
    printFailures(report, text);
    return text.str();
}

TEST(NuovoTamper, SmallChain) {
    const LessonSet lessons = parseAll(validFiles());
    const Slides slides = parseSlides("slides.json", kSlides);
    ASSERT_TRUE(check(lessons, slides).ok()) << failuresOf(check(lessons, slides));
    const Tally tally = tamperWithLessons(lessons, slides);
    EXPECT_GT(tally.tried, 200);  // 71 lines, three changes or more each, less the exempt ones
    EXPECT_LT(tally.exempt, 40);
    EXPECT_EQ(tamperWithSlides(lessons, slides), 14);
}

TEST(NuovoTamper, LessonsOfThisRepository) {
    const std::string root = LAMBERT_SOURCE_DIR;
    const LessonSet lessons = readLessons(root + "/lessons");  // throws, and so fails, when they are absent
    const Slides slides = readSlides(root + "/slides_refs/slides.json");
    ASSERT_GE(lessons.chain.size(), 5U);
    ASSERT_TRUE(check(lessons, slides).ok()) << failuresOf(check(lessons, slides));
    const Tally tally = tamperWithLessons(lessons, slides);
    std::cout << tally.tried << " changes caught, " << tally.exempt << " exempt\n";
    EXPECT_GT(tally.tried, 500);
    EXPECT_GT(tamperWithSlides(lessons, slides), 0);
}

}  // namespace
}  // namespace nuovo::test
