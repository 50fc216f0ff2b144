// slides_refs/misconceptions.json says something of everything that the catalogue names, in both languages, without giving the
// answer away; and a broken file of texts is told where it is broken.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/misconceptions.hpp"
#include "grader/catalogue/texts.hpp"
#include "lighting/terms.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace {

using grader::BothLanguages;
using grader::MisconceptionText;
using grader::Texts;
using nlohmann::json;

const std::filesystem::path refs = LAMBERT_SOURCE_DIR "/slides_refs";

const Texts& texts() {
    static const Texts all(refs / "misconceptions.json");
    return all;
}

// All texts of misconceptions and of classes.
std::vector<MisconceptionText> allTexts() {
    std::vector<MisconceptionText> all = texts().misconceptions();
    all.insert(all.end(), texts().classes().begin(), texts().classes().end());
    return all;
}

TEST(Texts, AreThereForEveryWrongRowOfTheCatalogueAndForNoOther) {
    std::set<std::string> wrong, told;
    for (const grader::Misconception& row : grader::misconceptions())
        if (!row.right)
            wrong.insert(row.id);
    for (const MisconceptionText& text : texts().misconceptions())
        told.insert(text.ids.front());
    EXPECT_EQ(told, wrong);
    EXPECT_EQ(texts().misconception("A1").check, "clamp");
    EXPECT_THROW(texts().misconception("R1"), std::out_of_range);
    EXPECT_THROW(texts().check("R1"), std::out_of_range);
}

TEST(Texts, AreThereForEveryClassAndForNoOther) {
    EXPECT_EQ(texts().classes().size(), grader::misconceptionClasses().size());
    for (const grader::MisconceptionClass& c : grader::misconceptionClasses()) {
        EXPECT_EQ(texts().textOf(c.ids).ids.size(), c.ids.size());
        EXPECT_EQ(&texts().textOf({c.ids.rbegin(), c.ids.rend()}), &texts().textOf(c.ids));
        EXPECT_EQ(&texts().textOf({c.ids[0]}), &texts().misconception(c.ids[0]));
    }
    EXPECT_THROW(texts().textOf({"A1", "A2"}), std::out_of_range);
}

// Every check is the lab's name for a term, or one of three more; and each has a misconception that costs it.
TEST(Texts, KnowTheChecks) {
    std::set<std::string> known{"sum", "normals", "colours"}, found, costing;
    for (const lighting::TermInfo& term : lighting::terms())
        known.insert(term.name);
    for (const grader::CheckText& check : texts().checks())
        EXPECT_TRUE(found.insert(check.id).second) << check.id;
    EXPECT_EQ(found, known);
    for (const MisconceptionText& text : allTexts())
        costing.insert(text.check);
    EXPECT_EQ(costing, known);
}

// A class that no picture splits, whatever the scene, must cost one check; so must one that lessons 02 to 08 cannot split.
TEST(Texts, CostTheSameWhereNoPictureCanSplit) {
    for (const auto& [one, other] : {std::pair("D2", "D3"), std::pair("B3", "B5")}) {
        EXPECT_EQ(texts().misconception(one).check, texts().misconception(other).check)
            << one << ' ' << other;
        EXPECT_EQ(texts().textOf({one, other}).check, texts().misconception(one).check)
            << one << ' ' << other;
    }
}

TEST(Texts, SendToSlidesThatHaveText) {
    std::ifstream in(refs / "slides.json");
    const json data = json::parse(in);
    std::set<int> slides;
    for (const json& slide : data.at("slides"))
        slides.insert(slide.at("number").get<int>());
    const auto expectKnown = [&](const std::string& id, const std::vector<int>& numbers) {
        EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end())) << id;
        for (const int number : numbers)
            EXPECT_TRUE(slides.contains(number)) << id << " sends to slide " << number;
    };
    for (const MisconceptionText& text : allTexts())
        expectKnown(text.ids.front(), text.slides);
    for (const grader::CheckText& check : texts().checks())
        expectKnown(check.id, check.slides);
}

// What would be the solution, or a part of it, in code or as a formula. Blanks do not count.
TEST(Texts, DoNotGiveTheAnswerAway) {
    for (const MisconceptionText& text : allTexts())
        for (std::string words : {text.hint.it, text.hint.en, text.name.it, text.name.en}) {
            words.erase(std::remove_if(words.begin(), words.end(),
                                       [](unsigned char c) { return std::isspace(c) != 0; }),
                        words.end());
            for (const char* answer :
                 {"max(", "dot(", "pow(", "normalize(", "reflect(", "inverse(", "transpose(", "length(", "0x",
                  "#", "P_L-Q", "D(x)L", "L_A*", "d^", "L.rgb", "trasposta"})
                EXPECT_EQ(words.find(answer), std::string::npos) << text.ids.front() << ": " << answer;
        }
}

// A hint is one to three sentences, a name a clause without a full stop.
TEST(Texts, AreShort) {
    for (const MisconceptionText& text : allTexts()) {
        for (const std::string& hint : {text.hint.it, text.hint.en})
            EXPECT_TRUE(hint.size() < 330 && (hint.ends_with('.') || hint.ends_with('?')))
                << text.ids.front() << hint;
        for (const std::string& name : {text.name.it, text.name.en})
            EXPECT_TRUE(name.size() < 130 && !name.ends_with('.')) << text.ids.front();
        EXPECT_NE(text.hint.it, text.hint.en) << text.ids.front();
    }
}

// The message for the project's file after `change`.
template <class Change>
std::string complaint(const Change& change) {
    std::ifstream in(refs / "misconceptions.json");
    json data = json::parse(in);
    change(data);
    const std::filesystem::path file = testing::TempDir() + "broken_texts.json";
    std::ofstream(file) << data;
    try {
        const Texts broken(file);
    } catch (const std::runtime_error& e) {
        return std::string(e.what()).substr(file.string().size());
    }
    return "";
}

TEST(Texts, SayWhereTheFileIsBroken) {
    EXPECT_EQ(complaint([](json&) {}), "");
    EXPECT_EQ(complaint([](json& data) { data["misconceptions"][0]["hint"]["it"] = ""; }),
              ": $.misconceptions[0].hint.it: expected a text that is not empty, found \"\"");
    EXPECT_EQ(complaint([](json& data) { data["misconceptions"][0]["check"] = "clam"; }),
              ": $.misconceptions[0].check: expected the id of one of the checks, found \"clam\"");
    EXPECT_EQ(complaint([](json& data) { data["misconceptions"][0]["slides"][0] = "23"; }),
              ": $.misconceptions[0].slides[0]: expected a slide's number, found \"23\"");
    EXPECT_EQ(complaint([](json& data) { data["misconceptions"][1]["id"] = "A1"; }),
              ": $.misconceptions[1].id: expected an id of its own, found \"A1\"");
    EXPECT_EQ(complaint([](json& data) { data["checks"][1].erase("title"); }).substr(0, 49),
              ": $.checks[1]: expected an object with \"title\", f");
    EXPECT_EQ(complaint([](json& data) { data = 3; }), ": $: expected an object with \"checks\", found 3");
    EXPECT_EQ(complaint([](json& data) { data["classes"] = json::array(); }),
              ": $.classes: expected a list that is not empty, found []");
    EXPECT_THROW(Texts("no such file"), std::runtime_error);
}

}  // namespace
