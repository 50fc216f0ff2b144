// The benchmark's programs work, their reports hold what they should, and README shows the last run.
// SPDX-License-Identifier: MIT
#include "bench/scaling/fit.hpp"
#include "bench/summary.hpp"
#include "support/program.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;

// Runs a part as small as it goes and looks at its report; answers the results by name.
std::map<std::string, double> smoke(std::vector<std::string> command, const std::string& part) {
    const support::TemporaryDirectory directory;
    command.insert(command.end(), {directory.path().string(), "--smoke"});
    const support::Outcome outcome = support::run(command, directory.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(support::readFile(directory.file(part + ".csv")), "");
    const Json json = Json::parse(support::readFile(directory.file(part + ".json")), nullptr, false);
    EXPECT_TRUE(json.is_object());
    for (const char* field : {"machine", "driver", "version", "date"})
        EXPECT_NE(json.value(field, ""), "") << field;
    EXPECT_EQ(json.value("part", ""), part);
    EXPECT_GE(json.value("cores", 0), 1);
    std::map<std::string, double> values;
    for (const Json& row : json.value("results", Json::array())) {
        const double value = row.at("value").get<double>();
        EXPECT_TRUE(std::isfinite(value)) << row;
        EXPECT_TRUE(row.at("target").is_null() == row.at("ok").is_null()) << row;
        EXPECT_TRUE(values.emplace(row.at("name").get<std::string>(), value).second) << "twice: " << row;
        if (row.at("unit") == "ms" && part != "toggle") {
            EXPECT_GT(value, 0) << row;
        }
    }
    EXPECT_FALSE(values.empty());
    return values;
}

// No time is judged here: only that the hand-written frames show the lab's picture, and constants that of uniforms.
TEST(Bench, SteadyFramesShowTheSamePicture) {
    const auto values = smoke({"bench_steady"}, "steady");
    EXPECT_LE(values.at("lecture's lights, codes from row (c): uniforms"), 1);
    EXPECT_LE(values.at("64 point lights, codes from row (d): loop over uniforms"), 1);
    EXPECT_EQ(values.at("64 lights, codes from still to moving"), 0);
    EXPECT_EQ(values.at("64 lights, codes from still to --no-skip"), 0);
    EXPECT_EQ(values.at("64 lights, codes from constants to uniforms"), 0);
    EXPECT_EQ(values.at("64 lights, shaders differ between constants and uniforms"), 1)
        << "it compared nothing";
    EXPECT_NEAR(values.at("pixels covered"), 45, 5);
}

TEST(Bench, Scaling) {
    const auto values = smoke({"bench_scaling"}, "scaling");
    for (const char* name : {"pixels 4096", "meshes 10, floor", "triangles 3000", "lights without end 16"})
        EXPECT_EQ(values.count(name), 1U) << name;
}

TEST(Bench, Toggle) {
    const auto values = smoke({"bench_switching", "toggle"}, "toggle");
    for (const char* group : {"toggle, prepared", "toggle, not prepared", "back", "drag a light",
                              "add a light, not prepared", "choose a view, not prepared"}) {
        const std::string name = std::string(group) + ", CPU, ";
        EXPECT_GE(values.at(name + "cold, worst"), values.at(name + "cold, median")) << name;
        EXPECT_GT(values.at(name + "warm, worst"), 0) << name;
        EXPECT_GT(values.at(name + "no cache, worst"), 0) << name;
    }
}

TEST(Bench, Reference) { EXPECT_GT(smoke({"bench_reference"}, "reference").at("reference to bare loop"), 0); }

TEST(Bench, FitsFindTheLineThatPointsLieOn) {
    std::vector<bench::Point> line, power;
    for (const double x : {1.0, 2.0, 5.0, 30.0, 400.0}) {
        line.push_back({x, 3 + 0.25 * x});
        power.push_back({x, 7 * std::pow(x, 0.6)});
    }
    EXPECT_NEAR(bench::fitLine(line).base, 3, 1e-9);
    EXPECT_NEAR(bench::fitLine(line).slope, 0.25, 1e-9);
    EXPECT_NEAR(bench::fitExponent(power), 0.6, 1e-9);
}

TEST(Bench, ReadmeShowsTheCommittedResults) {
    const std::filesystem::path root = LAMBERT_SOURCE_DIR;
    EXPECT_EQ(bench::markedPart(support::readFile(root / "README.md")),
              bench::readmeSection(root / "tests/bench/results", "tests/bench/results"))
        << "tests/bench/run --readme writes this section; it is not edited by hand";
}

TEST(Bench, MarkedPartIsReplacedAndNothingElse) {
    const std::string text = "a\n<!-- bench:begin -->\nold\n<!-- bench:end -->\nb\n";
    EXPECT_EQ(bench::withMarkedPart(text, "new\n"), "a\n<!-- bench:begin -->\nnew\n<!-- bench:end -->\nb\n");
    EXPECT_THROW(bench::markedPart("a\n<!-- bench:end -->\n"), std::runtime_error);
}

}  // namespace
