// The commands and options that slides.json names are those of the programs, and each option that shows the equation is named.
// SPDX-License-Identifier: MIT
#include "support/program.hpp"
#include "unit/test_slides_refs.hpp"

#include <regex>
#include <sstream>

namespace {

using namespace slides_refs;

/// The long options in a program's --help.
std::set<std::string> optionsOf(const std::string& program) {
    static std::map<std::string, std::set<std::string>> known;
    if (const auto found = known.find(program); found != known.end()) {
        return found->second;
    }
    static const std::regex option(R"(^ +(?:-\w,)?(--[a-z-]+))");
    const support::TemporaryDirectory directory;
    const support::Outcome outcome = support::run({program, "--help"}, directory.path());
    EXPECT_EQ(outcome.status, 0) << program << ": " << outcome.err;
    for (const std::string& line : linesOf(outcome.out)) {
        std::smatch found;
        if (std::regex_search(line, found, option)) {
            known[program].insert(found[1]);
        }
    }
    return known[program];
}

std::set<std::string> optionsIn(const std::string& command) {
    std::istringstream stream(command);
    std::set<std::string> options;
    for (std::string word; stream >> word;) {
        if (word.starts_with("--")) {
            options.insert(word.substr(0, word.find('=')));
        }
    }
    return options;
}

void expectKnown(const std::string& program, const std::string& command, const std::string& where) {
    for (const std::string& option : optionsIn(command)) {
        EXPECT_TRUE(optionsOf(program).contains(option))
            << where << ": " << program << " has no option " << option;
    }
}

// What follows an option is proved by lessons/pictures --check, which draws them all.
TEST(SlidesRefsCommands, PicturesAreDrawnByKnownProgramsWithKnownOptions) {
    json pictures = refs().at("other_pictures");
    for (const json& slide : refs().at("slides")) {
        pictures.insert(pictures.end(), slide.at("pictures").begin(), slide.at("pictures").end());
    }
    EXPECT_GT(pictures.size(), 50U);
    for (const json& picture : pictures) {
        const auto command = picture.at("command").get<std::string>();
        const auto program = command.substr(0, command.find(' '));
        ASSERT_TRUE(lessonTexts().contains(program) || program == "scene_viewer") << command;
        expectKnown(program, command, picture.at("file"));
    }
}

TEST(SlidesRefsCommands, ViewsAreKnownOptions) {
    for (const json& slide : refs().at("slides")) {
        for (const json& view : slide.at("views")) {
            expectKnown("scene_viewer", view.get<std::string>(), slideName(slide));
        }
    }
}

TEST(SlidesRefsCommands, OptionsThatShowTheEquationLeadBackToASlide) {
    // These say where a picture goes, how large it is, or how it is made: no slide speaks of that.
    const std::set<std::string> technical{"--version",     "--light-cut",   "--help",      "--frame",
                                          "--shaders",     "--size",        "--jitter",    "--frames",
                                          "--lang",        "--frames-from", "--no-skip",   "--renderer",
                                          "--dump-shader", "--state",       "--presenter", "--theme"};
    std::set<std::string> named;
    for (const json& slide : refs().at("slides")) {
        for (const json& view : slide.at("views")) {
            named.merge(optionsIn(view.get<std::string>()));
        }
    }
    for (const std::string& option : optionsOf("scene_viewer")) {
        EXPECT_TRUE(technical.contains(option) || named.contains(option))
            << option
            << " leads back to no slide; name it in the views of one, or add it to the technical ones here";
    }
}

}  // namespace
