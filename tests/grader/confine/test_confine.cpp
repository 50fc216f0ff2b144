// What a confinement gives and takes: files in, files out, limits, words; as root and as anybody.
// SPDX-License-Identifier: MIT
#include "grader/confine/confine.hpp"
#include "grader/confine/start.hpp"
#include "grader/confine/testable_walls.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using grader::Confinement;
using grader::Ended;
using grader::Job;
using grader::Outcome;
using grader::Walls;

Job shell(const std::string& script) {
    Job job;
    job.command = {"sh", "-c", script};
    job.limits.wallSeconds = 5;
    return job;
}

class Confine : public testing::TestWithParam<Walls> {
  protected:
    Outcome run(const Job& job) const { return confinement.run(job, 200 + static_cast<int>(GetParam())); }
    Confinement confinement{GetParam()};
};

TEST_P(Confine, RunsWithWhatItIsGiven) {
    Job job = shell(
        "cat in/text.txt ../lab/data/CMakeLists.txt; ../lab/bin/tool; cat \"$1\"; echo \"$WHERE\"; pwd");
    job.command.insert(job.command.end(), {"sh", "{root}/lab/bin/tool"});
    job.texts = {{"/box/in/text.txt", "a text\n"}, {"/lab/bin/tool", "#!/bin/sh\necho a tool\n"}};
    job.mounts = {{LAMBERT_SOURCE_DIR "/lessons", "/lab/data"}};
    job.environment = {{"WHERE", "{root}/lab"}};
    const Outcome outcome = run(job);
    EXPECT_EQ(outcome.how, Ended::exited) << outcome.trouble;
    EXPECT_EQ(outcome.status, 0) << outcome.said;
    for (const char* part :
         {"a text\n", "add_lesson(scene_viewer)", "a tool\n#!/bin/sh\n", "/lab\n", "/box\n"}) {
        EXPECT_NE(outcome.said.find(part), std::string::npos) << part << outcome.said;
    }
    EXPECT_EQ(outcome.said.find("{root}"), std::string::npos);
}

TEST_P(Confine, GivesBackWhatIsWanted) {
    Job job = shell("printf 123456 > out/a; printf 12 > out/b; printf 123 > out/c; exit 7");
    job.wanted = {{"a", 6, true}, {"b", 10, false}, {"c", 2, false}, {"d", 2, true}};
    const Outcome outcome = run(job);
    EXPECT_EQ(outcome.how, Ended::exited) << outcome.trouble;
    EXPECT_EQ(outcome.status, 7);
    ASSERT_EQ(outcome.files.size(), 4U);
    EXPECT_EQ(outcome.files[0].bytes, "123456");
    EXPECT_EQ(outcome.files[1].bytes, "12");
    EXPECT_EQ(outcome.files[2].problem, "is 3 bytes long, expected at most 2");
    EXPECT_EQ(outcome.files[3].problem, "was not written");
}

TEST_P(Confine, KeepsTimesApart) {
    Job job = shell("sleep 9");
    job.limits.wallSeconds = 0.5;
    const Outcome clock = run(job);
    EXPECT_EQ(clock.how, Ended::outOfTime);
    EXPECT_EQ(clock.limit, "more than 0.5 s on the clock");
    EXPECT_LT(clock.seconds, 4);
    job = shell("while :; do :; done");
    job.limits.wallSeconds = 30;
    job.limits.cpuSeconds = 1;
    EXPECT_EQ(run(job).limit, "more than 1 s of processor time");
}

TEST_P(Confine, SaysWhatIsWrongWithAJob) {
    Job job;
    EXPECT_NE(run(job).trouble.find("it has no command"), std::string::npos);
    job = shell("true");
    job.wanted = {{"../x", 1, true}};
    EXPECT_NE(run(job).trouble.find("'../x' is no name of a wanted file"), std::string::npos);
    job = shell("true");
    job.texts = {{"in/x", ""}};
    EXPECT_NE(run(job).trouble.find("'in/x' is no absolute path"), std::string::npos);
    job = shell("true");
    job.mounts = {{"/no/such/folder", "/lab/x"}};
    job.wanted = {{"x", 1, true}};
    const Outcome outcome = run(job);
    EXPECT_EQ(outcome.how, Ended::notStarted);
    EXPECT_NE(outcome.trouble.find("/no/such/folder"), std::string::npos) << outcome.trouble;
    ASSERT_EQ(outcome.files.size(), 1U);
    EXPECT_EQ(outcome.files[0].problem, "was not written");
    job = shell("true");
    job.command = {"/no/such/program"};
    EXPECT_NE(run(job).trouble.find("cannot start /no/such/program: No such file"), std::string::npos);
}

// Graders run as root in containers, and as anybody elsewhere.
TEST_P(Confine, WorksForAnybody) {
    if (::geteuid() != 0) {
        return;  // the other tests were it
    }
    EXPECT_EQ(run(shell("test $(id -u) -ge 64000 && test $(id -g) -ge 64000")).status, 0);
    const pid_t child = ::fork();
    if (child == 0) {
        Outcome outcome;
        if (::setresgid(65534, 65534, 65534) == 0 && ::setresuid(65534, 65534, 65534) == 0) {
            outcome = Confinement(GetParam()).run(shell("test $(id -u) = 65534 && exit 42"));
        }
        ::_exit(outcome.how == Ended::exited && outcome.status == 42 ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

TEST_P(Confine, SaysWhatHolds) {
    EXPECT_NE(confinement.description().find("seccomp"), std::string::npos);
    EXPECT_EQ(confinement.walls(), GetParam());
    EXPECT_EQ(confinement.description().find("can read every file") != std::string::npos,
              GetParam() == Walls::limits);
}

INSTANTIATE_TEST_SUITE_P(Walls, Confine, testing::ValuesIn(grader::testableWalls()), grader::wallsName);
INSTANTIATE_TEST_SUITE_P(LastResort, Confine, testing::Values(Walls::limits), grader::wallsName);

TEST(ConfineWalls, AreAllTestedHere) {
    if (grader::testableWalls().front() != Walls::bubblewrap)
        GTEST_SKIP()
            << "this machine gives no namespaces (a container, a chroot): bubblewrap is not tested here";
    EXPECT_EQ(Confinement().walls(), Walls::bubblewrap);
}

// Two graders that know nothing of each other would end each other's jobs by the limit on a user's processes.
TEST(ConfineUsers, AreForOneJobOfThisMachineAtATime) {
    std::vector<std::unique_ptr<grader::Lease>> leases;
    std::set<uid_t> users;
    for (int i = 0; i < 10; ++i) {
        leases.push_back(std::make_unique<grader::Lease>(0));
        ASSERT_EQ(leases.back()->user().has_value(), ::geteuid() == 0);
        if (leases.back()->user()) {
            EXPECT_TRUE(users.insert(*leases.back()->user()).second);
        }
    }
    EXPECT_EQ(users.count(0), 0U);
}

TEST(ConfineText, HarmlessKeepsTextAndNothingElse) {
    const std::string good = "Grüße, ω·n ≥ 0 ✓\n\tline\n";
    EXPECT_EQ(grader::harmless(good), good);
    const std::string bad = "\xEF\xBF\xBD";
    EXPECT_EQ(grader::harmless("a\x1b[2Jb\r\n\x07"), "ab\n" + bad);
    EXPECT_EQ(grader::harmless(std::string("\0x", 2)), bad + "x");
    EXPECT_EQ(grader::harmless("\xc0\xaf"), bad + bad);  // a slash in two bytes
    EXPECT_EQ(grader::harmless("\xed\xa0\x80"), bad + bad + bad);  // half of a pair of UTF-16
    EXPECT_EQ(grader::harmless("\xe2\x82"), bad + bad);  // the euro sign without its end
    EXPECT_EQ(grader::harmless("\xc2\x9b"
                               "31m"),
              bad + "31m");  // an escape in one character
    EXPECT_EQ(grader::harmless("\xe2\x80\xae"
                               "001"),
              bad + "001");  // from right to left
    EXPECT_EQ(grader::harmless("\xf4\x90\x80\x80"), bad + bad + bad + bad);  // beyond Unicode
}

}  // namespace
