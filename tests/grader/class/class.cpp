// Which submissions are whose, and what becomes of those that go wrong.
// SPDX-License-Identifier: MIT
#include "grader/class/class.hpp"

#include "grader/class/entries.hpp"
#include "grader/class/pool.hpp"
#include "grader/class/result.hpp"
#include "grader/grading/scratch.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace grader {

namespace {

namespace fs = std::filesystem;

int number(const std::string& text) {
    const bool digits =
        !text.empty() && text.size() < 7 &&
        std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    return digits ? std::atoi(text.c_str()) : -1;
}

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

Shard shardOf(int index, int count, const std::string& where) {
    if (index < 1 || count < 1 || index > count)
        throw UsageError(where + ": expected I/N, with I from 1 to N");
    return {index, count};
}

// Grades a shard of a class, one process for each submission: whatever a submission does to its process, it does to it alone.
class ClassRun {
  public:
    ClassRun(const Grader& grader, const ClassOptions& options)
        : grader_(grader), options_(options), results_(resultsFolder(options.report)) {
        const std::vector<fs::path> all = entriesOf(options.submissions);
        if (all.empty())
            throw UsageError(options.submissions.string() + ": is empty; expected one entry per submission");
        for (std::size_t i = 0; i < all.size(); ++i)
            if (static_cast<int>(i % static_cast<std::size_t>(options.shard.count)) ==
                options.shard.index - 1)
                mine_.push_back(all[i]);
    }

    /// How many could not be graded.
    int run() {
        fs::create_directories(results_);
        sweep(results_);
        if (options_.resume)
            leaveOutDoneOnes();
        if (mine_.empty())
            return 0;
        grader_.prepare();
        int failed = 0;
        runPool(
            mine_.size(), options_.jobs, [this](std::size_t i) { return grade(mine_[i]); },
            [&](std::size_t i, const std::string& why) {
                ++failed;
                if (!why.empty())  // else its report is written and says what was wrong
                    noteTrouble(mine_[i], why);
            });
        sweep(results_);  // of those that died
        return failed;
    }
    std::size_t count() const { return mine_.size(); }

  private:
    fs::path resultOf(const fs::path& submission) const { return results_ / submission.filename(); }

    // Other people's archives are opened only in processes of their own.
    void leaveOutDoneOnes() {
        std::vector<fs::path> before, left;
        for (const fs::path& submission : mine_)
            (fs::exists(resultOf(submission)) ? before : left).push_back(submission);
        runPool(
            before.size(), options_.jobs, [&](std::size_t i) { return isDone(before[i]); },
            [&](std::size_t i, const std::string&) { left.push_back(before[i]); });
        std::sort(left.begin(), left.end());
        mine_ = std::move(left);
    }
    bool isDone(const fs::path& submission) const {
        const fs::path folder = resultOf(submission);
        const std::optional<Result> result = readResult(folder);
        return result && result->report.status != ReportStatus::infrastructure &&
               hasAllFiles(*result, folder, options_.formats) &&
               result->key ==
                   ResultKey{grader_.hashOf(submission), grader_.toolHash(), grader_.rubric().hash};
    }

    bool grade(const fs::path& submission) const {
        const Graded graded = grader_.grade(submission);
        write(graded, submission);
        return graded.report.status != ReportStatus::infrastructure;
    }
    void write(const Graded& graded, const fs::path& submission) const {
        writeResult(graded, {graded.report.submissionHash, grader_.toolHash(), grader_.rubric().hash},
                    grader_, resultOf(submission), options_.formats);
    }

    // What a process that died, or threw, leaves behind instead of marks.
    void noteTrouble(const fs::path& submission, const std::string& why) const {
        const std::string name = submission.filename().string();
        std::cerr << "grade: " << oneLine(name) << ": " << oneLine(why) << std::endl;
        Graded graded;
        graded.report.toolVersion = LAMBERT_VERSION;
        graded.report.lesson = grader_.rubric().lesson;
        graded.report.lessonTitle = grader_.lessonTitle();
        graded.report.language = grader_.language();
        graded.report.submission = name;
        graded.report.rubricHash = grader_.rubric().hash;
        graded.report.maxScore = grader_.rubric().points;
        graded.report.reason = why;
        try {
            write(graded, submission);
        } catch (const std::exception& error) {  // told already; merging will find no result
            std::cerr << "grade: " << oneLine(name) << ": " << oneLine(error.what()) << std::endl;
        }
    }

    const Grader& grader_;
    const ClassOptions& options_;
    fs::path results_;
    std::vector<fs::path> mine_;
};

// Else the next run would take the report for a submission.
void refuseReportInside(const ClassOptions& options) {
    const fs::path report = fs::weakly_canonical(options.report),
                   folder = fs::weakly_canonical(options.submissions);
    if (std::search(report.begin(), report.end(), folder.begin(), folder.end()) == report.begin())
        throw UsageError(options.report.string() + ": lies among the submissions in " +
                         options.submissions.string() + "; expected a folder elsewhere");
}

}  // namespace

Shard parseShard(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
        throw UsageError("--shard " + text + ": expected I/N, with I from 1 to N");
    return shardOf(number(text.substr(0, slash)), number(text.substr(slash + 1)), "--shard " + text);
}

Shard shardOfEnvironment() {
    if (const std::string task = variable("SLURM_ARRAY_TASK_ID"); !task.empty()) {
        const std::string first = variable("SLURM_ARRAY_TASK_MIN"), step = variable("SLURM_ARRAY_TASK_STEP");
        const int from = number(task) - (first.empty() ? 1 : number(first));
        return shardOf(from / std::max(1, number(step)) + 1, number(variable("SLURM_ARRAY_TASK_COUNT")),
                       "SLURM_ARRAY_TASK_ID " + task + " of SLURM_ARRAY_TASK_COUNT " +
                           variable("SLURM_ARRAY_TASK_COUNT"));
    }
    if (const std::string job = variable("JOB_COMPLETION_INDEX"); !job.empty())  // Kubernetes counts from 0
        return shardOf(number(job) + 1, number(variable("JOB_COMPLETIONS")),
                       "JOB_COMPLETION_INDEX " + job + " of JOB_COMPLETIONS " + variable("JOB_COMPLETIONS"));
    return {};
}

int gradeClass(const Grader& grader, const ClassOptions& options) {
    refuseReportInside(options);
    ClassRun run(grader, options);
    const int failed = run.run();
    if (options.shard.count == 1)
        return std::max(failed, mergeClass(options.report, grader.language(), options.submissions));
    std::cout << "shard " << options.shard.index << "/" << options.shard.count << ": " << run.count()
              << " graded, " << failed
              << " of them without marks; when all shards are done: grade --merge --class "
              << options.submissions.string() << " --report " << options.report.string() << std::endl;
    return failed;
}

}  // namespace grader
