// Whatever a user gets wrong: the promised status, a message that says what, where and what next, and nothing left behind.
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"
#include "image/oiio.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace {

using support::Outcome;
using support::TemporaryDirectory;
using Arguments = std::vector<std::string>;

struct Case {
    const char* name;
    Arguments arguments;
    int status;
    const char* message;  // a part of stderr
};

class CommandLine : public testing::TestWithParam<Case> {};

TEST_P(CommandLine, SaysWhatIsWrong) {
    const TemporaryDirectory directory;
    const Outcome outcome = support::run(GetParam().arguments, directory.path());
    EXPECT_EQ(outcome.status, GetParam().status) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().message), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().arguments[0]), std::string::npos)
        << "the program names itself: " << outcome.err;
    EXPECT_EQ(directory.contents(), Arguments{});
}

const std::string lesson = "lesson_04_ambient";
const std::string interlude = "interlude_cosine_law";

INSTANTIATE_TEST_SUITE_P(
    Usage, CommandLine,
    testing::Values(
        Case{"unknown_option", {lesson, "--frmae", "a.png"}, 2, "--frmae"},
        Case{"missing_value", {lesson, "--frame"}, 2, "--frame"},
        Case{"empty_file_name", {lesson, "--frame", ""}, 2, "file name"},
        Case{"stray_argument", {lesson, "x.json"}, 2, "x.json"},
        Case{"size_zero", {lesson, "--frame", "a.png", "--size", "0x10"}, 2, "1 to 8192"},
        Case{"size_huge", {lesson, "--frame", "a.png", "--size", "100000x100000"}, 2, "1 to 8192"},
        Case{"size_overflow", {lesson, "--frame", "a.png", "--size", "99999999999x1"}, 2, "1 to 8192"},
        Case{"size_negative", {lesson, "--frame", "a.png", "--size", "-5x10"}, 2, "1 to 8192"},
        Case{"size_text", {lesson, "--frame", "a.png", "--size", "big"}, 2, "WIDTHxHEIGHT"},
        Case{"size_trailing", {lesson, "--frame", "a.png", "--size", "10x10x10"}, 2, "10x10x10"},
        Case{"time_text", {lesson, "--frame", "a.png", "--time", "soon"}, 2, "finite number"},
        Case{"time_nan", {lesson, "--frame", "a.png", "--time", "nan"}, 2, "finite number"},
        Case{"time_infinite", {lesson, "--frame", "a.png", "--time", "1e999"}, 2, "finite number"},
        Case{"decay_negative", {lesson, "--frame", "a.png", "--decay", "-1"}, 2, "0 or more"},
        Case{"terms_unknown", {lesson, "--frame", "a.png", "--terms", "cosine,gloss"}, 2, "gloss"},
        Case{"terms_mixed", {lesson, "--frame", "a.png", "--terms", "cosine,-clamp"}, 2, "mixes"},
        Case{"camera_short", {lesson, "--frame", "a.png", "--camera", "1,2,3"}, 2, "px,py,pz"},
        Case{"camera_text", {lesson, "--frame", "a.png", "--camera", "1,2,3,4,5,six"}, 2, "six"},
        Case{"camera_fov", {lesson, "--frame", "a.png", "--camera", "1,2,3,0,0,0,180"}, 2, "180"},
        Case{"camera_same", {lesson, "--frame", "a.png", "--camera", "1,2,3,1,2,3"}, 2, "different"},
        Case{"jitter_text", {lesson, "--frame", "a.png", "--jitter", "x"}, 2, "whole number"},
        Case{"frames_zero", {lesson, "--frames", "0"}, 2, "1000000"},
        Case{"lang_unknown", {lesson, "--lang", "fr"}, 2, "fr"},
        Case{"renderer_unknown",
             {lesson, "--frame", "a.png", "--renderer", "vulkan"},
             2,
             "--renderer: expected gl or reference, found 'vulkan'"},
        Case{"set_nothing", {lesson, "--set"}, 2, "--set"},
        Case{"set_no_sliders", {lesson, "--frame", "a.png", "--set", "alpha=1"}, 2, "no sliders"},
        Case{"set_unknown",
             {interlude, "--frame", "a.png", "--set", "beta=1"},
             2,
             "alpha (0 to 180), found 'beta=1'"},
        Case{"set_text", {interlude, "--frame", "a.png", "--set", "alpha=flat"}, 2, "alpha (0 to 180)"},
        Case{"set_outside", {interlude, "--frame", "a.png", "--set", "alpha=181"}, 2, "found 'alpha=181'"},
        Case{"set_nan", {interlude, "--stats", "--set", "alpha=nan"}, 2, "alpha (0 to 180)"},
        Case{"set_without_value", {interlude, "--set", "alpha"}, 2, "NAME=VALUE"},
        Case{"no_scene_file", {"scene_viewer"}, 2, "file"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Output, CommandLine,
    testing::Values(Case{"no_such_folder", {lesson, "--frame", "nowhere/a.png"}, 5, "nowhere"},
                    Case{"a_folder", {lesson, "--frame", "/tmp"}, 5, "/tmp"},
                    Case{"unknown_format", {lesson, "--frame", "a.wav9"}, 5, "wav9"},
                    Case{"no_format", {lesson, "--frame", "picture"}, 5, "picture"},
                    Case{"scene_nowhere", {lesson, "--dump-scene", "nowhere/s.json"}, 5, "nowhere"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Scene, CommandLine,
    testing::Values(
        Case{"missing", {"scene_viewer", "nothing.json", "--frame", "a.png"}, 4, "nothing.json"},
        Case{"directory", {"scene_viewer", "/", "--frame", "a.png"}, 4, "/"},
        Case{"missing_obj", {"scene_viewer", "nothing.obj", "--frame", "a.png"}, 4, "nothing.obj"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Shaders, CommandLine,
    testing::Values(
        Case{"no_folder", {lesson, "--frame", "a.png", "--shaders", "nowhere"}, 3, "no folder nowhere"},
        Case{"no_file_of_the_labs",
             {lesson, "--frame", "a.png", "--shaders", LAMBERT_SOURCE_DIR "/lessons"},
             3,
             "none of the lab's shader files"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BrokenScenes, NameTheFileThePlaceAndTheReason) {
    const std::string whole = support::readFile(LAMBERT_SOURCE_DIR "/tests/threejs/s07_ambient.json");
    ASSERT_GT(whole.size(), 1000U);
    const auto replaced = [&whole](const std::string& what, const std::string& by) {
        std::string text = whole;
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), by);
    };
    const std::vector<std::pair<std::string, std::string>> cases{
        {"truncated", whole.substr(0, whole.size() / 2)},
        {"empty", ""},
        {"wrong_type", replaced("\"fov\":40", "\"fov\":\"wide\"")},
        {"fov_zero", replaced("\"fov\":40", "\"fov\":0")},
        {"huge_number", replaced("\"fov\":40", "\"fov\":1e999")},
        {"not_a_number", replaced("\"fov\":40", "\"fov\":NaN")},
        {"huge_count", replaced("\"itemSize\":3", "\"itemSize\":1000000000")},
        {"no_object", R"({"metadata":{"version":4.5,"type":"Object"}})"},
        {"deep", std::string(100'000, '[')},
    };
    for (const auto& [name, text] : cases) {
        const TemporaryDirectory directory;
        support::writeFile(directory.file(name + ".json"), text);
        const Outcome outcome =
            support::run({"scene_viewer", name + ".json", "--frame", "a.png"}, directory.path());
        EXPECT_EQ(outcome.status, 4) << name << ": " << outcome.err;
        EXPECT_NE(outcome.err.find(name + ".json"), std::string::npos) << outcome.err;
        EXPECT_EQ(directory.contents(), Arguments{name + ".json"});
    }
}

TEST(BrokenShaders, NameTheFileAndTheLine) {
    const TemporaryDirectory directory;
    std::filesystem::copy(LAMBERT_SOURCE_DIR "/shaders", directory.file("shaders"),
                          std::filesystem::copy_options::recursive);
    const std::string cosine = directory.file("shaders/terms/cosine.glsl");
    std::string text = support::readFile(cosine);
    const std::size_t at = text.find("dot(n, v)");
    ASSERT_NE(at, std::string::npos);
    const auto line =
        std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    support::writeFile(cosine, text.replace(at, 3, "dto"));
    const Outcome outcome =
        support::run({lesson, "--frame", "a.png", "--shaders", "shaders"}, directory.path());
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.err.find("terms/cosine.glsl:" + line), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("> " + line + " |"), std::string::npos)
        << "the line itself is shown: " << outcome.err;
    std::filesystem::remove(cosine);
    support::writeFile(cosine, "float cosine(vec3 n, vec3 v) { return 1.0; }\n#include \"gone.glsl\"\n");
    const Outcome missing =
        support::run({lesson, "--frame", "a.png", "--shaders", "shaders"}, directory.path());
    EXPECT_EQ(missing.status, 3);
    EXPECT_NE(missing.err.find("terms/cosine.glsl:2: "), std::string::npos)
        << "who asked for it: " << missing.err;
    EXPECT_EQ(directory.contents(), Arguments{"shaders"});
}

// A folder with one file of the lab's: that one counts, the others are the lab's; so are errors told.
TEST(Shaders, OneFileIsEnough) {
    const TemporaryDirectory directory;
    std::filesystem::create_directories(directory.file("mine/terms"));
    const std::string albedo = directory.file("mine/terms/albedo.glsl");
    const auto draw = [&](const std::string& frame, const Arguments& more) {
        Arguments arguments{lesson, "--frame", frame, "--size", "64x64"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return support::run(arguments, directory.path());
    };
    support::writeFile(albedo, "vec3 albedo(vec3 D) { return vec3(1.0); }\n");
    ASSERT_EQ(draw("mine.exr", {"--shaders", "mine"}).status, 0);
    ASSERT_EQ(draw("off.exr", {"--terms", "-albedo"}).status, 0);
    ASSERT_EQ(draw("on.exr", {}).status, 0);
    const auto frame = [&](const char* name) { return image::readFrame(directory.file(name)); };
    EXPECT_LT(image::compare(frame("mine.exr"), frame("off.exr")).worst, 1e-6);
    EXPECT_GT(image::compare(frame("mine.exr"), frame("on.exr")).worst, 0.1);
    support::writeFile(albedo, "vec3 albedo(vec3 D)\n{\n    return vec2(1.0);\n}\n");
    const Outcome mine = draw("broken.exr", {"--shaders", "mine"});
    EXPECT_EQ(mine.status, 3);
    EXPECT_NE(mine.err.find("\nterms/albedo.glsl:3:"), std::string::npos) << mine.err;
    EXPECT_NE(mine.err.find("> 3 |     return vec2(1.0);"), std::string::npos) << mine.err;
    // The lab's own file does not find what this one should have: its full name, so that an editor can open it.
    support::writeFile(albedo, "vec3 base_colour(vec3 D) { return D; }\n");
    const Outcome lost = draw("lost.exr", {"--shaders", "mine"});
    EXPECT_EQ(lost.status, 3);
    EXPECT_NE(lost.err.find("/share/lambert-lab/shaders/lighting.glsl:"), std::string::npos) << lost.err;
    EXPECT_NE(lost.err.find("|     D = albedo(D);"), std::string::npos) << lost.err;
}

TEST(DumpScene, FollowsLinksAndSparesPipes) {
    const TemporaryDirectory directory;
    ASSERT_EQ(mkfifo(directory.file("pipe").c_str(), 0600), 0);
    const Outcome refused = support::run({lesson, "--dump-scene", "pipe"}, directory.path());
    EXPECT_EQ(refused.status, 5);
    EXPECT_NE(refused.err.find("'pipe'"), std::string::npos) << refused.err;
    EXPECT_TRUE(std::filesystem::is_fifo(directory.file("pipe")));
    support::writeFile(directory.file("real.json"), "old");
    std::filesystem::create_symlink("real.json", directory.file("link.json"));
    EXPECT_EQ(support::run({lesson, "--dump-scene", "link.json"}, directory.path()).status, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(directory.file("link.json")));
    EXPECT_GT(support::readFile(directory.file("real.json")).size(), 1000U);
}

// What a viewer shows with --camera, --decay and --jitter is what the file that it dumps shows.
TEST(DumpScene, HoldsWhatWasSeen) {
    const TemporaryDirectory directory;
    const std::string scene = LAMBERT_SOURCE_DIR "/tests/threejs/s06_dir_point.json";
    const Outcome seen = support::run({"scene_viewer", scene, "--camera", "3,2,4,0,0,0,30", "--decay", "1",
                                       "--jitter", "3", "--dump-scene", "d.json", "--frame", "a.exr"},
                                      directory.path());
    ASSERT_EQ(seen.status, 0) << seen.err;
    ASSERT_EQ(support::run({"scene_viewer", "d.json", "--frame", "b.exr"}, directory.path()).status, 0);
    const image::Difference d = image::compare(image::readFrame(directory.file("a.exr")),
                                               image::readFrame(directory.file("b.exr")), 1e-5);
    EXPECT_LT(d.above, 20U) << "worst " << d.worst << " at " << d.x << ',' << d.y;
}

TEST(Viewer, ShowsWhatTheCameraOptionLooksAt) {
    const TemporaryDirectory directory;
    support::writeFile(directory.file("far.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* camera : {"0,0,500,0,0,0,1", "0,0,0.01,0,0,0"}) {
        const Outcome stats =
            support::run({"scene_viewer", "far.obj", "--camera", camera, "--stats"}, directory.path());
        EXPECT_NE(stats.out.find("\"drawn\":1"), std::string::npos) << camera << ": " << stats.out;
    }
}

// As on a machine where no graphics driver is installed.
const std::vector<std::pair<std::string, std::string>> noDriver{{"__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent"},
                                                                {"__EGL_VENDOR_LIBRARY_FILENAMES", ""}};

TEST(NoRenderer, SaysWhatWasTriedAndWhatToInstall) {
    const TemporaryDirectory directory;
    const Outcome outcome = support::run({lesson, "--frame", "a.png"}, directory.path(), noDriver);
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    for (const char* part : {"surfaceless", "libegl-mesa0", "libgl1-mesa-dri", "--renderer reference"})
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(directory.contents(), Arguments{});
}

TEST(NoRenderer, TheReferenceNeedsNone) {
    const TemporaryDirectory directory;
    const Outcome outcome =
        support::run({lesson, "--frame", "a.png", "--renderer", "reference", "--stats", "--size", "160x120"},
                     directory.path(), noDriver);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\"renderer\":\"reference, double precision\""), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("\"nonfinite\":0"), std::string::npos) << outcome.out;
    EXPECT_GT(support::readFile(directory.file("a.png")).size(), 1000U);
    // Without a display and without --frame: the same, in one line.
    const Outcome unasked = support::run({lesson, "--renderer", "reference"}, directory.path(), noDriver);
    EXPECT_EQ(unasked.status, 0) << unasked.err;
    EXPECT_EQ(directory.contents(), (Arguments{"a.png", lesson + ".png"}));
}

TEST(NoDisplay, WritesTheFrameAndSaysSo) {
    for (const auto& [language, words] :
         {std::pair{"en", "no display"}, std::pair{"it", "nessuno schermo"}}) {
        const TemporaryDirectory directory;
        const Outcome outcome = support::run({lesson, "--lang", language}, directory.path());
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(outcome.out.find(words), std::string::npos) << outcome.out;
        EXPECT_NE(outcome.out.find("lesson_04_ambient.png"), std::string::npos) << outcome.out;
        EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
        EXPECT_EQ(directory.contents(), Arguments{"lesson_04_ambient.png"});
    }
}

TEST(Sizes, OnePixelAndTheLargest) {
    const TemporaryDirectory directory;
    for (const auto& [size, side] :
         {std::pair{"1x1", 1}, std::pair{"1x8192", 8192}, std::pair{"8192x1", 8192}}) {
        const Outcome outcome = support::run({lesson, "--frame", "a.png", "--size", size}, directory.path());
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const image::Frame frame = image::readFrame(directory.file("a.png"));
        EXPECT_EQ(std::max(frame.width, frame.height), side);
    }
}

TEST(LargestSize, EightThousandSquare) {  // labelled slow
    const TemporaryDirectory directory;
    const Outcome outcome =
        support::run({lesson, "--frame", "a.png", "--size", "8192x8192"}, directory.path());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const image::Frame frame = image::readFrame(directory.file("a.png"));
    EXPECT_EQ(frame.width, 8192);
    EXPECT_EQ(frame.height, 8192);
}

TEST(Information, HelpVersionAndTerms) {
    const TemporaryDirectory directory;
    const Outcome help = support::run({lesson, "--help"}, directory.path());
    EXPECT_EQ(help.status, 0);
    for (const char* option :
         {"--frame", "--size", "--time", "--terms", "--decay", "--camera", "--jitter", "--no-skip", "--set",
          "--shaders", "--frames", "--frames-from", "--stats", "--dump-scene", "--dump-shader",
          "--list-terms", "--lang", "--renderer", "--version"})
        EXPECT_NE(help.out.find(option), std::string::npos) << option;
    EXPECT_NE(support::run({lesson, "--version"}, directory.path()).out.find("lesson_04_ambient"),
              std::string::npos);
    const Outcome italian = support::run({lesson, "--list-terms", "--lang", "it"}, directory.path());
    EXPECT_NE(italian.out.find("legge del coseno"), std::string::npos);
    EXPECT_EQ(std::count(italian.out.begin(), italian.out.end(), '\n'), 9);
    EXPECT_EQ(support::run({"scene_viewer", "--list-terms"}, directory.path()).status, 0) << "without a file";
    EXPECT_NE(support::run({lesson, "--lang", "it", "--help"}, directory.path()).out.find("questo aiuto"),
              std::string::npos);
    const Outcome shader = support::run({lesson, "--dump-shader"}, directory.path());
    EXPECT_NE(shader.out.find("vec3 lighting("), std::string::npos);
    EXPECT_EQ(directory.contents(), Arguments{});
}

}  // namespace
