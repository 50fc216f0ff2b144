// Fits of the catalogue to frames: single mistakes, then one and another one on what is left.
// SPDX-License-Identifier: MIT
#include "grader/judge/explain.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace grader {

namespace {

using glm::vec3;

constexpr std::size_t every = 5;  // of the pixels is looked at
constexpr float sameWithin = 1.0F / 255;
constexpr double asGood = 0.003;  // explanations this near to the best cannot be told from it
constexpr double shareOfEach = 0.05;  // what a second one must add

bool same(const vec3& a, const vec3& b) {
    const vec3 d = glm::abs(glm::clamp(a, 0.0F, 1.0F) - glm::clamp(b, 0.0F, 1.0F));
    return d.x <= sameWithin && d.y <= sameWithin && d.z <= sameWithin;
}

// Pixels that are wrong or ought to be, and how many of them come out as predicted.
struct Count {
    std::size_t all = 0, explained = 0;
    void add(const vec3& truth, const vec3& found, const vec3& predicted) {
        if (same(truth, found) && same(truth, predicted))
            return;
        ++all;
        explained += same(found, predicted) ? 1U : 0U;
    }
    double share() const { return all == 0 ? 0 : static_cast<double>(explained) / static_cast<double>(all); }
};

double confidenceOf(double best, double second) {
    return best * (1 - second) / std::max(1e-9, (1 - second) + (1 - best));
}

}  // namespace

Explainer::Explainer(const std::vector<const ExpectedFrame*>& frames, int lesson) {
    for (const Misconception& row : misconceptions())
        if (!row.right && row.firstLesson <= lesson)
            hypotheses_.push_back({row.id, {}});
    rows_ = hypotheses_.size();
    for (const ExpectedFrame* frame : frames) {
        const WrongFrames wrong(*frame->scene().scene, *frame->scene().camera, frame->size(), frame->size(),
                                every);
        pixels_.emplace_back();
        for (const std::size_t pixel : wrong.pixels())
            if (frame->regions()[pixel] != Region::silhouette)
                pixels_.back().push_back(pixel);
        truth_.push_back(sampled(pixels_.size() - 1, frame->pixels()));
        for (Hypothesis& one : hypotheses_)
            one.frames.push_back(sampled(pixels_.size() - 1, wrong.frame(misconception(one.id))));
    }
}

void Explainer::add(const std::string& id, const std::vector<std::vector<float>>& frames) {
    Hypothesis one{id, {}};
    for (std::size_t i = 0; i < frames.size(); ++i)
        one.frames.push_back(sampled(i, frames[i]));
    hypotheses_.push_back(std::move(one));
}

std::vector<vec3> Explainer::sampled(std::size_t frame, const std::vector<float>& pixels) const {
    std::vector<vec3> result;
    if (pixels.empty())
        return result;
    result.reserve(pixels_[frame].size());
    for (const std::size_t pixel : pixels_[frame])
        result.emplace_back(pixels[pixel * 3], pixels[pixel * 3 + 1], pixels[pixel * 3 + 2]);
    return result;
}

std::vector<Explainer::Score> Explainer::singles(const std::vector<std::vector<vec3>>& found) const {
    std::vector<Score> scores;
    for (std::size_t h = 0; h < hypotheses_.size(); ++h) {
        Count count;
        for (std::size_t f = 0; f < found.size(); ++f)
            for (std::size_t i = 0; i < found[f].size(); ++i)
                count.add(truth_[f][i], found[f][i], hypotheses_[h].frames[f][i]);
        scores.push_back({h, count.share()});
    }
    std::stable_sort(scores.begin(), scores.end(),
                     [](const Score& a, const Score& b) { return a.explained > b.explained; });
    return scores;
}

Explainer::Fit Explainer::single(const std::vector<Score>& scores) const {
    Fit fit;
    if (scores.empty() || scores[0].explained < enough)
        return fit;
    fit.explained = scores[0].explained;
    fit.ids.emplace_back();
    double second = 0;
    for (const Score& score : scores) {
        if (score.explained < fit.explained - asGood) {
            second = score.explained;
            break;
        }
        fit.ids[0].push_back(hypotheses_[score.hypothesis].id);
    }
    fit.confidence = confidenceOf(fit.explained, second);
    return fit;
}

// Mistakes in different addends add up: what the first changes is taken off, and the second must explain the residue.
Explainer::Fit Explainer::pair(const std::vector<std::vector<vec3>>& found,
                               const std::vector<Score>& scores) const {
    Fit fit;
    double second = 0;
    std::vector<double> alone(hypotheses_.size(), 0);
    for (const Score& score : scores)
        alone[score.hypothesis] = score.explained;
    for (std::size_t a = 0; a < rows_; ++a)
        for (std::size_t b = a + 1; b < rows_; ++b) {
            Count count;
            const auto hopeless = [&] {
                return count.all > 200 &&
                       static_cast<double>(count.explained) < 0.5 * static_cast<double>(count.all);
            };
            for (std::size_t f = 0; f < found.size() && !hopeless(); ++f)
                for (std::size_t i = 0; i < found[f].size() && !hopeless(); ++i)
                    count.add(truth_[f][i], found[f][i],
                              hypotheses_[a].frames[f][i] + hypotheses_[b].frames[f][i] - truth_[f][i]);
            const double together = hopeless() ? 0 : count.share();
            if (together < enough || together < std::max(alone[a], alone[b]) + shareOfEach)
                continue;
            if (together > fit.explained + 1e-12) {
                second = fit.explained;
                fit.explained = together;
                fit.ids = {{hypotheses_[a].id}, {hypotheses_[b].id}};
            } else {
                second = std::max(second, together);
            }
        }
    fit.confidence = confidenceOf(fit.explained, second);
    return fit;
}

Explainer::Fit Explainer::explain(const std::vector<std::vector<float>>& found) const {
    std::vector<std::vector<vec3>> samples;
    for (std::size_t f = 0; f < found.size(); ++f)
        samples.push_back(sampled(f, found[f]));
    const std::vector<Score> scores = singles(samples);
    const Fit one = single(scores);
    return one.ids.empty() ? pair(samples, scores) : one;
}

}  // namespace grader
