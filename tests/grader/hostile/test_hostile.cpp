// Programs that mean harm: each is built, runs within its walls, ends as the table says, and leaves nothing behind.
// SPDX-License-Identifier: MIT
#include "grader/hostile/fixture.hpp"

namespace {

using namespace hostile;
using grader::Walls;

const char* const clockIsUp = "out of time: more than 1 s on the clock";
const char* const none = "frame 0 was not written";

// What the walls are for.
const Case attacks[] = {
    {"endless_loop", clockIsUp, none},
    {"asleep", clockIsUp, none},
    {"stopped", clockIsUp, none, "^$"},
    {"processor_eater", "out of time: more than .*", none},
    {"fork_bomb", clockIsUp, none},
    {"thread_bomb", "exited 0", none, "^threads: refused\n$"},
    {"memory_bomb", "exited 1", none, "^memory: refused\n$"},
    {"memory_bomb_forks", "killed 9: more than 256 MB of memory", none},
    {"hidden_memory", "exited 0", none, "^(memfd_create|shmget|/dev/shm): refused\n"},
    {"disk_one_file", "killed 25: wrote more than 4 MB to a file or 16 MB in all", none},
    {"disk_many_files", "exited 1|killed 25: wrote more than 4 MB to a file or 16 MB in all", none},
    {"many_files", "killed 25: made more than 500 files", none},
    {"daemon", "exited 0", none},
    {"symbolic_link", "exited 0", "frame 0 is a symbolic link"},
    {"hard_link", "exited 0", "frame 0 has other names .hard links."},
    {"other_out_folder", "exited 0", none},
    {"own_report", "exited 0", none},
    {"praise", "exited 0", none, "Grade :=>>100"},
    {"ten_gigabytes", clockIsUp, none, "^x{16384}$"},
    {"closed_streams", "exited 0", "", "^$"},
    {"reads_the_machine", "exited 0", none, "^(open: refused\n)+$"},
    {"reads_processes", "exited 0", none,
     "open: refused\nptrace: refused\nprocess_vm_readv: refused\nprlimit: refused\n$"},
    {"network", "exited 0", none, "^(socket: refused\n){5}$"},
    {"kills_all", "exited 0", "", "^all gone\\?\n$"},
    {"new_walls", "exited 0", none, "^([a-z_]+: refused\n){18}$"},
    {"preload", "exited 0", none, "here again\n$"},
    {"deep_folders", "exited 0", none},
};

// What is the same behind all walls.
const Case pictures[] = {
    {"named_pipe", "exited 0", "frame 0 is no plain file .*"},
    {"folder", "exited 0", "frame 0 is no plain file .*"},
    {"short_frame", "exited 0", "frame 0 is 413 bytes long, expected 1549"},
    {"long_frame", "exited 0", "frame 0 is 400013 bytes long, expected 1549"},
    {"huge_header", "exited 0", "frame 0: it is no PFM picture of 16x8 pixels"},
    {"not_a_number", "exited 0", "frame 0: pixel 0,0 is NaN"},
    {"infinite", "exited 0", "frame 0: pixel 0,0 is infinite"},
    {"constant_frame", "exited 0", ""},
    {"headless", "exited 0", none, "^nobody looks\n$"},
    {"no_frames", "exited 0", none},
    {"aborts", "killed 6", none},
    {"bad_pointer", "killed 11", none},
    {"stack_overflow", "killed 11", none},
};

class Hostile : public testing::TestWithParam<std::tuple<Walls, Case>> {};

TEST_P(Hostile, EndsAsTheTableSays) {
    const auto& [walls, expected] = GetParam();
    const Machine machine;
    const grader::Confinement confinement(walls);
    const grader::Kit kit = grader::findKit();
    const int slot = slotOf(expected.name, walls);
    const grader::Built built = grader::build(
        confinement, kit, sourceOf("runs/" + std::string(expected.name) + ".cpp", machine), slot);
    ASSERT_TRUE(built.ok) << built.log << built.trouble;

    grader::Drawing drawing;
    drawing.program = built.program;
    drawing.shaders = {{"mesh.frag", "void main() {}\n"}};
    drawing.lines = {""};
    drawing.width = 16;
    drawing.height = 8;
    drawing.limits = tight();
    if (expected.name == std::string("processor_eater")) {
        drawing.limits.cpuSeconds = 1;
        drawing.limits.wallSeconds = 4;
    }
    const grader::Frames drawn = grader::draw(confinement, kit, drawing, slot);

    expectMatch(endingOf(drawn.outcome), expected.ends, "ending");
    expectMatch(drawn.problems[0], expected.problem, "problem");
    EXPECT_EQ(drawn.frames[0].empty(), !drawn.problems[0].empty());
    EXPECT_TRUE(std::regex_search(drawn.outcome.said, std::regex(expected.says)))
        << drawn.outcome.said.substr(0, 2000);
    EXPECT_EQ(drawn.outcome.said.find(secret), std::string::npos);
    EXPECT_EQ(drawn.outcome.said, grader::harmless(drawn.outcome.said));
    EXPECT_EQ(drawn.outcome.said.find_first_of("\x1b\x07\x08\r"), std::string::npos);
    EXPECT_LE(drawn.outcome.said.size(), drawing.limits.saidBytes * 3);  // a byte may become three
    EXPECT_LT(drawn.outcome.seconds, 8);
    machine.expectUntouched(slot);
}

TEST(HostileFiles, RunsAreAllInATable) { expectAllInTables("runs", attacks, pictures); }

INSTANTIATE_TEST_SUITE_P(Attacks, Hostile,
                         testing::Combine(testing::ValuesIn(grader::testableWalls()),
                                          testing::ValuesIn(attacks)),
                         CaseName());
INSTANTIATE_TEST_SUITE_P(Pictures, Hostile,
                         testing::Combine(testing::Values(grader::testableWalls().front()),
                                          testing::ValuesIn(pictures)),
                         CaseName());

}  // namespace
