// --frames-from without a process: lines, their words, and the options that they give.
// SPDX-License-Identifier: MIT
#include "lab/failure.hpp"
#include "lab/frame_lines.hpp"
#include "lab/options.hpp"
#include "lab/phases.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>
#include <thread>

namespace {

using Words = std::vector<std::string>;

// What is wrong, or an empty text.
template <class Work>
std::string complaint(const Work& work) {
    try {
        work();
    } catch (const lab::UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(SplitWords, AsAShellDoes) {
    const std::vector<std::pair<const char*, Words>> cases{
        {"", {}},
        {" \t ", {}},
        {"# all of it", {}},
        {"a b  c\t", {"a", "b", "c"}},
        {"a# b #c 'd", {"a#", "b"}},
        {"'a b' \"c d\"", {"a b", "c d"}},
        {"a'b 'c\" d\"", {"ab c d"}},
        {"'' \"\"", {"", ""}},
        {"'#' \"#\" \\#", {"#", "#", "#"}},
        {"a\\ b \\\\ \\'", {"a b", "\\", "'"}},
        {R"('a\b' "a\b" "\"\\" '"' "'")", {"a\\b", "a\\b", "\"\\", "\"", "'"}},
        {"$HOME * ~ `x` ;", {"$HOME", "*", "~", "`x`", ";"}},
        {"\xFF\xC3 \xE2\x82\xAC", {"\xFF\xC3", "\xE2\x82\xAC"}},
    };
    for (const auto& [line, words] : cases)
        EXPECT_EQ(lab::splitWords(line), words) << line;
}

TEST(SplitWords, SaysWhatIsWrong) {
    const auto wrong = [](std::string_view line) { return complaint([&] { lab::splitWords(line); }); };
    EXPECT_NE(wrong("--frame 'a.png").find("found a ' without its end"), std::string::npos);
    EXPECT_NE(wrong("--frame \"a.png\\\"").find("found a \" without its end"), std::string::npos);
    EXPECT_NE(wrong("--frame a.png \\").find("backslash"), std::string::npos);
    EXPECT_NE(wrong({"a\0b", 3}).find("NUL"), std::string::npos);
}

TEST(LineReader, GivesLinesWhateverTheirEnds) {
    const support::TemporaryDirectory directory;
    const std::string file = directory.file("lines");
    const std::string most(lab::LineReader::longest, 'x');
    support::writeFile(file, "\xEF\xBB\xBFone\r\n\n" + most + "\n" + most + "yz\n\rlast\r");
    lab::LineReader lines(file);
    std::string line;
    EXPECT_EQ(lines.share(), 0);
    const std::vector<std::pair<std::string, bool>> expected{
        {"one", false}, {"", false}, {most, false}, {most, true}, {"\rlast", false}};
    for (const auto& [text, tooLong] : expected) {
        ASSERT_TRUE(lines.next(line));
        EXPECT_EQ(line, text) << lines.place();
        EXPECT_EQ(lines.isTooLong(), tooLong) << lines.place();
    }
    EXPECT_FALSE(lines.next(line));
    EXPECT_EQ(lines.place(), file + ":5");
    EXPECT_EQ(lines.share(), 1);
}

TEST(ParseFrameLine, StandsOnTopOfTheCommandLine) {
    const Words arguments{"--frames-from",  "f",     "--size",    "64x32",   "--decay", "1",
                          "--set",          "a=1",   "--no-skip", "--terms", "-clamp",  "--camera",
                          "1,2,3,0,0,0,30", "x.json"};
    const lab::Options base = std::get<lab::Options>(lab::parseOptions(arguments, "lesson", true));
    ASSERT_EQ(base.framesFrom, "f");
    EXPECT_FALSE(base.wantsWindow());
    const lab::Options same = lab::parseFrameLine(Words{"--frame", "a.png"}, base);
    EXPECT_EQ(same.lesson, "lesson");
    EXPECT_EQ(same.sceneFile, "x.json");
    EXPECT_EQ(same.framesFrom, "");
    EXPECT_EQ(same.frame, "a.png");
    EXPECT_EQ(same.width, 64);
    EXPECT_EQ(same.decay, 1);
    EXPECT_EQ(same.set, Words{"a=1"});
    EXPECT_FALSE(same.skip);
    EXPECT_FALSE(same.stats);
    EXPECT_TRUE(same.camera && same.camera->fov == 30);
    EXPECT_EQ(same.switches, base.switches);
    const lab::Options other =
        lab::parseFrameLine(Words{"--frame=b.exr", "--size", "8x4", "--set", "b=2", "--stats", "--terms",
                                  "-cosine", "--camera", "3,2,1,0,0,0"},
                            base);
    EXPECT_EQ(other.width, 8);
    EXPECT_EQ(other.set, (Words{"a=1", "b=2"}));
    EXPECT_TRUE(other.stats);
    EXPECT_TRUE(other.camera && !other.camera->fov);
    EXPECT_EQ(other.switches.terms, lighting::TermSet::all().without(lighting::Term::cosine))
        << "--terms is about the lesson's terms, wherever it stands";
}

TEST(ParseFrameLine, RefusesWhatIsNotAboutOneFrame) {
    const lab::Options base;
    const auto wrong = [&base](Words words) {
        words.insert(words.begin(), {"--frame", "a.png"});
        return complaint([&] { lab::parseFrameLine(words, base); });
    };
    for (const Words& words :
         {Words{"--frames-from", "x"}, Words{"--frames", "3"}, Words{"--dump-scene", "s.json"},
          Words{"--dump-shader"}, Words{"--list-terms"}})
        EXPECT_NE(wrong(words).find("found " + words[0] + ", which is not about one frame"),
                  std::string::npos)
            << wrong(words);
    for (const char* asked : {"--help", "-h", "--version"})
        EXPECT_NE(wrong({asked}).find("--help or --version"), std::string::npos) << asked;
    EXPECT_NE(wrong({"x.json"}).find("x.json"), std::string::npos) << "the scene is the command line's";
    EXPECT_NE(wrong({"--size", "0x1"}).find("1 to 8192"), std::string::npos);
    EXPECT_NE(complaint([&] {
                  lab::parseFrameLine(Words{"--time", "1"}, base);
              }).find("--frame FILE"),
              std::string::npos);
    EXPECT_EQ(wrong({"--time", "1"}), "");
}

TEST(ParseOptions, FramesFromStandsAlone) {
    for (const Words& words : {Words{"--frame", "a.png"}, Words{"--frames", "3"},
                               Words{"--dump-scene", "s.json"}, Words{"--dump-shader"}}) {
        Words all{"--frames-from", "f"};
        all.insert(all.end(), words.begin(), words.end());
        const auto parsed = lab::parseOptions(all, "lesson", false);
        const auto* ending = std::get_if<lab::Ending>(&parsed);
        ASSERT_NE(ending, nullptr) << words[0];
        EXPECT_EQ(ending->status, 2);
        EXPECT_NE(ending->err.find("--frames-from"), std::string::npos) << ending->err;
    }
}

TEST(Phases, AddUpToTheTimeThatPassed) {
    const auto start = std::chrono::steady_clock::now();
    lab::Phases phases;
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    phases.mark("a");
    phases.mark("b");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    phases.mark("a");
    const double all =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ASSERT_EQ(phases.all().size(), 2U);
    EXPECT_STREQ(phases.all()[0].first, "a");
    EXPECT_GE(phases.all()[0].second, 5);
    EXPECT_LE(phases.all()[0].second + phases.all()[1].second, all);
    phases.restart();
    EXPECT_TRUE(phases.all().empty());
}

}  // namespace
