// The lessons as programs: their frames are what their headers say, repeatable, and the same through a scene file.
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"
#include "image/oiio.hpp"
#include "support/program.hpp"
#include "three/object_loader.hpp"
#include "three/three.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>

namespace {

using support::Outcome;
using support::TemporaryDirectory;

const std::vector<std::string> lessons{
    "lesson_00_scene",       "lesson_01_material",     "lesson_02_directional_light",
    "lesson_03_point_light", "lesson_04_ambient",      "lesson_05_attenuation",
    "lesson_06_many_lights", "lesson_07_normal_space", "lesson_08_shading_frequency",
    "lesson_09_phong"};

// A lesson's frame with some options, through a file of that extension.
image::Frame frameOf(const std::string& lesson, std::vector<std::string> options = {},
                     const std::string& extension = ".exr") {
    const TemporaryDirectory directory;
    options.insert(options.begin(), {lesson, "--frame", "frame" + extension, "--size", "200x150"});
    const Outcome outcome = support::run(options, directory.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(directory.contents(), std::vector<std::string>{"frame" + extension});
    return image::readFrame(directory.file("frame" + extension));
}

double worst(const image::Frame& a, const image::Frame& b) { return image::compare(a, b).worst; }

class EachLesson : public testing::TestWithParam<std::string> {};

TEST_P(EachLesson, TwoRunsTheSameBytes) {
    for (const char* file : {"a.png", "a.exr"}) {
        std::string bytes[2];
        for (std::string& b : bytes) {
            const TemporaryDirectory directory;
            ASSERT_EQ(support::run({GetParam(), "--frame", file, "--jitter", "7", "--time", "1.5"},
                                   directory.path())
                          .status,
                      0);
            b = support::readFile(directory.file(file));
        }
        EXPECT_GT(bytes[0].size(), 1000U);
        EXPECT_EQ(bytes[0], bytes[1]) << file;
    }
}

TEST_P(EachLesson, TheSameFrameThroughASceneFile) {
    const TemporaryDirectory directory;
    const Outcome dumped = support::run(
        {GetParam(), "--dump-scene", "scene.json", "--frame", "lesson.exr", "--time", "2"}, directory.path());
    ASSERT_EQ(dumped.status, 0) << dumped.err;
    const Outcome viewed =
        support::run({"scene_viewer", "scene.json", "--frame", "viewer.exr"}, directory.path());
    ASSERT_EQ(viewed.status, 0) << viewed.err;
    const image::Difference d = image::compare(image::readFrame(directory.file("lesson.exr")),
                                               image::readFrame(directory.file("viewer.exr")), 1e-5);
    EXPECT_LT(d.above, 20U) << "worst " << d.worst << " at " << d.x << ',' << d.y;
}

TEST_P(EachLesson, NothingSkippedTheSameBytes) {
    EXPECT_EQ(worst(frameOf(GetParam()), frameOf(GetParam(), {"--no-skip"})), 0);
}

// A ball under lamps from near to far, as a scene file.
std::string lampsNearAndFar() {
    THREE::Scene scene;
    THREE::SphereGeometry geometry(1, 32, 16);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    THREE::Mesh ball(geometry, material);
    scene.add(ball);
    THREE::PointLight lamps[8];
    for (int i = 0; i < 8; ++i) {
        lamps[i].position.set(2 * std::pow(2.0, i), 1, 3);
        lamps[i].decay = 2;
        lamps[i].intensity = 2;
        scene.add(lamps[i]);
    }
    THREE::PerspectiveCamera camera(40, 1, 0.1, 100);
    camera.position.set(0, 0, 5);
    scene.updateMatrixWorld();
    return THREE::toJSON(scene, &camera);
}

// What --light-cut promises on stdout and in --stats, the frame keeps.
TEST(LightCut, KeepsWhatItPrints) {
    const TemporaryDirectory directory;
    support::writeFile(directory.path() / "lamps.json", lampsNearAndFar());
    const auto drawn = [&](const std::vector<std::string>& options) {
        std::vector<std::string> command{"scene_viewer",          "lamps.json", "--frame",
                                         directory.file("x.exr"), "--lang",     "en"};
        command.insert(command.end(), options.begin(), options.end());
        return support::run(command, directory.path());
    };
    ASSERT_EQ(drawn({}).status, 0);
    const image::Frame whole = image::readFrame(directory.file("x.exr"));
    const std::string begin = "--light-cut: no pixel lacks more than ";
    double before = 0;
    for (const char* codes : {"0.5", "3", "20"}) {
        const Outcome cut = drawn({"--light-cut", codes});
        ASSERT_EQ(cut.out.substr(0, begin.size()), begin) << cut.out << cut.err;
        const double promised = std::stod(cut.out.substr(begin.size()));
        EXPECT_LE(promised, std::stod(codes));
        const double lacks = worst(whole, image::readFrame(directory.file("x.exr"))) * 255;
        EXPECT_LE(lacks, promised + 1e-3) << codes;
        EXPECT_GT(lacks, before) << codes;
        before = lacks;
        const auto stats = nlohmann::json::parse(drawn({"--light-cut", codes, "--stats"}).out);
        EXPECT_NEAR(stats.at("light_cut_codes").get<double>(), promised, 0.01);
    }
    EXPECT_EQ(nlohmann::json::parse(drawn({"--stats"}).out).at("light_cut_codes"), 0);
    EXPECT_EQ(drawn({"--light-cut", "1e-6"}).out, begin + "0 8-bit codes, before rounding\n")
        << "where nothing could be left out, nothing is missing";
}

TEST_P(EachLesson, TimeCameraAndJitterChangeThePicture) {
    const image::Frame still = frameOf(GetParam());
    EXPECT_GT(worst(still, frameOf(GetParam(), {"--camera", "4,2,4,0,1,0,50"})), 0.01);
    EXPECT_GT(worst(still, frameOf(GetParam(), {"--jitter", "1"})), 0.01);
    EXPECT_GT(worst(frameOf(GetParam(), {"--jitter", "1"}), frameOf(GetParam(), {"--jitter", "2"})), 0.01);
    EXPECT_GT(worst(still, frameOf(GetParam(), {"--time", "1"})), 0.01);
}

TEST_P(EachLesson, StatsAreOneLineOfJsonWithEveryKey) {
    const TemporaryDirectory directory;
    const Outcome outcome =
        support::run({GetParam(), "--stats", "--frames", "3", "--size", "64x64"}, directory.path());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json stats = nlohmann::json::parse(outcome.out);
    for (const char* key : {"renderer", "width", "height", "shader_variant", "meshes", "lights", "skipped",
                            "draw_calls", "triangles", "uploads_bytes", "compile_ms", "first_frame_ms",
                            "frame_ms", "nonfinite", "sliders", "readings"})
        EXPECT_TRUE(stats.contains(key)) << key;
    EXPECT_EQ(stats["nonfinite"], 0);
    EXPECT_EQ(stats["frame_ms"]["n"], 3);
    EXPECT_GT(stats["frame_ms"]["median"], 0);
    EXPECT_GT(stats["triangles"], GetParam().starts_with("lesson_") ? 51'000 : 5000);
    EXPECT_EQ(directory.contents(), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(Chain, EachLesson, testing::ValuesIn(lessons),
                         [](const auto& test) { return test.param; });
INSTANTIATE_TEST_SUITE_P(Interludes, EachLesson, testing::Values("interlude_brdf", "interlude_cosine_law"),
                         [](const auto& test) { return test.param; });

// What the headers promise.
TEST(Lessons, EachDrawsWhatItsHeaderSays) {
    const auto count = [](const image::Frame& frame, const auto& is) {
        const image::Floats& f = std::get<image::Floats>(frame.pixels);
        int n = 0;
        for (std::size_t i = 0; i < f.size(); i += 3)
            n += is(f[i], f[i + 1], f[i + 2]) ? 1 : 0;
        return n;
    };
    const auto black = [](float r, float g, float b) { return r == 0 && g == 0 && b == 0; };
    const auto white = [](float r, float g, float b) { return r == 1 && g == 1 && b == 1; };
    const image::Frame flat = frameOf(lessons[0]);
    const int knot = count(flat, white);
    EXPECT_GT(knot, 4000);
    const image::Frame dark = frameOf(lessons[1]);
    EXPECT_GT(count(dark, black), knot) << "without light the knot and the floor are black";
    const image::Frame sun = frameOf(lessons[2]);
    EXPECT_GT(count(sun, black), knot / 4) << "the side that is turned away from the sun is black";
    EXPECT_LT(count(sun, black), knot * 95 / 100);
    EXPECT_LT(count(frameOf(lessons[3]), black), count(sun, black) / 2)
        << "the second light reaches most of it";
    EXPECT_EQ(count(frameOf(lessons[4]), black), 0) << "nothing is black any more";
}

// The mean of all values, and how much of the picture two frames differ in.
double mean(const image::Frame& frame) {
    const image::Floats& f = std::get<image::Floats>(frame.pixels);
    return std::accumulate(f.begin(), f.end(), 0.0) / static_cast<double>(f.size());
}
double changed(const image::Frame& a, const image::Frame& b) {
    const image::Difference d = image::compare(a, b, 2 / 255.0);
    return static_cast<double>(d.above) / (a.width * a.height);
}

TEST(Lessons, TheLaterOnesDrawWhatTheirHeadersSay) {
    // 05: the larger k, the darker; without f all is bright.
    const image::Frame faded = frameOf("lesson_05_attenuation");
    EXPECT_GT(mean(frameOf("lesson_05_attenuation", {"--decay", "1"})), 1.5 * mean(faded));
    EXPECT_GT(mean(frameOf("lesson_05_attenuation", {"--terms", "-attenuation"})), 3 * mean(faded));
    // 06: stronger lamps saturate; at 0 the ring is skipped.
    const image::Frame ring = frameOf("lesson_06_many_lights");
    EXPECT_GT(mean(frameOf("lesson_06_many_lights", {"--set", "forza=5"})), 2 * mean(ring));
    EXPECT_EQ(worst(faded, frameOf("lesson_06_many_lights", {"--set", "forza=0"})), 0);
    // 07: the model matrix alone is wrong here, and was not before; the space does not matter.
    const std::vector<std::string> model{"--normal-matrix", "model"}, view{"--space", "view"};
    EXPECT_LT(changed(ring, frameOf("lesson_06_many_lights", model)), 0.001);
    const image::Frame squashed = frameOf("lesson_07_normal_space");
    EXPECT_GT(changed(squashed, frameOf("lesson_07_normal_space", model)), 0.05);
    EXPECT_LT(changed(squashed, frameOf("lesson_07_normal_space", view)), 0.001);
    // 08: at the vertices alone the floor changes; with one normal per face the coarse ball does.
    const image::Frame balls = frameOf("lesson_08_shading_frequency");
    EXPECT_GT(changed(balls, frameOf("lesson_08_shading_frequency", {"--shading", "vertex"})), 0.2);
    EXPECT_GT(changed(balls, frameOf("lesson_08_shading_frequency", {"--shading", "flat"})), 0.005);
    // 09: without its highlights it is lesson 08; three.js's formula gives others.
    const image::Frame shiny = frameOf("lesson_09_phong");
    EXPECT_EQ(worst(balls, frameOf("lesson_09_phong", {"--terms", "-specular"})), 0);
    EXPECT_GT(changed(shiny, balls), 0.02);
    EXPECT_GT(changed(shiny, frameOf("lesson_09_phong", {"--specular", "blinn"})), 0.02);
    EXPECT_EQ(worst(shiny, frameOf("lesson_09_phong", {"--specular", "phong"})), 0);
}

// What a light costs is told where frames are timed (slide 39).
TEST(Lessons, TellWhatALightCosts) {
    const TemporaryDirectory directory;
    const std::vector<std::string> timed{"lesson_06_many_lights", "--frames", "5", "--size", "128x128"};
    const Outcome told = support::run(timed, directory.path());
    EXPECT_NE(told.out.find("; 14 lights, each "), std::string::npos) << told.out;
    std::vector<std::string> withStats = timed;
    withStats.emplace_back("--stats");
    const nlohmann::json stats = nlohmann::json::parse(support::run(withStats, directory.path()).out);
    EXPECT_TRUE(stats["light_ms"].is_number());
    EXPECT_TRUE(nlohmann::json::parse(
                    support::run({"lesson_06_many_lights", "--stats"}, directory.path()).out)["light_ms"]
                    .is_null());
}

TEST(Lessons, AmbientAddsAtMostTheCodesItsHeaderNames) {
    const image::Difference d =
        image::compare(frameOf(lessons[3], {}, ".exr"), frameOf(lessons[4], {}, ".exr"));
    EXPECT_NEAR(d.maximum[0] * 255, 16, 1e-3);
    EXPECT_NEAR(d.maximum[1] * 255, 16.0 * 0x88 / 255, 1e-3);
}

TEST(Lessons, FormatsAgree) {
    const image::Frame exact = frameOf("lesson_04_ambient", {}, ".exr");
    EXPECT_EQ(worst(exact, frameOf("lesson_04_ambient", {}, ".tif")), 0);
    image::Frame codes = exact;
    codes.pixels = image::toBytes(exact);
    EXPECT_LE(worst(codes, frameOf("lesson_04_ambient", {}, ".png")), 1.001 / 255);
    const image::Difference jpeg = image::compare(exact, frameOf("lesson_04_ambient", {}, ".jpg"));
    EXPECT_LT(jpeg.mean, 0.03);
}

// What a frame does not need costs it nothing: OpenImageIO alone loads longer than the frame takes.
TEST(Lessons, AFrameLoadsNoLibraryThatItDoesNotNeed) {
    const TemporaryDirectory directory;
    for (const char* file : {"a.png", "a.exr"}) {
        const Outcome outcome =
            support::run({"lesson_04_ambient", "--frame", file}, directory.path(), {{"LD_DEBUG", "libs"}});
        ASSERT_EQ(outcome.status, 0);
        ASSERT_NE(outcome.err.find("libEGL"), std::string::npos) << "the loader reports nothing";
        for (const char* library :
             {"OpenImageIO", "lambert_image_oiio", "lambert_window", "libglfw", "libtinyobj"})
            EXPECT_EQ(outcome.err.find(library), std::string::npos) << library << " for " << file;
    }
}

TEST(Lessons, DecayOverridesEveryPointLight) {
    EXPECT_EQ(worst(frameOf("lesson_04_ambient"), frameOf("lesson_04_ambient", {"--decay", "0"})), 0);
    EXPECT_GT(worst(frameOf("lesson_04_ambient"), frameOf("lesson_04_ambient", {"--decay", "2"})), 0.2);
}

}  // namespace
