// Grades submissions of one lesson: everything that they have in common is made once.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/builder.hpp"
#include "grader/judge/terms.hpp"
#include "grader/submission/submission.hpp"

#include <map>
#include <memory>

namespace grader {

/// What is asked.
struct GraderOptions {
    std::string lesson;  ///< "lesson_05_attenuation", a part of it, or its number
    std::filesystem::path rubric;  ///< empty: the lesson's own
    std::optional<std::uint64_t> seed;  ///< of the hidden views and scenes; none: the rubric's
    /// For students: the lesson's own camera instead of hidden ones, scenes of a seed of their own, and pictures also of what is right.
    bool publicViews = false;
    int size = 0;  ///< of the square frames, pixels; 0: the rubric's
    bool onlyGiven = false;  ///< what the rubric requires and is not there is not missed
    Language language = Language::en;
    std::optional<Walls> walls;  ///< none: the strongest that work
};

/// What a submission came to.
struct Graded {
    Report report;
    std::vector<Picture> pictures;
    std::map<std::string, std::string>
        sources;  ///< SHA-256 of each part ("lesson") without comments and blanks, where enough of it is the student's own
    std::map<std::string, std::string> files;  ///< SHA-256 of each part as it is
    std::string
        frames;  ///< SHA-256 of all frames where one is wrong and something is the student's own; else empty
};

class Grader {
  public:
    /// Throws UsageError for a lesson or rubric that is not there or wrong, std::runtime_error for what the grader itself lacks.
    explicit Grader(const GraderOptions& options);
    ~Grader();

    /// Makes what is otherwise made on first need; before processes are forked, so that all share it.
    void prepare() const;
    /// Never throws for what is in a submission.
    Graded grade(const std::filesystem::path& submission) const;

    /// SHA-256 of a submission's files, as Report::submissionHash.
    std::string hashOf(const std::filesystem::path& submission) const;

    const Rubric& rubric() const { return rubric_; }
    const std::string& lessonTitle() const { return title_; }
    Language language() const { return options_.language; }
    /// SHA-256 over all that marks depend on besides submission and rubric: programs, shaders, texts, seed, language.
    const std::string& toolHash() const { return toolHash_; }
    /// Of a part of the lab's own solution and of the starters, as Graded::sources: nobody is told apart by them.
    bool isCommon(const std::string& sourceHash) const { return common_.count(sourceHash) != 0; }
    /// How much of a part's text is in none of the lab's own: characters of its statements, without comments and blanks.
    std::size_t ownText(const std::string& part, const std::string& text) const;

  private:
    class One;  // one submission on its way
    std::vector<std::shared_ptr<const THREE::LoadedScene>> lessonScenes(const std::vector<View>& views) const;
    void readLesson();
    void noteCommon(const std::string& part, const std::string& text);
    void hashTool();
    void refuseBlindViews() const;
    void tryLesson();
    Drawing lessonDrawing() const;
    const Terms& terms() const;

    std::uint64_t seed() const;  // of hidden views and scenes

    GraderOptions options_;
    std::filesystem::path share_;  // lessons, shaders, texts
    Rubric rubric_;
    Texts texts_;
    std::string title_, toolHash_, renderer_;
    Expectations expectations_;
    std::map<std::string, std::string> shaders_;  // the lab's
    std::set<std::string> common_;
    std::map<std::string, std::set<std::string>> statements_;  // of each part of the lab's own
    std::unique_ptr<Confinement> confinement_;
    std::unique_ptr<Kit> kit_;
    std::unique_ptr<Steps> steps_;
    std::shared_ptr<const THREE::LoadedScene> lessonScene_;  // at the first view
    mutable std::unique_ptr<Terms> terms_;  // made on first need: most hand in no shaders
};

/// What is wrong with the command line or the files that it names. Exit status 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Writes report.json, pictures, the formats and `more` (names and texts) into `folder`, which is made or replaced; whole or not at all.
void writeReport(const Graded& graded, const std::filesystem::path& folder, const std::string& formats,
                 const std::map<std::string, std::string>& more = {});

}  // namespace grader
