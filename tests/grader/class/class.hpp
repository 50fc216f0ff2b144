// A whole class: every submission of a folder graded in a pool of processes, each result written whole, resumed, sharded, merged.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/grading/grader.hpp"

namespace grader {

/// Which part of a class one process grades: number `index` of `count`, from 1.
struct Shard {
    int index = 1, count = 1;
};

/// "2/8". Throws UsageError.
Shard parseShard(const std::string& text);
/// From a cluster's environment: SLURM_ARRAY_TASK_ID (with _MIN, _STEP and _COUNT) or JOB_COMPLETION_INDEX (with JOB_COMPLETIONS); none: 1/1.
Shard shardOfEnvironment();

struct ClassOptions {
    std::filesystem::path
        submissions;  ///< each entry is one: a folder, an archive, a .cpp or .glsl; those that begin with a dot are none
    std::filesystem::path report;  ///< results/<submission>/, marks.csv, overview.html
    int jobs = 1;  ///< processes at a time
    bool resume = false;  ///< keep results whose submission, tool and rubric are unchanged
    Shard shard;
    std::string formats;  ///< as writeReport's
};

/// Grades the shard's submissions; of a whole class (shard 1/1) also merges. The number of submissions that could not be graded for
/// the grader's own trouble. Throws UsageError.
int gradeClass(const Grader& grader, const ClassOptions& options);

/// Makes marks.csv and overview.html of the results in a report folder, and notes which render from the same source; the same results
/// give the same marks.csv byte for byte, whoever graded them. `submissions` is the class: results of what is no longer there are told
/// and left out, and what has no result counts as the grader's own trouble; empty: not known, all results count. Returns as
/// gradeClass. Throws UsageError if there is no result.
int mergeClass(const std::filesystem::path& report, Language language,
               const std::filesystem::path& submissions = {});

}  // namespace grader
