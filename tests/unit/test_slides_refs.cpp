// Checks slides_refs/: every slide with text is there, its code is really in the lessons, its README shows the same.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using nlohmann::json;
using Strings = std::vector<std::string>;

const std::string root = LAMBERT_SOURCE_DIR;

// The slides whose text says something; the others of 1-45 are title pages, pictures, or missing from the extract.
const std::vector<int> slidesWithText{3,  4,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18, 20, 22, 23, 24, 25, 26,
                                      27, 28, 29, 30, 31, 32, 33, 34, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45};

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

const std::set<std::string> lessonNames{
    "lesson_00_scene",       "lesson_01_material",     "lesson_02_directional_light",
    "lesson_03_point_light", "lesson_04_ambient",      "lesson_05_attenuation",
    "lesson_06_many_lights", "lesson_07_normal_space", "lesson_08_shading_frequency",
    "lesson_09_phong",       "interlude_brdf",         "interlude_cosine_law"};

const std::map<std::string, int> termKeys{{"albedo", 1},      {"cosine", 2},      {"clamp", 3},
                                          {"light_color", 4}, {"attenuation", 5}, {"directional", 6},
                                          {"point", 7},       {"ambient", 8},     {"specular", 9}};

std::string readText(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("cannot read " + path);
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

const json& refs() {
    static const json document = json::parse(readText(root + "/slides_refs/slides.json"));
    return document;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool isText(const json& value) { return value.is_string() && !trimmed(value.get<std::string>()).empty(); }

// Both languages, both with something in them.
void expectBilingual(const json& value, const std::string& where) {
    ASSERT_TRUE(value.is_object()) << where;
    EXPECT_TRUE(value.contains("it") && isText(value["it"])) << where << ".it";
    EXPECT_TRUE(value.contains("en") && isText(value["en"])) << where << ".en";
}

std::string slideName(const json& slide) { return "slide " + slide.at("number").dump(); }

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

// How README.md opens an erratum's row: all its slides, and its kind unless it stands among the misprints.
std::string erratumRow(const json& erratum) {
    std::set<int> numbers = erratum.at("also").get<std::set<int>>();
    numbers.insert(erratum.at("slide").get<int>());
    std::string row = "|";
    std::string separator = " ";
    for (const int number : numbers) {
        row += std::exchange(separator, ", ") + std::to_string(number);
    }
    const auto kind = erratum.at("kind").get<std::string>();
    return kind == "misprint" ? row : row + " | " + kind;
}

// README.md with table cells unescaped, so that a formula's bars compare equal.
std::string readmeText() {
    std::string text = readText(root + "/slides_refs/README.md");
    for (auto at = text.find("\\|"); at != std::string::npos; at = text.find("\\|", at)) {
        text.erase(at, 1);
    }
    return text;
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

TEST(SlidesRefs, LessonsAreKnownTargets) {
    std::set<std::string> reached;
    for (const json& slide : refs().at("slides")) {
        EXPECT_FALSE(slide.at("lessons").empty()) << slideName(slide);
        for (const json& lesson : slide.at("lessons")) {
            reached.insert(lesson.get<std::string>());
            EXPECT_TRUE(lessonNames.contains(lesson.get<std::string>()))
                << slideName(slide) << ": " << lesson;
        }
    }
    EXPECT_EQ(reached, lessonNames) << "a lesson that no slide leads to";
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

TEST(SlidesRefs, ReadmeShowsTheSameSlidesAndErrata) {
    const auto readme = readmeText();
    const auto shows = [&readme](const std::string& text) { return readme.find(text) != std::string::npos; };
    for (const json& slide : refs().at("slides")) {
        std::string row =
            "| " + slide.at("number").dump() + " | " + slide.at("title").at("en").get<std::string>();
        std::string separator = " | `";
        for (const json& lesson : slide.at("lessons")) {
            row += std::exchange(separator, ", `") + lesson.get<std::string>() + "`";
        }
        row += " |";
        if (!slide.at("equation").is_null()) {
            row += " `" + slide.at("equation").at("text").get<std::string>() + "` |";
        }
        EXPECT_TRUE(shows(row)) << "README.md lacks the row " << row;
    }
    for (const json& erratum : refs().at("errata")) {
        std::string row = erratumRow(erratum);
        for (const char* field : {"says", "should_say", "reason"}) {
            row += " | " + erratum.at(field).at("en").get<std::string>();
        }
        EXPECT_TRUE(shows(row)) << "README.md lacks the erratum on slide " << erratum.at("slide") << ":"
                                << row;
    }
}

}  // namespace
