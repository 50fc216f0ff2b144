// Frames held against the expected ones, and what a report shows of that.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/judge/expected.hpp"

#include <string>
#include <vector>

namespace grader {

/// A picture that goes beside the report.
struct Picture {
    ReportImage image;
    std::vector<float> pixels;  ///< linear; empty: `codes` has them
    std::vector<std::uint8_t> codes;
};

/// When there are pictures.
enum class Show {
    wrong,  ///< of frames that are wrong, and if one came back
    always  ///< also of right ones, and the expected one alone where none came back
};

/// All frames of one part of a submission against the expected ones. The expected frames must outlive it.
class Evidence {
  public:
    /// `found`: in the order of `expected`; a frame that did not come back is empty.
    Evidence(const std::vector<ExpectedFrame>& expected, const std::vector<std::vector<float>>& found);

    /// Whether every frame is there and as expected.
    bool right() const { return right_; }
    bool right(std::size_t frame) const { return there(frame) && verdicts_[frame].right(); }
    bool there(std::size_t frame) const { return !(*found_)[frame].empty(); }
    /// The frame with the smallest share of right pixels among those that are there; none: SIZE_MAX.
    std::size_t worstFrame() const { return worst_; }

    std::vector<RegionShare> regions() const;
    /// Of the worst frame; none if no frame is there or nothing is wrong.
    std::optional<WorstPixel> worstPixel() const;
    /// Yours, expected and difference of the worst frame, their ids beginning with `prefix`.
    std::vector<Picture> pictures(const std::string& prefix, Language language, Show show) const;

  private:
    const std::vector<ExpectedFrame>* expected_;
    const std::vector<std::vector<float>>* found_;
    std::vector<FrameVerdict> verdicts_;
    bool right_ = true;
    std::size_t worst_;
};

/// "4 codes or more: #3b0f70 ..." in words: the legend of difference pictures.
std::string differenceLegend(Language language);

/// What part of the points is left where this share of the pixels is right: none at 60 %, all at 99.5 %, between them in proportion.
double creditFor(double share);

}  // namespace grader
