// --frames-from: each line as if it were alone, one failure not stopping the rest, and an answer before the next line is read.
// SPDX-License-Identifier: MIT
#include "support/dialogue.hpp"
#include "support/program.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <set>

namespace {

using Json = nlohmann::json;
using support::Outcome;
using support::TemporaryDirectory;
using Arguments = std::vector<std::string>;

const std::string lesson = "lesson_04_ambient";

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

// Runs `program` with this text as the file of --frames-from.
Outcome runFrames(const TemporaryDirectory& directory, const std::string& text,
                  Arguments program = {lesson}) {
    support::writeFile(directory.file("frames.txt"), text);
    program.insert(program.end(), {"--size", "64x48", "--frames-from", "frames.txt"});
    return support::run(program, directory.path());
}

struct Program {
    const char* name;
    Arguments command;  // program and options for every frame
    std::vector<Arguments> frames;  // options of each
};

// The command line for one of its frames alone: what the frame says comes instead of what is said for all; --set is added.
Arguments aloneArguments(const Arguments& command, const Arguments& frame, const std::string& file) {
    Arguments all{command.begin(), command.end()};
    all.insert(all.end(), {"--size", "64x48"});
    for (const std::string& word : frame)
        if (const auto at = std::find(all.begin(), all.end(), word); word != "--set" && at != all.end())
            all.erase(at, at + 2);
    all.insert(all.end(), {"--frame", file});
    all.insert(all.end(), frame.begin(), frame.end());
    return all;
}

class Frames : public testing::TestWithParam<Program> {};

// In two orders, so that what one frame leaves behind would show in another.
TEST_P(Frames, HaveTheBytesThatTheyHaveAlone) {
    const TemporaryDirectory directory;
    support::writeFile(directory.file("frames.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0.5\nf 1 2 3\n");
    const auto& frames = GetParam().frames;
    std::vector<std::size_t> order(frames.size());
    std::iota(order.begin(), order.end(), 0U);
    std::vector<std::string> alone;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::string file = i % 3 == 2 ? "alone.exr" : "alone.png";
        const Outcome outcome =
            support::run(aloneArguments(GetParam().command, frames[i], file), directory.path());
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        alone.push_back(support::readFile(directory.file(file)));
        EXPECT_GT(alone.back().size(), 100U);
    }
    EXPECT_GT(std::set<std::string>(alone.begin(), alone.end()).size(), frames.size() / 2) << "they differ";
    for (const unsigned seed : {1U, 2U}) {
        std::shuffle(order.begin(), order.end(), std::mt19937(seed));
        std::string text;
        for (const std::size_t i : order) {
            text += "--frame " + std::to_string(i) + (i % 3 == 2 ? ".exr" : ".png");
            for (const std::string& word : frames[i])
                text += " '" + word + "'";
            text += '\n';
        }
        const Outcome outcome = runFrames(directory, text, GetParam().command);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        for (const std::size_t i : order)
            EXPECT_TRUE(support::readFile(
                            directory.file(std::to_string(i) + (i % 3 == 2 ? ".exr" : ".png"))) == alone[i])
                << "frame " << i << " of\n"
                << text;
    }
}

const std::vector<Arguments> common{{},
                                    {"--time", "1.5"},
                                    {"--camera", "3,2,4,0,0,0,30"},
                                    {"--jitter", "7"},
                                    {"--decay", "2", "--jitter", "8"},
                                    {"--terms", "-clamp", "--time", "1.5"},
                                    {"--shading", "vertex", "--camera", "0,1,9,0,1,0"},
                                    {"--no-skip", "--decay", "0.5"},
                                    {"--shading", "flat", "--space", "view"}};

std::vector<Arguments> with(std::vector<Arguments> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return more;
}

const std::string sources = LAMBERT_SOURCE_DIR;

INSTANTIATE_TEST_SUITE_P(
    Programs, Frames,
    testing::Values(
        Program{"lesson", {lesson, "--decay", "1"}, with({{"--renderer", "reference", "--jitter", "7"}})},
        Program{"lamps",
                {"lesson_06_many_lights"},
                with({{"--set", "forza=2"}, {"--jitter", "7", "--time", "2"}})},
        Program{"scaled", {"lesson_07_normal_space", "--jitter", "3"}, common},
        Program{"sliders",
                {"interlude_brdf", "--set", "a=0.7"},
                {{},
                 {"--set", "theta_i=80"},
                 {"--time", "3"},
                 {"--set", "s=40"},
                 {"--camera", "3,2,4,0,0,0,30"},
                 {"--jitter", "7"},
                 {"--set", "a=0.1"}}},
        Program{"beam",
                {"interlude_cosine_law"},
                {{}, {"--set", "alpha=80"}, {"--time", "3"}, {"--jitter", "7"}}},
        Program{"file_with_camera",
                {"scene_viewer", sources + "/tests/threejs/s06_dir_point.json"},
                with({{"--size", "48x64"}})},
        Program{"file_without_camera", {"scene_viewer", "frames.obj"}, with({{"--size", "20x64"}})}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FramesFrom, GoesOnAfterEachFailure) {
    const TemporaryDirectory directory;
    support::writeFile(directory.file("file"), "");
    const std::vector<std::pair<std::string, std::string>> cases{
        {"--frame a.png --size 0x4", "1 to 8192"},
        {"--frame nowhere/a.png", "cannot write 'nowhere/a.png'"},
        {"--time 3", "--frame FILE"},
        {"--frame a.png --frames 3", "--frames"},
        {"--frame a.png 'x", "without its end"},
        {"--frame a.png x.json", "x.json"},
        {"--frame a.png --set alpha=1", "no sliders"},
        {"--frame a.png --shaders nowhere", "no folder nowhere"},
        {"--frame a.wav9", "wav9"},
        {"--frame file/a.png", "file/a.png"},
        {"--frame ''", "file name"},
        {"--frmae a.png", "--frmae"},
        {std::string("--frame a.png\0", 14), "NUL"},
        {"--frame a.png --terms " + std::string(1'000'000, 'x'), "too long"},
        {"\xFF\xFE\x80", "\xFF\xFE\x80"},
    };
    std::string text = "# what goes wrong\n\n";
    for (const auto& [line, message] : cases)
        text += line + "\n--frame good.png\n";
    const Outcome outcome = runFrames(directory, text);
    EXPECT_EQ(outcome.status, 2);
    const std::vector<std::string> errors = linesOf(outcome.err);
    ASSERT_EQ(errors.size(), cases.size()) << outcome.err;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_EQ(errors[i].find("frames.txt:" + std::to_string(3 + 2 * i) + ": "), 0U) << errors[i];
        EXPECT_NE(errors[i].find(cases[i].second), std::string::npos) << errors[i];
        EXPECT_LT(errors[i].size(), 400U);
    }
    EXPECT_EQ(linesOf(outcome.out), Arguments(cases.size(), "good.png"));
    EXPECT_EQ(directory.contents(), (Arguments{"file", "frames.txt", "good.png"}));
}

TEST(FramesFrom, EndsWithTheFirstFailuresStatus) {
    const std::string good = "--frame g.png\n", file = "--frame no/a.png\n", word = "--what\n",
                      shaders = "--frame s.png --shaders no\n";
    for (const auto& [text, status] : {std::pair{good, 0},
                                       {good + file + word, 5},
                                       {shaders + good + file, 3},
                                       {word + shaders + good, 2}}) {
        const TemporaryDirectory directory;
        EXPECT_EQ(runFrames(directory, text).status, status) << text;
    }
    const TemporaryDirectory directory;  // far too near: a scene that cannot be drawn
    support::writeFile(directory.file("t.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome scene = runFrames(directory, "--frame a.png --camera 0,0,1e36,0,0,0\n--frame b.png",
                                    {"scene_viewer", "t.obj"});
    EXPECT_EQ(scene.status, 4) << scene.err;
    EXPECT_EQ(scene.err.find("frames.txt:1: t.obj: "), 0U) << scene.err;
    EXPECT_EQ(directory.contents(), (Arguments{"b.png", "frames.txt", "t.obj"}));
}

TEST(FramesFrom, TakesAnyFile) {
    const TemporaryDirectory directory;
    EXPECT_EQ(runFrames(directory, "").status, 0);
    EXPECT_EQ(runFrames(directory, "# nothing\n").status, 0);
    const Outcome ends = runFrames(directory, "\xEF\xBB\xBF--frame 'a b.png'\r\n\r\n--frame c.png\t# last");
    EXPECT_EQ(ends.status, 0) << ends.err;
    EXPECT_EQ(ends.out, "a b.png\nc.png\n");
    for (const auto& [file, reason] : {std::pair{"none.txt", "No such file"},
                                       {"/", "directory"},
                                       {"", "file name"},
                                       {"/proc/self/mem", "cannot read on"}}) {
        const Outcome outcome = support::run({lesson, "--frames-from", file}, directory.path());
        EXPECT_EQ(outcome.status, 2) << file;
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    }
    std::string junk(100'000, '\0');
    std::mt19937 random(1);
    std::generate(junk.begin(), junk.end(), [&random] { return static_cast<char>(random()); });
    EXPECT_EQ(runFrames(directory, junk).status, 2);
    EXPECT_EQ(directory.contents(), (Arguments{"a b.png", "c.png", "frames.txt"}));
}

TEST(FramesFrom, AStateInALineKnowsItsSizeAsAlone) {
    const TemporaryDirectory directory;
    support::writeFile(directory.file("state.json"),
                       R"({"lambert_lab": 1, "program": "lesson_04_ambient", "size": [80, 50],
                           "controls": {"term ambient": "off", "light add": "x"}})");
    support::writeFile(directory.file("frames.txt"), "--state state.json --frame wrong.png\n");
    EXPECT_EQ(support::run({lesson, "--frames-from", "frames.txt"}, directory.path()).status, 2)
        << "there is no such control";
    support::writeFile(directory.file("state.json"),
                       R"({"lambert_lab": 1, "program": "lesson_04_ambient", "size": [80, 50],
                           "controls": {"term ambient": "off", "added lights": "point", "view": "red"}})");
    support::writeFile(directory.file("frames.txt"),
                       "--frame before.png --size 80x50\n--state state.json --frame line.png\n"
                       "--frame after.png --size 80x50\n");
    const Outcome outcome = support::run({lesson, "--frames-from", "frames.txt"}, directory.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(
        support::run({lesson, "--state", "state.json", "--frame", "alone.png"}, directory.path()).status, 0);
    const auto bytes = [&directory](const char* file) { return support::readFile(directory.file(file)); };
    EXPECT_EQ(bytes("line.png"), bytes("alone.png"));
    EXPECT_NE(bytes("line.png"), bytes("before.png"));
    EXPECT_EQ(bytes("after.png"), bytes("before.png")) << "the state leaves no trace";
}

TEST(FramesFrom, TellsEachFrameAndSendsNothingTwice) {
    const TemporaryDirectory directory;
    const Outcome outcome =
        runFrames(directory,
                  "--frame a.png\n--frame b.png --camera 3,2,4,0,0,0,30\n--frame no/c.png\n"
                  "--frame a.exr --time 0\n--what\n--frame a.png --camera 3,2,5,0,0,0,30\n",
                  {lesson, "--stats"});
    EXPECT_EQ(outcome.status, 5);
    std::vector<Json> all;
    for (const std::string& line : linesOf(outcome.out))
        all.push_back(Json::parse(line));
    ASSERT_EQ(all.size(), 6U) << outcome.out;
    EXPECT_GT(all[0]["uploads_bytes"], 1'000'000);
    EXPECT_GT(all[0]["phases_ms"]["compile"], 0);
    for (const std::size_t i : {1U, 3U, 5U}) {
        EXPECT_EQ(all[i]["uploads_bytes"], 0) << i;
        EXPECT_EQ(all[i]["phases_ms"]["compile"], 0) << i;
        EXPECT_EQ(all[i]["nonfinite"], 0) << i;
    }
    const char* const files[] = {"a.png", "b.png", "no/c.png", "a.exr", nullptr, "a.png"};
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(all[i]["frame"], files[i] != nullptr ? Json(files[i]) : Json()) << i;
    EXPECT_EQ(all[2]["status"], 5);
    EXPECT_EQ(all[2]["line"], 3);
    EXPECT_EQ(all[4]["status"], 2);
    EXPECT_NE(all[4]["error"].get<std::string>().find("--what"), std::string::npos);
    // In one line only.
    const Outcome one = runFrames(directory, "--frame a.png --stats\n--frame b.png\n");
    EXPECT_EQ(linesOf(one.out).size(), 2U);
    EXPECT_NEAR(Json::parse(linesOf(one.out)[0])["first_frame_ms"].get<double>(),
                all[0]["first_frame_ms"].get<double>(), 5000);
}

TEST(FramesFrom, ShadersMayChangeFromLineToLine) {
    const TemporaryDirectory directory;
    std::filesystem::create_directories(directory.file("mine/terms"));
    support::writeFile(directory.file("mine/terms/albedo.glsl"),
                       "vec3 albedo(vec3 D) { return vec3(1.0); }\n");
    std::filesystem::create_directories(directory.file("broken/terms"));
    support::writeFile(directory.file("broken/terms/albedo.glsl"), "vec3 albedo(vec3 D) { return 1; }\n");
    const Outcome outcome =
        runFrames(directory, "--frame a.exr\n--frame b.exr --shaders mine\n"
                             "--frame x.exr --shaders broken\n--frame c.exr\n"
                             "--frame d.exr --shaders mine\n--frame e.exr --renderer reference\n"
                             "--frame f.exr\n");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err.find("frames.txt:3: "), 0U) << outcome.err;
    const auto bytes = [&](const char* name) { return support::readFile(directory.file(name)); };
    EXPECT_TRUE(bytes("a.exr") == bytes("c.exr"));
    EXPECT_TRUE(bytes("a.exr") == bytes("f.exr"));
    EXPECT_TRUE(bytes("b.exr") == bytes("d.exr"));
    EXPECT_FALSE(bytes("a.exr") == bytes("b.exr"));
    EXPECT_GT(bytes("e.exr").size(), 1000U);
    EXPECT_EQ(bytes("x.exr"), "");
}

TEST(FramesFrom, AnswersEachLineBeforeTheNext) {
    const TemporaryDirectory directory;
    support::Dialogue dialogue({lesson, "--size", "32x32", "--frames-from", "-"}, directory.path());
    dialogue.say("--frame a.png\n");
    EXPECT_EQ(dialogue.hear(), "a.png");
    EXPECT_GT(support::readFile(directory.file("a.png")).size(), 100U) << "written before it is told";
    dialogue.say("--frame b.png --ti");
    dialogue.say("me 2 --stats\n");
    EXPECT_EQ(Json::parse(dialogue.hear())["frame"], "b.png");
    dialogue.say("--frame no/c.png --stats\n");
    EXPECT_EQ(Json::parse(dialogue.hear())["status"], 5);
    dialogue.say("--frame d.png");
    EXPECT_EQ(dialogue.end(), 5) << "the end of stdin ends the last line too";
    EXPECT_EQ(dialogue.hear(), "d.png");
    EXPECT_EQ(directory.contents(), (Arguments{"a.png", "b.png", "d.png"}));
}

TEST(FramesFrom, WithoutADriverTheReferenceGoesOn) {
    const TemporaryDirectory directory;
    support::writeFile(directory.file("f"),
                       "--frame a.png\n--frame b.png --renderer reference\n--frame c.png\n");
    const Outcome outcome =
        support::run({lesson, "--size", "32x32", "--frames-from", "f"}, directory.path(),
                     {{"__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent"}, {"__EGL_VENDOR_LIBRARY_FILENAMES", ""}});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.out, "b.png\n");
    EXPECT_NE(outcome.err.find("f:3: "), std::string::npos) << outcome.err;
}

}  // namespace
