// The report on one submission: all that any gradebook, page or table says of it is taken from here.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grader {

inline constexpr const char* reportSchema = "lambert-lab/report/1";

enum class Language { it, en };

/// Whether there are marks.
enum class ReportStatus {
    graded,
    notGradable,  ///< nothing in it that could be judged: an empty folder, a broken zip. No attempt should count
    infrastructure  ///< the grader's own trouble: grade it again. Never a mark
};

/// Of one check.
enum class CheckStatus {
    pass,
    partial,
    fail,
    skipped  ///< what it depends on did not pass
};

/// The named misconceptions that explain a frame. Several ids: no picture of these scenes can tell them apart.
struct Explanation {
    std::vector<std::string> ids;  ///< "B3", "B5"
    std::string name;  ///< "w points away from the light"; for a class, all of them, joined with "or"
    std::string hint;  ///< what to think about, without the answer
    std::string convention;  ///< whose convention it is elsewhere, or empty
    double explained = 0;  ///< share of the wrong pixels that it predicts, 0 to 1
    double confidence = 0;  ///< 0 to 1: how much better than the best other explanation, too
};

/// One factor or addend of the equation at the worst pixel, with its value there.
struct TermNumber {
    std::string symbol;  ///< "n . w_1"
    std::string term;  ///< its name in the lab's table of terms, "cosine", or empty
    std::string value;  ///< as text: "0.4132" or "(0.86, 0.53, 0.33)"
};

/// Where a frame is farthest from what was expected. Colours are linear, clamped to [0,1].
struct WorstPixel {
    std::string frame;  ///< which one, in words: "view 2", never with the numbers that made it
    int x = 0, y = 0;  ///< from the top left
    std::string region;  ///< "lit", ...
    std::array<double, 3> found{}, expected{};
    bool ownScene = false;  ///< numbers are those of the student's own scene; false: as they should be
    std::vector<TermNumber> numbers;  ///< may be empty
};

/// How a part of the frames came out.
struct RegionShare {
    std::string name;  ///< lit, unlit, terminator, silhouette, background
    long long pixels = 0;
    double right = 1;  ///< share of them that is as expected
};

struct Check {
    std::string id;  ///< of the rubric: "36.3", "cosine"; "builds", "runs"
    std::string title;
    std::vector<int> slides;  ///< to reread; empty: none
    CheckStatus status = CheckStatus::skipped;
    double score = 0, maxScore = 0;
    bool isNew = true;  ///< of this lesson's step; false: what the starter had already
    std::vector<std::string> dependsOn;  ///< ids
    std::string message;  ///< one sentence: what was found
    std::string expected;  ///< what the slide says should be seen, without the solution
    std::string hint;  ///< what to do next
    std::optional<Explanation> explanation;
    std::optional<WorstPixel> worst;
    std::vector<RegionShare> regions;
    std::vector<std::string> images;  ///< ids of Report::images
    std::string visibility =
        "visible";  ///< Gradescope's words: hidden, after_due_date, after_published, visible
};

/// A PNG beside report.json.
struct ReportImage {
    std::string id;  ///< "view-1-difference"
    std::string role;  ///< yours, expected, difference
    std::string label;  ///< in words; for difference, with what its colours mean
    std::string file;  ///< name in the report's folder
    int width = 0, height = 0;
};

struct SubmittedFile {
    std::string path;  ///< in the submission, as it was called (any bytes; UTF-8 expected)
    std::string role;  ///< lesson, term, header, leftOut
    std::string note;  ///< why it was left out, or empty
    long long bytes = 0;
    std::string sha256;
};

/// Another submission that renders from the same source. Told to the instructor, never judged.
struct Similar {
    std::string submission;
    std::string how;  ///< in words
};

struct Report {
    std::string toolVersion, rubricHash, renderer;  ///< the driver's string
    std::string lesson;  ///< "lesson_05_attenuation"
    std::string lessonTitle;  ///< in words
    Language language = Language::en;
    std::string submission;  ///< its name: the folder's, the zip's or the file's
    std::string submissionHash;  ///< SHA-256 over all its files
    std::vector<SubmittedFile> files;
    ReportStatus status = ReportStatus::infrastructure;
    std::string reason;  ///< why there are no marks; empty if graded
    double score = 0, maxScore = 0;
    std::string confinement;  ///< how it was run, in words: "bubblewrap", "without namespaces: ..."
    std::vector<Check> checks;  ///< builds, runs, then the rubric's
    std::vector<ReportImage> images;
    std::string buildLog;  ///< the compiler's, made harmless and short
    std::string said;  ///< the program's stdout and stderr, made harmless and short
    std::vector<Similar> similar;
    // Not part of the marks: differs from run to run.
    double compileSeconds = 0, framesSeconds = 0, judgeSeconds = 0;
};

/// report.json: UTF-8 whatever the strings hold (invalid bytes become U+FFFD); the same report gives the same bytes, but for
/// "seconds". slides_refs is not needed to read it. Its schema stands in tests/grader/report.schema.json.
std::string toJson(const Report& report);
/// Reads report.json. Throws std::runtime_error that names the field, what was expected and found.
Report reportFromJson(const std::string& json);

}  // namespace grader
