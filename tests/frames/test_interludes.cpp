// The interludes as programs: the numbers that they read off, their sliders, and their frames against the reference.
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"
#include "image/oiio.hpp"
#include "support/judge.hpp"
#include "support/program.hpp"
#include "three/object_loader.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace {

using support::Outcome;
using support::TemporaryDirectory;
using Arguments = std::vector<std::string>;

constexpr double degree = 3.14159265358979323846 / 180;

// What a frame says on stdout, by label.
std::map<std::string, double> readings(Arguments arguments) {
    const TemporaryDirectory directory;
    arguments.insert(arguments.begin() + 1, {"--frame", "a.png", "--size", "32x32"});
    const Outcome outcome = support::run(arguments, directory.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(directory.contents(), Arguments{"a.png"});
    std::map<std::string, double> values;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.rfind(": ");
        EXPECT_NE(colon, std::string::npos) << line;
        values[line.substr(0, colon)] = std::stod(line.substr(colon + 2));
    }
    return values;
}

TEST(CosineLaw, CountsRaysAsTheSlidesSay) {
    const std::string hits = "rays that hit the front", density = "rays per unit of area";
    for (const auto& [alpha, expected] : {std::pair{0, 50}, {60, 25}, {90, 0}, {120, 0}, {180, 0}}) {
        auto found = readings({"interlude_cosine_law", "--set", "alpha=" + std::to_string(alpha)});
        ASSERT_EQ(found.size(), 4U);
        EXPECT_EQ(found[hits], expected) << alpha;
        EXPECT_EQ(found[density], expected / 4.0);
        EXPECT_NEAR(found["n · ω = cos(alpha)"], std::cos(alpha * degree), 1e-4);
    }
    EXPECT_EQ(readings({"interlude_cosine_law", "--set", "alpha=20", "--time", "2"})[hits], 25)
        << "20 degrees a second";
}

// The patch is shaded with the number that the rays are counted for: its colour is D times the cosine.
TEST(CosineLaw, ThePatchHasTheSameCosine) {
    for (const double alpha : {0.0, 30.0, 60.0, 75.0}) {
        const TemporaryDirectory directory;
        ASSERT_EQ(support::run(
                      {"interlude_cosine_law", "--frame", "a.exr", "--set", "alpha=" + std::to_string(alpha)},
                      directory.path())
                      .status,
                  0);
        const image::Frame frame = image::readFrame(directory.file("a.exr"));
        const auto& floats = std::get<image::Floats>(frame.pixels);
        int patch = 0;
        for (std::size_t i = 0; i < floats.size(); i += 3)
            patch += std::abs(floats[i] - std::cos(alpha * degree)) < 1e-5 &&
                     std::abs(floats[i + 1] - std::cos(alpha * degree) * 0x88 / 255) < 1e-5;
        EXPECT_GT(patch, 1000) << alpha;
    }
}

TEST(Brdf, LambertSendsBackItsAlbedoAndTheSameEverywhere) {
    for (const char* theta : {"theta_i=0", "theta_i=60", "theta_i=85"}) {
        auto found = readings({"interlude_brdf", "--set", "k=0", "--set", "a=0.8", "--set", theta});
        EXPECT_NEAR(found["f_r(ω_i, ω_r)"], 0.8 / 3.14159265, 1e-4);
        EXPECT_EQ(found["photons sent back, of 100"], 80);
        EXPECT_EQ(found["photons absorbed"], 20);
        EXPECT_EQ(found["share sent back, summed up"], 0.8);
        EXPECT_EQ(found["share sent back, closed form"], 0.8);
    }
    EXPECT_EQ(readings({"interlude_brdf", "--set", "k=0", "--set", "a=0"})["photons sent back, of 100"], 0);
}

TEST(Brdf, PhongHasItsPeakAtTheMirrorAndMoreThanArrives) {
    const auto ring = [](const char* theta) {
        return readings({"interlude_brdf", "--set", "a=0", "--set", "k=1", "--set", "s=20", "--set",
                         "theta_i=60", "--set", theta})["photons into the ring"];
    };
    EXPECT_GE(ring("theta_r=60"), 4);
    EXPECT_EQ(ring("theta_r=10"), 0);
    // What the header tells people to try.
    auto found =
        readings({"interlude_brdf", "--set", "theta_i=80", "--set", "k=1", "--set", "s=3", "--set", "a=0.5"});
    EXPECT_EQ(found["photons sent back, of 100"], 121);
    EXPECT_EQ(found["photons absorbed"], -21);
    EXPECT_NEAR(found["share sent back, summed up"], found["share sent back, closed form"], 1e-3);
}

class Interlude : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Both, Interlude, testing::Values("interlude_brdf", "interlude_cosine_law"),
                         [](const auto& test) { return test.param; });

TEST_P(Interlude, TheDriversFrameIsTheReferences) {
    for (const char* time : {"0", "1.3", "4"}) {
        const TemporaryDirectory directory;
        const Outcome dumped =
            support::run({GetParam(), "--dump-scene", "scene.json", "--time", time}, directory.path());
        ASSERT_EQ(dumped.status, 0) << dumped.err;
        THREE::LoadedScene loaded = THREE::ObjectLoader().load(directory.file("scene.json"));
        support::DrawOptions options;
        options.width = 320;
        options.height = 320;
        support::lookAt(*loaded.camera, {0, 0.7, 0}, options);
        const support::Judgement j = support::judge(*loaded.scene, *loaded.camera, options);
        std::cout << GetParam() << " at " << time << " s: " << describe(j) << '\n';
        EXPECT_LE(j.codes, 1) << describe(j);
        EXPECT_LE(j.worst, 3e-5) << describe(j);  // 4 times the 7.5e-6 measured on llvmpipe
        EXPECT_LE(j.maskedShare(), 0.25) << describe(j);  // thin rays are all edges
    }
}

TEST_P(Interlude, SlidersStandInThePictureAndTheStats) {
    const TemporaryDirectory directory;
    const std::string change = GetParam() == "interlude_brdf" ? "theta_i=12.5" : "alpha=12.5";
    const Outcome outcome = support::run(
        {GetParam(), "--frame", "a.png", "--set", change, "--stats", "--size", "64x64"}, directory.path());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json stats = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(stats["sliders"][change.substr(0, change.find('='))], 12.5);
    EXPECT_GE(stats["readings"].size(), 4U);
    EXPECT_TRUE(stats["readings"][0]["value"].is_number());
    std::string sliders;
    for (const auto& [key, value] : image::readMetadata(directory.file("a.png")))
        sliders += key == "sliders" ? value : "";
    EXPECT_NE(sliders.find(change), std::string::npos) << sliders;
}

TEST_P(Interlude, SpeaksItalianToo) {
    const TemporaryDirectory directory;
    const Outcome outcome =
        support::run({GetParam(), "--frame", "a.png", "--size", "32x32", "--lang", "it"}, directory.path());
    EXPECT_NE(outcome.out.find(GetParam() == "interlude_brdf" ? "fotoni" : "raggi"), std::string::npos)
        << outcome.out;
}

}  // namespace
