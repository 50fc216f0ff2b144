// Checks slides_refs/slides.json: every slide with text is there, and its code is really in the lessons.
// SPDX-License-Identifier: MIT
#include "unit/test_slides_refs.hpp"

#include <algorithm>
#include <sstream>

namespace {

using namespace slides_refs;

struct CodeItem {
    Strings cpp;
    std::string lesson;
};

// Fixed here as well, so that slides.json and a lesson cannot drift together.
const std::map<std::string, CodeItem> codeItems{
    {"36.1",
     {{"THREE::MeshLambertMaterial mioMat;", "THREE::Mesh miaMesh(buffers, mioMat);"}, "lesson_01_material"}},
    {"36.2", {{"mioMat.color.set(0xFF8855);"}, "lesson_01_material"}},
    {"36.3", {{"THREE::DirectionalLight miaLuce;", "miaScena.add(miaLuce);"}, "lesson_02_directional_light"}},
    {"36.4",
     {{"miaLuce.color.set(0xFFFFFF);", "miaLuce.position.set(0, 3, -2);"}, "lesson_02_directional_light"}},
    {"37.5", {{"THREE::PointLight luce2;", "miaScena.add(luce2);"}, "lesson_03_point_light"}},
    {"37.6", {{"luce2.color.set(0xDD6666);", "luce2.position.set(2, 1.5, 5);"}, "lesson_03_point_light"}},
    {"43",
     {{"THREE::AmbientLight luceAmbiente(0x101010);", "miaScena.add(luceAmbiente);"}, "lesson_04_ambient"}},
};

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++n;
    }
    return n;
}

// The code of the lines that carry exactly this tag, in file order, without indentation and tag; comments left out.
Strings linesTagged(const std::string& source, const std::string& item) {
    static const std::string mark = "// NUOVO ";
    Strings found;
    std::istringstream stream(source);
    for (std::string line; std::getline(stream, line);) {
        const auto at = line.find(mark);
        if (at != std::string::npos && trimmed(line.substr(at + mark.size())) == item) {
            const auto code = trimmed(line.substr(0, at));
            if (!code.starts_with("//")) {
                found.push_back(code);
            }
        }
    }
    return found;
}

// Whether `lines` holds all of `wanted`, in that order; a lesson may have lines of its own between them.
bool holdsInOrder(const Strings& lines, const Strings& wanted) {
    auto from = lines.begin();
    for (const std::string& line : wanted) {
        from = std::find(from, lines.end(), line);
        if (from == lines.end()) {
            return false;
        }
        ++from;
    }
    return true;
}

TEST(SlidesRefs, EverySlideWithTextOnceInOrderAndInBothLanguages) {
    std::vector<int> numbers;
    for (const json& slide : refs().at("slides")) {
        numbers.push_back(slide.at("number").get<int>());
        expectBilingual(slide.at("title"), slideName(slide) + ".title");
        expectBilingual(slide.at("says"), slideName(slide) + ".says");
    }
    EXPECT_EQ(numbers, slidesWithText);
}

TEST(SlidesRefs, TheRestIsListedAndExplained) {
    std::multiset<int> all(slidesWithText.begin(), slidesWithText.end());
    std::multiset<int> explained;
    const auto without = refs().at("without_text").get<std::vector<int>>();
    all.insert(without.begin(), without.end());
    for (const json& group : refs().at("without_text_why")) {
        expectBilingual(group.at("why"), "without_text_why");
        for (const json& number : group.at("numbers")) {
            explained.insert(number.get<int>());
        }
    }
    std::multiset<int> expected;
    for (int n = refs().at("lecture").at("first_slide"); n <= refs().at("lecture").at("last_slide"); ++n) {
        expected.insert(n);
    }
    EXPECT_EQ(expected.size(), 45U);
    EXPECT_EQ(all, expected);
    EXPECT_EQ(explained, std::multiset<int>(without.begin(), without.end()));
}

TEST(SlidesRefs, EquationsHaveTextAndLatexOrAreNull) {
    std::set<int> withEquation;
    for (const json& slide : refs().at("slides")) {
        const json& equation = slide.at("equation");
        if (equation.is_null()) {
            continue;
        }
        withEquation.insert(slide.at("number").get<int>());
        ASSERT_TRUE(equation.contains("text") && isText(equation["text"])) << slideName(slide);
        ASSERT_TRUE(equation.contains("latex") && isText(equation["latex"])) << slideName(slide);
        const auto latex = equation["latex"].get<std::string>();
        EXPECT_EQ(occurrences(latex, "{"), occurrences(latex, "}")) << slideName(slide) << ": " << latex;
        EXPECT_EQ(occurrences(latex, "\\begin{"), occurrences(latex, "\\end{")) << slideName(slide);
        EXPECT_EQ(occurrences(latex, "\\left("), occurrences(latex, "\\right)")) << slideName(slide);
    }
    // The slides that print a formula, read off the slides' text.
    EXPECT_EQ(withEquation, (std::set<int>{11, 14, 20, 22, 23, 24, 25, 26, 27, 30, 31, 38, 42}));
}

TEST(SlidesRefs, LightingFormulasWriteTheirMax) {
    for (const json& slide : refs().at("slides")) {
        if (!std::set<int>{24, 26, 27, 38, 42}.contains(slide.at("number").get<int>())) {
            continue;
        }
        const auto text = slide.at("equation").at("text").get<std::string>();
        const auto latex = slide.at("equation").at("latex").get<std::string>();
        EXPECT_EQ(occurrences(text, "max(0, n . w"), occurrences(text, "n . w")) << slideName(slide);
        EXPECT_EQ(occurrences(latex, "\\max(0, "), occurrences(text, "max(0, ")) << slideName(slide);
        EXPECT_GT(occurrences(text, "max(0, "), 0U) << slideName(slide);
    }
}

TEST(SlidesRefs, SymbolsUsedAreInTheTableAndAllOfItIsUsed) {
    const json& table = refs().at("symbols");
    std::set<std::string> used;
    std::set<std::string> known;
    for (const json& slide : refs().at("slides")) {
        for (const json& symbol : slide.at("symbols")) {
            used.insert(symbol.get<std::string>());
            EXPECT_TRUE(table.contains(symbol.get<std::string>())) << slideName(slide) << ": " << symbol;
        }
    }
    for (const auto& [name, symbol] : table.items()) {
        known.insert(name);
    }
    EXPECT_EQ(used, known);
}

TEST(SlidesRefs, SymbolsNameTheTermThatSwitchesThem) {
    std::multiset<std::string> named;
    for (const auto& [name, symbol] : refs().at("symbols").items()) {
        expectBilingual(symbol.at("meaning"), "symbol " + name);
        EXPECT_TRUE(isText(symbol.at("latex"))) << name;
        for (const json& term : symbol.at("terms")) {
            const auto termName = term.at("name").get<std::string>();
            ASSERT_TRUE(termKeys.contains(termName)) << name << ": no term is called " << termName;
            EXPECT_EQ(term.at("key").get<int>(), termKeys.at(termName)) << name;
            named.insert(termName);
        }
    }
    for (const auto& [termName, key] : termKeys) {
        EXPECT_TRUE(named.contains(termName)) << "no symbol belongs to term " << key << ", " << termName;
    }
}

TEST(SlidesRefs, CodeItemsEachOnceWithTheirLines) {
    std::multiset<std::string> seen;
    for (const json& slide : refs().at("slides")) {
        const json& lessons = slide.at("lessons");
        for (const json& code : slide.at("code")) {
            const auto item = code.at("item").get<std::string>();
            seen.insert(item);
            ASSERT_TRUE(codeItems.contains(item)) << item;
            EXPECT_EQ(item.substr(0, item.find('.')), slide.at("number").dump()) << item;
            EXPECT_EQ(code.at("cpp").get<Strings>(), codeItems.at(item).cpp) << item;
            EXPECT_EQ(code.at("lesson"), codeItems.at(item).lesson) << item;
            EXPECT_NE(std::find(lessons.begin(), lessons.end(), code.at("lesson")), lessons.end()) << item;
            // One C++ line stands for each line that the slide prints.
            EXPECT_EQ(code.at("lines").size(), code.at("cpp").size()) << item;
            EXPECT_TRUE(std::all_of(code.at("lines").begin(), code.at("lines").end(), isText)) << item;
        }
    }
    std::multiset<std::string> expected;
    for (const auto& [item, code] : codeItems) {
        expected.insert(item);
    }
    EXPECT_EQ(seen, expected);
}

TEST(SlidesRefs, CodeStandsInTheLessonUnderItsTag) {
    for (const json& slide : refs().at("slides")) {
        for (const json& code : slide.at("code")) {
            const auto item = code.at("item").get<std::string>();
            const auto path = "lessons/" + code.at("lesson").get<std::string>() + ".cpp";
            std::string source;
            ASSERT_NO_THROW(source = readText(root + "/" + path))
                << path << " is missing; it must show " << item;
            const auto tagged = linesTagged(source, item);
            EXPECT_TRUE(holdsInOrder(tagged, code.at("cpp").get<Strings>()))
                << path << " must hold, in order and each ending in // NUOVO " << item << ", "
                << code.at("cpp") << "; it has " << json(tagged);
        }
    }
}

TEST(SlidesRefs, ErrataSpeakOfExistingSlidesAndGiveReasons) {
    const std::set<int> numbers(slidesWithText.begin(), slidesWithText.end());
    std::set<int> corrected;
    for (const json& erratum : refs().at("errata")) {
        const auto where = "erratum on slide " + erratum.at("slide").dump();
        EXPECT_TRUE(numbers.contains(erratum.at("slide").get<int>())) << where;
        corrected.insert(erratum.at("slide").get<int>());
        for (const json& other : erratum.at("also")) {
            EXPECT_TRUE(numbers.contains(other.get<int>())) << where << ", also on " << other;
        }
        EXPECT_TRUE(refs().at("errata_kinds").contains(erratum.at("kind").get<std::string>())) << where;
        for (const char* field : {"says", "should_say", "reason"}) {
            expectBilingual(erratum.at(field), where + "." + field);
        }
    }
    // Those that feedback to students relies on, because the slide itself teaches the mistake.
    for (const int slide : {10, 13, 14, 16, 24, 28, 29, 33, 36, 37, 40}) {
        EXPECT_TRUE(corrected.contains(slide)) << "no erratum on slide " << slide;
    }
}

// However often a line occurs, only one of them answers for the slide: not two lessons, and not twice in one.
TEST(SlidesRefs, EachLineOfCodeIsClaimedByOneLessonLine) {
    for (const auto& [item, code] : codeItems) {
        for (const std::string& line : code.cpp) {
            Strings claims;
            for (const auto& [lesson, source] : lessonTexts()) {
                const Strings tagged = linesTagged(source, item);
                claims.insert(claims.end(),
                              static_cast<std::size_t>(std::count(tagged.begin(), tagged.end(), line)),
                              lesson);
            }
            EXPECT_EQ(claims, Strings{code.lesson}) << item << ": " << line;
        }
    }
}

}  // namespace
