// A lesson is built and draws inside, and its frames are those that it draws outside.
// SPDX-License-Identifier: MIT
#include "grader/confine/builder.hpp"
#include "grader/confine/testable_walls.hpp"
#include "image/oiio.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

namespace {

using grader::Confinement;
using grader::Ended;
using grader::Walls;

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

const char* const lesson = "lesson_05_attenuation";

class Builder : public testing::TestWithParam<Walls> {
  protected:
    int slot() const { return 210 + static_cast<int>(GetParam()); }
    grader::Built build(const std::string& text) const {
        return grader::build(confinement, kit, {std::string(lesson) + ".cpp", text, {}}, slot());
    }
    grader::Drawing drawing(const grader::Built& built) const {
        grader::Drawing drawing;
        drawing.program = built.program;
        drawing.shaders = grader::labShaders();
        drawing.lines = {"--time 0.5", "--time 2 --terms -clamp"};
        drawing.width = 48;
        drawing.height = 32;
        return drawing;
    }
    Confinement confinement{GetParam()};
    grader::Kit kit = grader::findKit();
};

TEST_P(Builder, DrawsWhatTheLessonDraws) {
    const grader::Built built =
        build(contents(std::string(LAMBERT_SOURCE_DIR) + "/lessons/" + lesson + ".cpp"));
    ASSERT_TRUE(built.ok) << built.log << built.trouble;
    EXPECT_EQ(built.log, "");
    const grader::Frames drawn = grader::draw(confinement, kit, drawing(built), slot());
    EXPECT_EQ(drawn.outcome.how, Ended::exited) << drawn.outcome.trouble;
    EXPECT_EQ(drawn.outcome.status, 0) << drawn.outcome.said;
    const support::TemporaryDirectory directory;
    ASSERT_EQ(
        support::run({lesson, "--size", "48x32", "--time", "2", "--terms", "-clamp", "--frame", "a.exr"},
                     directory.path())
            .status,
        0);
    const image::Frame outside = image::readFrame(directory.file("a.exr"));
    EXPECT_EQ(drawn.problems, std::vector<std::string>(2));
    ASSERT_EQ(drawn.frames.size(), 2U);
    EXPECT_TRUE(drawn.frames[1] == std::get<image::Floats>(outside.pixels));
    EXPECT_FALSE(drawn.frames[0] == drawn.frames[1]);

    const grader::Dump dump = grader::dumpScene(confinement, kit, drawing(built), 2, slot());
    EXPECT_EQ(dump.problem, "") << dump.outcome.said;
    grader::Drawing viewer = drawing(built);
    viewer.program = grader::programBytes("scene_viewer");
    viewer.words = {"in/scene.json"};
    viewer.files = {{"scene.json", dump.scene}};
    viewer.lines = {"--terms -clamp"};
    const grader::Frames viewed = grader::draw(confinement, kit, viewer, slot());
    EXPECT_EQ(viewed.problems, std::vector<std::string>(1)) << viewed.outcome.said;
}

TEST_P(Builder, SeesOnlyTheShadersThatItIsGiven) {
    const grader::Built built =
        build("#include \"lab/lab.hpp\"\n#include <fstream>\n#include <iostream>\n"
              "int main(int argc, char** argv) {\n"
              "    for (const char* file : {\"albedo\", \"clamp\"})\n"
              "        std::cout << std::ifstream(image::home() / \"share/lambert-lab/shaders/terms\" /\n"
              "            (std::string(file) + \".glsl\")).rdbuf() << '\\n';\n"
              "    lab::App app(argc, argv, \"x\");\n    return 0;\n}\n"
              "#include \"image/home.hpp\"\n");
    EXPECT_FALSE(built.ok);  // its include comes too late
    EXPECT_NE(built.log.find("lesson_05_attenuation.cpp:6:"), std::string::npos) << built.log;
    EXPECT_EQ(built.log.find("in/lesson"), std::string::npos) << built.log;
    const grader::Built fixed = build(
        "#include \"lab/lab.hpp\"\n#include \"image/home.hpp\"\n#include <fstream>\n#include <iostream>\n"
        "int main() {\n"
        "    for (const char* file : {\"albedo\", \"clamp\"})\n"
        "        std::cout << file << std::ifstream(image::home() / \"share/lambert-lab/shaders/terms\" /\n"
        "            (std::string(file) + \".glsl\")).rdbuf() << std::endl, std::cout.clear();\n}\n");
    ASSERT_TRUE(fixed.ok) << fixed.log;
    grader::Drawing given = drawing(fixed);
    given.shaders = {{"terms/albedo.glsl", "MINE"}};
    const grader::Frames drawn = grader::draw(confinement, kit, given, slot());
    EXPECT_EQ(drawn.outcome.said, "albedoMINE\nclamp");
    EXPECT_EQ(drawn.problems[1], "frame 1 was not written");
}

INSTANTIATE_TEST_SUITE_P(Walls, Builder, testing::ValuesIn(grader::testableWalls()), grader::wallsName);

}  // namespace
