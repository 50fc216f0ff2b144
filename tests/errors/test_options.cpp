// The command line without a process: what it gives, and why a program would leave.
// SPDX-License-Identifier: MIT
#include "lab/options.hpp"
#include "lab/switches.hpp"

#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace {

using Arguments = std::vector<std::string>;

lab::Options options(const Arguments& arguments, bool file = false) {
    const auto parsed = lab::parseOptions(arguments, "lesson", file);
    if (const auto* ending = std::get_if<lab::Ending>(&parsed)) {
        ADD_FAILURE() << "expected options, found the end: " << ending->out << ending->err;
        return {};
    }
    return std::get<lab::Options>(parsed);
}

lab::Ending ending(const Arguments& arguments, bool file = false) {
    const auto parsed = lab::parseOptions(arguments, "lesson", file);
    const auto* found = std::get_if<lab::Ending>(&parsed);
    EXPECT_NE(found, nullptr) << "expected the end, found options";
    return found != nullptr ? *found : lab::Ending{-1, "", ""};
}

TEST(ParseOptions, GivesWhatWasSaid) {
    const lab::Options all = options(
        {"--size", "20x10", "--time=-1.5", "--renderer", "reference", "--lang", "it", "a.json"}, true);
    EXPECT_EQ(all.lesson, "lesson");
    EXPECT_EQ(all.width, 20);
    EXPECT_EQ(all.height, 10);
    EXPECT_EQ(all.time, -1.5);
    EXPECT_EQ(all.renderer, lab::RendererKind::reference);
    EXPECT_EQ(all.language, lab::Language::it);
    EXPECT_EQ(all.sceneFile, "a.json");
    EXPECT_EQ(options({}).renderer, lab::RendererKind::gl);
    EXPECT_EQ(options({"--renderer=gl"}).renderer, lab::RendererKind::gl);
}

TEST(ParseOptions, ReadsTheCut) {
    EXPECT_EQ(options({}).lightCut, 0);
    EXPECT_EQ(options({"--light-cut", "0.5"}).lightCut, 0.5);
    for (const char* wrong : {"-1", "256", "nan", "1e400", "half"})
        EXPECT_NE(ending({"--light-cut", wrong}).err.find(std::string("--light-cut: expected ")),
                  std::string::npos)
            << wrong;
}

TEST(ParseOptions, ReadsTheSwitches) {
    const lighting::Switches usual = options({}).switches;
    EXPECT_EQ(usual, lighting::Switches());
    const lighting::Switches all = options({"--terms", "-clamp", "--shading", "vertex", "--space=view",
                                            "--normal-matrix", "model", "--specular", "blinn"})
                                       .switches;
    EXPECT_EQ(all.terms, lighting::TermSet::all().without(lighting::Term::clamp));
    EXPECT_EQ(all.shading, lighting::Shading::vertex);
    EXPECT_EQ(all.space, lighting::Space::view);
    EXPECT_EQ(all.normals, lighting::NormalTransform::model);
    EXPECT_EQ(all.specular, THREE::SpecularModel::blinn);
    EXPECT_EQ(lab::switchesText(all), "--shading vertex --space view --normal-matrix model --specular blinn");
    EXPECT_EQ(lab::switchesText(usual), "");
    EXPECT_EQ(ending({"--shading", "face"}).err,
              "lesson: --shading: expected pixel|vertex|flat, found 'face'\n"
              "See lesson --help for what is understood.\n");
}

// What a key does: on to the next, and round again.
TEST(Switches, GoRound) {
    for (const lab::Switch& row : lab::switchTable()) {
        lighting::Switches switches;
        std::vector<std::string> seen;
        for (std::size_t i = 0; i < row.choices.size() + 1; ++i) {
            seen.emplace_back(row.now(switches).en);
            row.next(switches);
            if (switches == lighting::Switches())
                break;
        }
        EXPECT_EQ(switches, lighting::Switches()) << row.option;
        EXPECT_GE(seen.size(), row.choices.size()) << row.option;
        EXPECT_EQ(std::set<std::string>(seen.begin(), seen.end()).size(), seen.size()) << row.option;
    }
}

TEST(ParseOptions, EndsWithWhatWasAsked) {
    for (const char* const asked : {"--help", "--version", "--list-terms"}) {
        const lab::Ending end = ending({asked}, true);
        EXPECT_EQ(end.status, 0);
        EXPECT_NE(end.out, "") << asked;
        EXPECT_EQ(end.err, "") << asked;
    }
    EXPECT_NE(ending({"--help"}).out.find("no driver or display needed"), std::string::npos);
    EXPECT_NE(ending({"-h", "--lang=it"}).out.find("senza scheda né schermo"), std::string::npos);
}

TEST(ParseOptions, EndsWithWhatIsWrong) {
    const lab::Ending end = ending({"--renderer", "0"});
    EXPECT_EQ(end.status, 2);
    EXPECT_EQ(end.out, "");
    EXPECT_EQ(end.err, "lesson: --renderer: expected gl or reference, found '0'\n"
                       "See lesson --help for what is understood.\n");
    EXPECT_EQ(ending({}, true).status, 2) << "no scene file";
}

}  // namespace
