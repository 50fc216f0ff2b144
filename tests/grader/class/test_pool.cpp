// The pool of processes, with workers that go wrong in every way, and a cluster's words for shards.
// SPDX-License-Identifier: MIT
#include "grader/class/class.hpp"
#include "grader/class/pool.hpp"
#include "support/program.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <map>
#include <stdexcept>
#include <unistd.h>

namespace {

using support::writeFile;

TEST(Pool, WhatHappensToOneWorkerHappensToItAlone) {
    std::map<std::size_t, std::string> trouble;
    const support::TemporaryDirectory directory;
    grader::runPool(
        8, 3,
        [&](std::size_t i) {
            if (i == 1)
                std::abort();
            if (i == 2)
                throw std::runtime_error("no luck");
            while (i == 3)
                pause();
            if (i == 4)
                _exit(9);
            writeFile(directory.path() / std::to_string(i), "done");
            return i != 5;
        },
        [&](std::size_t i, const std::string& why) { trouble[i] = why; }, 1);
    EXPECT_EQ(directory.contents(), (std::vector<std::string>{"0", "5", "6", "7"}));
    EXPECT_EQ(trouble.size(), 5U);
    EXPECT_EQ(trouble[1], "the grader's process was ended by signal Aborted");
    EXPECT_EQ(trouble[2], "no luck");
    EXPECT_EQ(trouble[3], "the grader's process took too long and was ended");
    EXPECT_EQ(trouble[4], "the grader's process ended without a word");
    EXPECT_EQ(trouble[5], "");
}

// What a cluster tells its tasks.
std::string shardWith(const std::map<std::string, std::string>& environment) {
    for (const auto& [name, value] : environment)
        setenv(name.c_str(), value.c_str(), 1);
    std::string text;
    try {
        const grader::Shard shard = grader::shardOfEnvironment();
        text = std::to_string(shard.index) + "/" + std::to_string(shard.count);
    } catch (const grader::UsageError&) {
        text = "refused";
    }
    for (const auto& [name, value] : environment)
        unsetenv(name.c_str());
    return text;
}

TEST(Shards, AreReadFromTheClustersOwnVariables) {
    const auto slurm = [](const char* id, const char* first, const char* step, const char* count) {
        return shardWith({{"SLURM_ARRAY_TASK_ID", id},
                          {"SLURM_ARRAY_TASK_MIN", first},
                          {"SLURM_ARRAY_TASK_STEP", step},
                          {"SLURM_ARRAY_TASK_COUNT", count}});
    };
    EXPECT_EQ(shardWith({}), "1/1");
    EXPECT_EQ(slurm("1", "1", "1", "20"), "1/20");
    EXPECT_EQ(slurm("19", "0", "1", "20"), "20/20");
    EXPECT_EQ(slurm("14", "10", "2", "3"), "3/3");
    EXPECT_EQ(slurm("15", "10", "1", "3"), "refused");  // a list with gaps
    EXPECT_EQ(slurm("7", "1", "1", "3"), "refused");
    EXPECT_EQ(slurm("x", "1", "1", "3"), "refused");
    EXPECT_EQ(shardWith({{"JOB_COMPLETION_INDEX", "0"}, {"JOB_COMPLETIONS", "4"}}), "1/4");
    EXPECT_EQ(shardWith({{"JOB_COMPLETION_INDEX", "3"}, {"JOB_COMPLETIONS", "4"}}), "4/4");
    EXPECT_EQ(shardWith({{"JOB_COMPLETION_INDEX", "3"}}), "refused");
}

}  // namespace
