// The tool `grade`: marks for submissions of a lesson, one or a whole class.
// SPDX-License-Identifier: MIT
#include "grader/class/class.hpp"
#include "grader/grading/command_line.hpp"
#include "grader/report/formats/formats.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

namespace {

enum ExitStatus { Graded = 0, WrongUsage = 2, Infrastructure = 75 };

using grader::UsageError;

// What the command line says.
struct Request {
    grader::GraderOptions grading;
    std::string submission, report, classFolder, formats = "html", shard, lang, walls;
    std::uint64_t seed = 0;
    int jobs = 1;
    bool resume = false, merge = false;
};

int gradeOne(const Request& request) {
    const grader::Grader grader(request.grading);
    const grader::Graded graded = grader.grade(request.submission);
    grader::replaceReport(graded, request.report, request.formats);
    const grader::Report& report = graded.report;
    std::cout << grader::summary(report) << request.report << "\n";
    if (report.status != grader::ReportStatus::infrastructure)
        return Graded;
    std::cerr << "grade: " << report.reason << "\n";
    return Infrastructure;
}

int gradeClass(const Request& request) {
    grader::ClassOptions options;
    options.submissions = request.classFolder;
    options.report = request.report;
    options.jobs = request.jobs;
    options.resume = request.resume;
    options.formats = request.formats;
    options.shard = request.shard.empty() ? grader::shardOfEnvironment() : grader::parseShard(request.shard);
    const grader::Grader grader(request.grading);
    return grader::gradeClass(grader, options) == 0 ? Graded : Infrastructure;
}

void checkFormats(const std::string& list) {
    try {
        grader::parseFormats(list);
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

int run(int argc, char** argv) {
    CLI::App app("grade: marks for submissions of a lesson, from the frames that they draw");
    Request request;
    app.set_version_flag("--version", LAMBERT_VERSION);
    app.add_option("LESSON", request.grading.lesson, "A name, a part of one, or a number");
    app.add_option("--submission", request.submission, "A folder, an archive, a .cpp or a .glsl");
    app.add_option("--class", request.classFolder, "A folder of submissions");
    app.add_option("--report", request.report, "The folder to write")->required();
    app.add_option("--rubric", request.grading.rubric, "The course's own rubric, instead of the lesson's");
    auto* const seed =
        app.add_option("--seed", request.seed, "Of the hidden views and scenes, instead of the rubric's");
    app.add_option("--lang", request.lang, "it or en, by default the locale's")
        ->check(CLI::IsMember({"it", "en"}));
    app.add_option(
        "--format", request.formats,
        "Comma list: html (default), gradescope, prairielearn, autolab, coderunner, vpl, junit, csv");
    app.add_option("--jobs", request.jobs, "Submissions at a time")->check(CLI::Range(1, 256));
    app.add_flag("--resume", request.resume, "Keep results whose submission, tool and rubric are unchanged");
    app.add_option("--shard", request.shard,
                   "I/N: only this part of the class; by default a job array's own");
    app.add_flag("--merge", request.merge,
                 "Make mark sheet and overview of the results that are there; with --class, of that class");
    app.add_option("--walls", request.walls,
                   "Confine as asked: bubblewrap, landlock or limits; by default the strongest that work")
        ->check(CLI::IsMember({"bubblewrap", "landlock", "limits"}));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Graded : WrongUsage;
    }
    if (seed->count() > 0)
        request.grading.seed = request.seed;
    request.grading.language = grader::languageOf(request.lang);
    request.grading.walls = grader::wallsOf(request.walls);
    if (request.merge)
        return grader::mergeClass(request.report, request.grading.language, request.classFolder) == 0
                   ? Graded
                   : Infrastructure;
    if (request.grading.lesson.empty() || request.submission.empty() == request.classFolder.empty())
        throw UsageError("expected LESSON and either --submission PATH or --class DIR; see --help");
    checkFormats(request.formats);
    return request.classFolder.empty() ? gradeOne(request) : gradeClass(request);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const UsageError& error) {
        std::cerr << "grade: " << error.what() << '\n';
        return WrongUsage;
    } catch (const std::exception& error) {
        std::cerr << "grade: " << error.what() << '\n';
        return Infrastructure;
    }
}
