// Expected frames, their regions, and how a found frame is held against one.
// SPDX-License-Identifier: MIT
#include "grader/judge/expected.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

namespace grader {

namespace {

using glm::dvec3;
using lighting::reference::Reference;
using lighting::reference::Surface;

constexpr double almostGrazing = 0.05;  // |n . w| below it is the terminator
constexpr double silhouetteSlack = 0.04;  // of its pixels may match no neighbour
constexpr int fewPixels = 3;  // of any region may be off: a corner that rasterisers round differently
constexpr double rightShare = 0.999;

Region regionOf(const Reference<double>& reference, const std::optional<Surface<double>>& surface,
                bool edge) {
    if (edge)
        return Region::silhouette;
    if (!surface || !reference.bodies()[surface->body].lit)
        return Region::background;
    double best = -1;
    const auto& equation = reference.equation();
    for (const auto& sun : equation.directionalLights)
        best = std::max(best, glm::dot(surface->n, sun.place));
    for (const auto& bulb : equation.pointLights)
        best = std::max(best, glm::dot(surface->n, lighting::reference::unit(bulb.place - surface->Q)));
    return best > almostGrazing ? Region::lit : best < -almostGrazing ? Region::unlit : Region::terminator;
}

std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4f", x + 0.0);
    return buffer;
}
std::string text(const dvec3& v) { return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")"; }

// The neighbour of a silhouette pixel that matches it, if one does.
bool matchesNearby(const ExpectedFrame& expected, const std::vector<float>& found, std::size_t pixel) {
    const int size = expected.size(), x = static_cast<int>(pixel) % size, y = static_cast<int>(pixel) / size;
    for (int j = std::max(0, y - 1); j <= std::min(size - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(size - 1, x + 1); ++i) {
            const auto other = static_cast<std::size_t>(j * size + i);
            bool same = true;
            for (std::size_t c = 0; c < 3; ++c)
                same = same &&
                       std::abs(std::clamp(static_cast<double>(expected.pixels()[other * 3 + c]), 0.0, 1.0) -
                                std::clamp(static_cast<double>(found[pixel * 3 + c]), 0.0, 1.0)) <
                           16 * tolerance;  // shading varies from pixel to pixel
            if (same)
                return true;
        }
    return false;
}

}  // namespace

const char* nameOf(Region region) {
    constexpr const char* names[] = {"lit", "unlit", "terminator", "silhouette", "background"};
    return names[static_cast<int>(region)];
}

ExpectedFrame::ExpectedFrame(std::shared_ptr<const THREE::LoadedScene> scene, int size,
                             const lighting::Switches& switches, std::string name)
    : scene_(std::move(scene)), size_(size), name_(std::move(name)),
      reference_(*scene_->scene, *scene_->camera, switches, size, size) {
    const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    pixels_.resize(count * 3);
    regions_.resize(count);
    const std::vector<std::uint8_t> edges = reference_.edges();
    const THREE::Color background = scene_->scene->background.value_or(THREE::Color(0x000000));
    reference_.surfaces([&](int x, int y, const std::optional<Surface<double>>& surface) {
        const auto pixel = static_cast<std::size_t>(y * size + x);
        const dvec3 P =
            surface ? reference_.shade(*surface) : dvec3(background.r, background.g, background.b);
        for (std::size_t c = 0; c < 3; ++c)
            pixels_[pixel * 3 + c] = static_cast<float>(P[static_cast<int>(c)]);
        regions_[pixel] = regionOf(reference_, surface, edges[pixel] != 0);
    });
}

std::vector<TermNumber> ExpectedFrame::numbersAt(int x, int y) const {
    constexpr std::size_t mostLights = 4;  // the brightest ones: more numbers explain less
    auto probe = reference_.probe(x, y);
    std::vector<TermNumber> numbers;
    if (probe.mesh == nullptr || !probe.lit)
        return numbers;
    numbers.push_back({"n", "", text(probe.n)});
    numbers.push_back({"D", "albedo", text(probe.D)});
    auto& addends = probe.addends;
    std::stable_sort(addends.begin(), addends.end(), [](const auto& a, const auto& b) {
        return glm::length(a.value) > glm::length(b.value);
    });
    for (std::size_t i = 0; i < std::min(addends.size(), mostLights); ++i) {
        const auto& one = addends[i];
        const std::string number = "_" + std::to_string(i + 1);
        numbers.push_back({"n . w" + number, "cosine", text(one.cosine)});
        numbers.push_back({"max(0, n . w" + number + ")", "clamp", text(one.clamped)});
        if (one.d > 0) {
            numbers.push_back({"d" + number, "point", text(one.d)});
            numbers.push_back({"f(d" + number + ")", "attenuation", text(one.f)});
        }
        numbers.push_back({"L" + number, "light_color", text(one.L)});
        if (one.specular != dvec3(0))
            numbers.push_back({"K_S max(0, R . v)^s" + number, "specular", text(one.specular)});
        numbers.push_back({"addend" + number, "", text(one.value)});
    }
    numbers.push_back({"D (x) L_A", "ambient", text(probe.ambient)});
    numbers.push_back({"P", "", text(probe.P)});
    return numbers;
}

double apartAt(const std::vector<float>& a, const std::vector<float>& b, std::size_t pixel) {
    double worst = 0;
    for (std::size_t i = pixel * 3; i < pixel * 3 + 3; ++i) {
        const double difference = std::abs(std::clamp(static_cast<double>(a[i]), 0.0, 1.0) -
                                           std::clamp(static_cast<double>(b[i]), 0.0, 1.0));
        worst = std::max(worst, std::isnan(difference) ? 1.0 : difference);
    }
    return worst;
}

double FrameVerdict::share() const {
    Share all;
    for (int i = 0; i < regionCount; ++i) {
        if (i == static_cast<int>(Region::silhouette))
            continue;
        all.pixels += regions[static_cast<std::size_t>(i)].pixels;
        all.right += regions[static_cast<std::size_t>(i)].right;
    }
    return all.share();
}

bool FrameVerdict::right() const {
    for (int i = 0; i < regionCount; ++i) {
        const Share& region = regions[static_cast<std::size_t>(i)];
        const double least = i == static_cast<int>(Region::silhouette) ? 1 - silhouetteSlack : rightShare;
        if (region.pixels - region.right > fewPixels && region.share() < least)
            return false;
    }
    return true;
}

FrameVerdict compare(const ExpectedFrame& expected, const std::vector<float>& found) {
    FrameVerdict verdict;
    for (std::size_t pixel = 0; pixel < expected.regions().size(); ++pixel) {
        const Region region = expected.regions()[pixel];
        FrameVerdict::Share& share = verdict.regions[static_cast<std::size_t>(region)];
        const double by = apartAt(expected.pixels(), found, pixel);
        ++share.pixels;
        if (region == Region::silhouette) {
            share.right += by <= tolerance || matchesNearby(expected, found, pixel) ? 1 : 0;
            continue;
        }
        share.right += by <= tolerance ? 1 : 0;
        if (by > verdict.worstBy) {
            verdict.worstBy = by;
            verdict.worst = pixel;
        }
    }
    return verdict;
}

}  // namespace grader
