// The part of a submission that is shader text: the equation's terms judged by what they draw on scenes that no student has seen.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/judge/steps.hpp"

#include <map>
#include <set>

namespace grader {

/// Judges shaders. Frames decide: where they are right, all is right. Where they are wrong, the catalogue and terms that are still
/// neutral are held against them; what explains them costs its term. Where nothing explains them, each term is looked
/// at with the others switched off. Made once for any number of submissions.
class Terms {
  public:
    /// `seed`: of the hidden scenes; `lesson`: the lesson's own scene at a hidden view, drawn last.
    Terms(const Rubric& rubric, const Texts& texts, Language language, std::uint64_t seed,
          std::shared_ptr<const THREE::LoadedScene> lesson, Show show = Show::wrong);

    /// The scenes to draw, each with its camera.
    const std::vector<std::shared_ptr<const THREE::LoadedScene>>& scenes() const { return scenes_; }
    void prepare() const;  ///< as Steps::prepare

    /// Draws a scene in several states, each a list for --terms; a frame that did not come back is empty.
    using DrawStates = std::function<std::vector<std::vector<float>>(std::size_t scene,
                                                                     const std::vector<std::string>& states)>;
    /// `found`: a frame for each scene, as Steps::judge. `untouched`: the terms whose files are still the starter's.
    PartVerdict judge(const std::vector<std::vector<float>>& found, const std::vector<std::string>& problems,
                      const std::set<std::string>& untouched, const DrawStates& drawStates) const;

  private:
    struct Blame {  // what costs checks their marks
        std::vector<std::string> checks;
        double credit = 0;
        std::string message;
        std::optional<Explanation> explanation;
    };
    std::vector<Blame> blames(const std::vector<std::vector<float>>& found,
                              const std::set<std::string>& untouched) const;
    Blame blame(std::vector<std::string> ids, const Explainer::Fit& fit,
                const std::set<std::string>& untouched) const;
    void judgeByStates(std::vector<Check>& checks, const DrawStates& drawStates) const;
    std::map<std::string, double> sharesOfStates(const DrawStates& drawStates) const;
    void judgeMissing(std::vector<Check>& checks, const std::vector<std::vector<float>>& found,
                      const std::vector<std::string>& problems) const;
    void judgeByBlame(std::vector<Check>& checks, const std::vector<Blame>& why) const;
    Check start(const TermCheck& term) const;

    const Rubric& rubric_;
    const Texts& texts_;
    Language language_;
    Show show_;
    std::vector<std::shared_ptr<const THREE::LoadedScene>> scenes_;
    std::vector<ExpectedFrame> expected_;
    // Matte scenes are explained by themselves, before shiny ones: a mistake in the sum looks the same there whatever it does to highlights.
    struct Group {
        std::vector<std::size_t> frames;
        std::unique_ptr<Explainer> explainer;
    };
    mutable std::vector<Group> groups_;
};

}  // namespace grader
