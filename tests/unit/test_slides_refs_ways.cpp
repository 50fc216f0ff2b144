// slides_refs/slides.json leads from every slide to lessons, terms, views or lines, and each of those leads back.
// SPDX-License-Identifier: MIT
#include "lighting/views.hpp"
#include "unit/test_slides_refs.hpp"

#include <regex>

namespace {

using namespace slides_refs;

// "9-15, 36.1-36.2, 39" -> 9, 10, ..., 15, 36, 39; numbers of slides without text are left out.
std::set<int> slidesIn(const std::string& list) {
    static const std::regex range(R"((\d+)(?:\.\d+)?(?:-(\d+)(?:\.\d+)?)?)");
    std::set<int> numbers;
    for (std::sregex_iterator at(list.begin(), list.end(), range), end; at != end; ++at) {
        const int first = std::stoi((*at)[1]);
        const int last = (*at)[2].matched ? std::stoi((*at)[2]) : first;
        for (const int slide : slidesWithText) {
            if (slide >= first && slide <= last) {
                numbers.insert(slide);
            }
        }
    }
    return numbers;
}

TEST(SlidesRefsWays, EverySlideLeadsSomewhere) {
    for (const json& slide : refs().at("slides")) {
        EXPECT_FALSE(slide.at("lessons").empty()) << slideName(slide);
        EXPECT_FALSE(slide.at("views").empty()) << slideName(slide) << ": no option or key shows it";
    }
}

TEST(SlidesRefsWays, LessonsExistAndAllAreReached) {
    std::set<std::string> reached;
    std::set<std::string> existing;
    for (const json& slide : refs().at("slides")) {
        for (const json& lesson : slide.at("lessons")) {
            reached.insert(lesson.get<std::string>());
        }
    }
    for (const auto& [lesson, text] : lessonTexts()) {
        existing.insert(lesson);
    }
    EXPECT_EQ(reached, existing);
}

TEST(SlidesRefsWays, SlidesOfALessonsHeaderNameIt) {
    for (const auto& [lesson, text] : lessonTexts()) {
        std::set<int> slides;
        for (const std::string& line : linesOf(text)) {
            if (line.starts_with("// Slides ") && slides.empty()) {
                slides = slidesIn(line);
            }
        }
        EXPECT_FALSE(slides.empty()) << lesson << ".cpp has no line such as \"// Slides 9-15\"";
        for (const int number : slides) {
            EXPECT_TRUE(holds(slideOf(number).at("lessons"), lesson))
                << lesson << ".cpp says that it is about slide " << number << "; add it there in slides.json";
        }
    }
}

TEST(SlidesRefsWays, SlidesOfNewLinesNameTheirLesson) {
    static const std::regex tag(R"(// NUOVO (\d+)(\.\d+)?$)");
    for (const auto& [lesson, text] : lessonTexts()) {
        for (const std::string& line : linesOf(text)) {
            std::smatch found;
            if (!std::regex_search(line, found, tag)) {
                continue;
            }
            const json slide = slideOf(std::stoi(found[1]));
            EXPECT_TRUE(holds(slide.at("lessons"), lesson)) << lesson << ": " << line;
            if (!found[2].matched) {
                continue;
            }
            bool isClaimed = false;
            for (const json& code : slide.at("code")) {
                isClaimed = isClaimed || (code.at("item") == found[1].str() + found[2].str() &&
                                          code.at("lesson") == lesson);
            }
            EXPECT_TRUE(isClaimed) << lesson << ": " << line;
        }
    }
}

// A term's file opens with "// TERM name | slides 14, 27 | ...".
TEST(SlidesRefsWays, SlidesOfATermNameIt) {
    static const std::regex head(R"(// TERM (\w+) \| slides? ([^|]+) \|.*)");
    std::set<std::string> known;
    for (const auto& entry : std::filesystem::directory_iterator(root + "/shaders/terms")) {
        const std::string file = entry.path().string();
        std::smatch found;
        const std::string first = linesOf(readText(file)).at(0);
        ASSERT_TRUE(std::regex_match(first, found, head)) << file << ": " << first;
        const std::string term = found[1];
        known.insert(term);
        EXPECT_EQ(refs().at("term_lines").at(term).at("file"),
                  "shaders/terms/" + entry.path().filename().string());
        const std::set<int> slides = slidesIn(found[2]);
        EXPECT_FALSE(slides.empty()) << first;
        for (const int number : slides) {
            EXPECT_TRUE(holds(slideOf(number).at("terms"), term))
                << file << " cites slide " << number << "; add " << term << " to its terms in slides.json";
        }
    }
    std::set<std::string> expected;
    for (const auto& [term, key] : termKeys) {
        expected.insert(term);
    }
    EXPECT_EQ(known, expected);
}

// Keys that change how the equation is evaluated or seen, as the window has them; "views" hold nothing but keys, the window's views,
// options and scene_viewer.
TEST(SlidesRefsWays, EveryKeyOfTheWindowThatShowsTheEquationIsNamed) {
    std::set<std::string> named;
    for (const json& slide : refs().at("slides")) {
        for (const json& view : slide.at("views")) {
            const auto text = view.get<std::string>();
            if (text.starts_with("key ")) {
                named.insert(text.substr(4));
            } else {
                EXPECT_TRUE(text.starts_with("--") || text.starts_with("view ") || text == "scene_viewer")
                    << slideName(slide) << ": " << text;
            }
        }
    }
    const std::set<std::string> expected{"1", "2", "3", "4", "5",   "6", "7", "8", "9", "G", "X",
                                         "N", "B", "K", "C", "Tab", "P", "I", "H", "O", "/"};
    EXPECT_EQ(named, expected);
}

// A view of the window is named by the slides that its table says it belongs to, and by no others.
TEST(SlidesRefsWays, ViewsAndSlidesLeadToEachOther) {
    std::map<std::string, std::set<int>> named;
    for (const json& slide : refs().at("slides")) {
        for (const json& view : slide.at("views")) {
            if (const auto text = view.get<std::string>(); text.starts_with("view ")) {
                named[text.substr(5)].insert(slide.at("number").get<int>());
            }
        }
    }
    std::set<std::string> known;
    for (const lighting::ViewInfo& row : lighting::views()) {
        known.insert(row.name);
        const std::set<int> slides = slidesIn(row.slides);
        for (const int slide : named[row.name]) {
            EXPECT_TRUE(slides.contains(slide)) << "slide " << slide << " names view " << row.name;
        }
        EXPECT_TRUE(!named[row.name].empty() || slides.empty()) << row.name << " is named by no slide";
    }
    for (const auto& [name, slides] : named) {
        EXPECT_TRUE(known.contains(name)) << name << " is no view";
    }
}

}  // namespace
