// The part of a submission that is a lesson's program: its steps judged by what it draws.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/catalogue/texts.hpp"
#include "grader/judge/evidence.hpp"
#include "grader/judge/explain.hpp"
#include "grader/judge/rubric.hpp"
#include "grader/judge/scene_difference.hpp"
#include "grader/judge/views.hpp"
#include "grader/report/text.hpp"

#include <functional>
#include <memory>

namespace grader {

/// What judging gives: the rubric's checks of one part, and the pictures that they show.
struct PartVerdict {
    std::vector<Check> checks;
    std::vector<Picture> pictures;
};

/// Adds to each check that did not pass what shows why: regions, worst pixel, the verdict's pictures, a hint.
void show(const Evidence& evidence, const std::optional<WorstPixel>& worst, Language language,
          PartVerdict& verdict);

/// Judges lesson programs. Frames decide: where they are right, all is right. Where they are wrong, the scene that the program
/// says it has is drawn by the reference; if that gives the student's frames, what differs in the scene is what is wrong.
/// Made once for any number of submissions.
class Steps {
  public:
    /// `scenes`: the lesson's own, one for each view.
    Steps(const Rubric& rubric, const Texts& texts, Language language, std::vector<View> views,
          const std::vector<std::shared_ptr<const THREE::LoadedScene>>& scenes, Show show = Show::wrong);

    const std::vector<View>& views() const { return views_; }
    const std::vector<ExpectedFrame>& expected() const { return expected_; }
    /// Whether wrong frames are held against the catalogue, which names mistakes and changes no marks.
    bool explains = true;
    /// Fits the catalogue to the expected frames now, which takes a while, instead of on first need: before processes are forked.
    void prepare() const;

    /// The scene of the student's program at a view, as the program itself describes it; null if it cannot be had.
    using SceneAt = std::function<std::shared_ptr<const THREE::LoadedScene>(std::size_t view)>;
    /// `found`: a frame for each view, empty where none came back, and then `problems` says why.
    PartVerdict judge(const std::vector<std::vector<float>>& found, const std::vector<std::string>& problems,
                      const SceneAt& sceneAt) const;

  private:
    /// What differs in the student's scenes, which give the student's frames.
    struct Differences {
        Aspects aspects;
        std::vector<std::shared_ptr<const THREE::LoadedScene>>
            scenes;  // one for each view; null where no frame came back
    };
    std::optional<Differences> differences(const std::vector<std::vector<float>>& found,
                                           const SceneAt& sceneAt) const;
    std::vector<std::string> restOf(const Aspects& all) const;
    void judgeByScene(const StepCheck& step, const Aspects& aspects, Check& check) const;
    std::optional<Explanation> explanation(const std::vector<std::vector<float>>& found) const;
    Check start(const StepCheck& step) const;
    std::optional<WorstPixel> worstPixel(const Evidence& evidence,
                                         const std::optional<Differences>& known) const;
    std::string missingFor(const StepCheck& step, const Evidence& evidence,
                           const std::vector<std::string>& problems) const;

    const Rubric& rubric_;
    const Texts& texts_;
    Language language_;
    Show show_;
    std::vector<View> views_;
    std::vector<ExpectedFrame> expected_;
    mutable std::unique_ptr<Explainer> explainer_;
};

/// An explanation in words, from ids of the catalogue. Its scores are the caller's.
Explanation explanationOf(const std::vector<std::string>& ids, const Texts& texts, Language language);

}  // namespace grader
