// Sources and shaders that mean harm to the compiler, to the driver, or through them.
// SPDX-License-Identifier: MIT
#include "grader/hostile/fixture.hpp"

namespace {

using namespace hostile;
using grader::Walls;

grader::Limits tightForCompilers() {
    grader::Limits limits = grader::buildLimits();
    limits.wallSeconds = 3;
    limits.cpuSeconds = 2;
    limits.memoryBytes = std::uint64_t{400} << 20;
    limits.fileBytes = std::uint64_t{8} << 20;
    return limits;
}

// What the walls are for.
const Case thefts[] = {
    {"endless_file", "", "",
     "is a character device|No such file|stopped: more than|terminated|out of memory|virtual memory|CPU "
     "time"},
    {"giant_object", "", "",
     "File size limit|No space|truncated|too big|File too large|final|terminated|stopped"},
    {"embeds", "", "", "(file not found|No such file|cannot open|Permission denied)"},
    {"includes_the_machine", "", "", "secret.txt: (No such file|Permission denied)"},
};

// What limits are for.
const Case bombs[] = {
    {"template_bomb", "", "", "stopped: more than|terminated|out of memory|virtual memory|CPU time"},
    {"template_recursion", "", "", "template instantiation depth"},
    {"constexpr_loop", "", "", "loop iteration count exceeds|operation count exceeds|stopped: more than"},
    {"macro_bomb", "", "", "stopped: more than|terminated|out of memory|virtual memory|CPU time"},
    {"itself", "", "", "redefinition"},
    {"thousand_errors", "", "", "error"},
};

class HostileBuild : public testing::TestWithParam<std::tuple<Walls, Case>> {};

TEST_P(HostileBuild, IsRefusedShortly) {
    const auto& [walls, expected] = GetParam();
    const Machine machine;
    const grader::Confinement confinement(walls);
    const int slot = slotOf(expected.name, walls);
    const grader::Built built = grader::build(
        confinement, grader::findKit(), sourceOf("builds/" + std::string(expected.name) + ".cpp", machine),
        slot, tightForCompilers());
    EXPECT_FALSE(built.ok);
    EXPECT_TRUE(built.program.empty());
    EXPECT_EQ(built.trouble, "");
    EXPECT_TRUE(std::regex_search(built.log, std::regex(expected.says))) << built.log;
    EXPECT_EQ(built.log.find(secret), std::string::npos);
    EXPECT_EQ(built.log.find('\x1b'), std::string::npos);
    EXPECT_LE(std::count(built.log.begin(), built.log.end(), '\n'), 61);
    EXPECT_LT(built.seconds, 8);
    machine.expectUntouched(slot);
}

INSTANTIATE_TEST_SUITE_P(Thefts, HostileBuild,
                         testing::Combine(testing::ValuesIn(grader::testableWalls()),
                                          testing::ValuesIn(thefts)),
                         CaseName());
INSTANTIATE_TEST_SUITE_P(Bombs, HostileBuild,
                         testing::Combine(testing::Values(grader::testableWalls().front()),
                                          testing::ValuesIn(bombs)),
                         CaseName());

const Case shaders[] = {
    {"endless", "out of time: more than 3 s on the clock", "frame 0 was not written"},
    {"macro_bomb", "(out of time|killed|exited [1-9]).*", "frame 0 was not written"},
    {"not_a_number", "exited 0", ""},  // the lab itself draws the lowest number there (range.glsl)
    {"broken", "exited [1-9].*", "frame 0 was not written", "clamp.glsl"},
};

class HostileShader : public testing::TestWithParam<std::tuple<Walls, Case>> {};

TEST_P(HostileShader, EndsAsTheTableSays) {
    const auto& [walls, expected] = GetParam();
    const Machine machine;
    const grader::Confinement confinement(walls);
    grader::Drawing drawing;
    drawing.program = grader::programBytes("scene_viewer");
    drawing.words = {"in/scene.json"};
    drawing.files = {{"scene.json", contents(fs::path(LAMBERT_SOURCE_DIR) / "slides_refs/scenes/ball.json")}};
    drawing.shaders = grader::labShaders();
    drawing.shaders.at("terms/clamp.glsl") =
        contents(folder() / "shaders" / (std::string(expected.name) + ".glsl"));
    drawing.lines = {""};
    drawing.width = 16;
    drawing.height = 8;
    drawing.limits.wallSeconds = 3;
    drawing.limits.cpuSeconds = 10;
    const int slot = slotOf(expected.name, walls);
    const grader::Frames drawn = grader::draw(confinement, grader::findKit(), drawing, slot);
    expectMatch(endingOf(drawn.outcome), expected.ends, "ending");
    expectMatch(drawn.problems[0], expected.problem, "problem");
    EXPECT_TRUE(std::regex_search(drawn.outcome.said, std::regex(expected.says))) << drawn.outcome.said;
    EXPECT_EQ(drawn.outcome.said.find('\x1b'), std::string::npos);
    machine.expectUntouched(slot);
}

INSTANTIATE_TEST_SUITE_P(Shaders, HostileShader,
                         testing::Combine(testing::Values(grader::testableWalls().front()),
                                          testing::ValuesIn(shaders)),
                         CaseName());

TEST(HostileFiles, BuildsAndShadersAreAllInATable) {
    expectAllInTables("builds", thefts, bombs);
    expectAllInTables("shaders", shaders);
}

// Names as they come out of archives: for the shell, for options, for other folders.
TEST(HostileNames, AreTamedOrRefused) {
    const Machine machine;
    const grader::Confinement confinement;
    const grader::Kit kit = grader::findKit();
    for (const char* name : {"-o.cpp", "--help", "a b\nc;$(touch x).cpp", "\xe2\x80\xaelezione \xc3\xa9.cpp",
                             "../../../../x.cpp", ""}) {
        const grader::Built built = grader::build(confinement, kit,
                                                  {name,
                                                   "#include \"\xc3\xa9 x.hpp\"\nint main() { return x; }\n",
                                                   {{"\xc3\xa9 x.hpp", "const int x = 0;\n"}}},
                                                  5);
        EXPECT_TRUE(built.ok) << name << built.log << built.trouble;
    }
    for (const char* name : {"../x.hpp", "/etc/x.hpp", "a/../../x.hpp", ""}) {
        const grader::Built built =
            grader::build(confinement, kit, {"a.cpp", "int main() {}\n", {{name, "x"}}}, 5);
        EXPECT_FALSE(built.ok) << name;
        EXPECT_NE(built.log.find("leads out of the submission"), std::string::npos) << built.log;
    }
    machine.expectUntouched(5);
}

}  // namespace
