// A pool of processes over the submissions of a folder.
// SPDX-License-Identifier: MIT
#include "grader/class/class.hpp"

#include "grader/class/pool.hpp"
#include "grader/class/result.hpp"
#include "grader/class/similarity.hpp"
#include "grader/report/formats/formats.hpp"
#include "image/write.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr const char* temporary = ".";  // what begins so is none of the results

std::vector<fs::path> entriesOf(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> entries;
    for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
        if (!i->path().filename().string().starts_with(temporary))
            entries.push_back(i->path());
    if (error)
        throw UsageError(folder.string() + ": " + error.message() +
                         "; expected a folder with one entry per submission");
    std::sort(entries.begin(), entries.end());
    return entries;
}

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

// What a process that died, or threw, leaves behind instead of marks.
void writeTrouble(const Grader& grader, const fs::path& submission, const fs::path& folder,
                  const ResultKey& key, const std::string& why, const std::string& formats) {
    Graded graded;
    graded.report.lesson = grader.rubric().lesson;
    graded.report.lessonTitle = grader.lessonTitle();
    graded.report.language = grader.language();
    graded.report.submission = submission.filename().string();
    graded.report.rubricHash = grader.rubric().hash;
    graded.report.reason = why;
    writeResult(graded, key, grader, folder, formats);
}

bool isDone(const fs::path& folder, const ResultKey& key) {
    const std::optional<Result> result = readResult(folder);
    return result && result->key == key && result->report.status != ReportStatus::infrastructure;
}

std::vector<Result> resultsOf(const fs::path& report) {
    std::vector<Result> results;
    for (const fs::path& folder : entriesOf(resultsFolder(report)))
        if (std::optional<Result> result = readResult(folder))
            results.push_back(std::move(*result));
    return results;
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
        const std::string first = variable("SLURM_ARRAY_TASK_MIN");
        return shardOf(number(task) - (first.empty() ? 1 : number(first)) + 1,
                       number(variable("SLURM_ARRAY_TASK_COUNT")),
                       "SLURM_ARRAY_TASK_ID " + task + " of SLURM_ARRAY_TASK_COUNT " +
                           variable("SLURM_ARRAY_TASK_COUNT"));
    }
    if (const std::string job = variable("JOB_COMPLETION_INDEX"); !job.empty())  // Kubernetes counts from 0
        return shardOf(number(job) + 1, number(variable("JOB_COMPLETIONS")),
                       "JOB_COMPLETION_INDEX " + job + " of JOB_COMPLETIONS " + variable("JOB_COMPLETIONS"));
    return {};
}

int gradeClass(const Grader& grader, const ClassOptions& options) {
    parseFormats(options.formats);
    const std::vector<fs::path> all = entriesOf(options.submissions);
    if (all.empty())
        throw UsageError(options.submissions.string() + ": is empty; expected one entry per submission");
    const fs::path results = resultsFolder(options.report);
    fs::create_directories(results);
    const auto keyOf = [&](const fs::path& submission) {
        return ResultKey{grader.hashOf(submission), grader.toolHash(), grader.rubric().hash};
    };
    std::vector<fs::path> mine;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (static_cast<int>(i % static_cast<std::size_t>(options.shard.count)) == options.shard.index - 1 &&
            !(options.resume && isDone(results / all[i].filename(), keyOf(all[i]))))
            mine.push_back(all[i]);
    grader.prepare();
    int failed = 0;
    runPool(
        mine.size(), options.jobs,
        [&](std::size_t i, int slot) {
            const Graded graded = grader.grade(mine[i], slot);
            writeResult(graded, {graded.report.submissionHash, grader.toolHash(), grader.rubric().hash},
                        grader, results / mine[i].filename(), options.formats);
            return graded.report.status != ReportStatus::infrastructure;
        },
        [&](std::size_t i, const std::string& why) {
            ++failed;
            if (why.empty())
                return;  // its report is written and says what was wrong
            std::cerr << "grade: " << harmless(mine[i].filename().string()) << ": " << why << std::endl;
            writeTrouble(grader, mine[i], results / mine[i].filename(), keyOf(mine[i]), why, options.formats);
        });
    if (options.shard.count > 1) {
        std::cout << "shard " << options.shard.index << "/" << options.shard.count << ": " << mine.size()
                  << " graded; when all shards are done: grade --merge --report " << options.report.string()
                  << std::endl;
        return failed;
    }
    return mergeClass(options.report, grader.language());
}

int mergeClass(const fs::path& report, Language language) {
    std::vector<Result> results = resultsOf(report);
    if (results.empty())
        throw UsageError(resultsFolder(report).string() + ": holds no result; grade the class first");
    findSimilar(results, language);
    std::vector<Report> reports;
    std::vector<ClassMember> members;
    int failed = 0;
    for (const Result& result : results) {
        reports.push_back(result.report);
        members.push_back(
            {result.report, "results/" + result.report.submission + "/" + fileNameOf(Format::html)});
        failed += result.report.status == ReportStatus::infrastructure ? 1 : 0;
    }
    image::writeText((report / "marks.csv").string(), marksCsv(reports));
    image::writeText((report / "overview.html").string(), overview(members, language));
    std::cout << results.size() << " results, " << failed
              << " of them for the grader's own trouble without marks: " << (report / "marks.csv").string()
              << ", " << (report / "overview.html").string() << std::endl;
    return failed;
}

}  // namespace grader
