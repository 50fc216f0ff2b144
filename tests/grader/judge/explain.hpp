// Which misconceptions explain wrong frames, and how well.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/catalogue/misconceptions.hpp"
#include "grader/judge/expected.hpp"

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace grader {

/// What a program with one mistake would draw, at some pixels of some frames.
struct Hypothesis {
    std::string id;  ///< of the catalogue, or a name of the caller's
    std::vector<std::vector<glm::vec3>> frames;  ///< per frame, per sampled pixel
};

/// The frames that are to be explained, at some of their pixels, and all that could explain them. Made once, for any number of submissions.
class Explainer {
  public:
    /// The catalogue's rows up to a lesson, for these frames.
    Explainer(const std::vector<const ExpectedFrame*>& frames, int lesson);
    /// Adds one: the frames of another explanation, whole.
    void add(const std::string& id, const std::vector<std::vector<float>>& frames);

    /// One explanation, or two that together explain what none does alone.
    struct Fit {
        std::vector<std::vector<std::string>>
            ids;  ///< one or two mistakes; each is all that these pictures cannot tell apart, best first
        double explained = 0;  ///< share of the pixels that are wrong, or should be, which come out as found
        double confidence = 0;  ///< that, and how far the next explanation is behind
    };
    /// The best fit, or one without ids if nothing explains the frames. `found`: whole frames, in the constructor's order; one that
    /// is missing is empty.
    Fit explain(const std::vector<std::vector<float>>& found) const;

    /// What counts as explained: nearly all. Students' shaders were measured within 0.02 codes of their row, but wrong programs of
    /// other kinds come as near as 7 % of the pixels to a row that is not theirs.
    static constexpr double enough = 0.985;

  private:
    struct Score {
        std::size_t hypothesis;
        double explained;
    };
    std::vector<glm::vec3> sampled(std::size_t frame, const std::vector<float>& pixels) const;
    std::vector<Score> singles(const std::vector<std::vector<glm::vec3>>& found) const;
    Fit single(const std::vector<Score>& scores) const;
    Fit pair(const std::vector<std::vector<glm::vec3>>& found, const std::vector<Score>& scores) const;

    std::vector<std::vector<std::size_t>> pixels_;  // per frame
    std::vector<std::vector<glm::vec3>> truth_;
    std::vector<Hypothesis> hypotheses_;
    std::size_t rows_ = 0;  // how many of them are the catalogue's: only these are combined
};

}  // namespace grader
