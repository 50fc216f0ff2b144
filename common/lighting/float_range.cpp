// Bounds of distances and strengths, from boxes and spheres.
// SPDX-License-Identifier: MIT
#include "lighting/float_range.hpp"

#include "lighting/mesh_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lighting {

namespace {

constexpr double nearestPlain = -14;  // log2 of a distance at which no exponent up to 6 is extreme
constexpr double largestFactor = 1e30;  // what one share can reach in the plain formula
constexpr double largestSum = 1e37;

double strength(const PointAddend& light) { return std::max(largest(light.color), light.intensity); }

// Whether d^(k + 1) and d^2 of distances from 2^nearest to 2^farthest are numbers that floats hold well.
bool divisorsFit(double nearest, double farthest, double k) {
    const double power = std::max(k + 1, 2.0);
    return power * nearest >= -99 && power * farthest <= 120 && 2 * farthest <= 120;
}

// Whether a draw's sum fits when so much light arrives.
bool sumFits(const Draw& draw, double light) {
    const double fresnel =
        draw.variant.blinn ? std::max(largest(draw.specular), 1.0) : largest(draw.specular);
    const double highlight = fresnel * std::max(1.0, (draw.shininess + 2) / 8);
    return (std::max(largest(draw.albedo), 1.0) + highlight) * light + largest(draw.emitted) <= largestSum;
}

}  // namespace

double powerOfTwoBelow(double x) { return std::ldexp(1.0, std::ilogb(x)); }

FloatRange::FloatRange(const FramePlan& plan) : plan_(plan), everywhere_(largest(plan.ambient)) {
    for (const DirectionalAddend& light : plan.directional)
        everywhere_ += light.dark ? 0 : std::max(largest(light.color), light.intensity);
    worst_ = everywhere_;
    for (const PointAddend& light : plan.point) {
        if (light.dark)
            continue;
        low_ = byX_.empty() ? light.position : glm::min(low_, light.position);
        high_ = byX_.empty() ? light.position : glm::max(high_, light.position);
        byX_.push_back(&light);
        worst_ += strength(light) * (light.decay == 0 ? 1 : largestFactor);
        steepest_ = std::max(steepest_, light.decay);
        extreme_ |= light.exponent != 0;
    }
    std::sort(byX_.begin(), byX_.end(),
              [](const PointAddend* a, const PointAddend* b) { return a->position.x < b->position.x; });
}

// A quick answer, which nearly every mesh gets: the lights lie in a box, and the few that are about the mesh's own are
// looked at one by one.
bool FloatRange::clearlyStays(const Draw& draw, const MeshBounds& bounds) const {
    const glm::dvec3 away = glm::max(glm::abs(low_ - bounds.center()), glm::abs(high_ - bounds.center()));
    const double farthest = std::log2(std::max(glm::length(away) + bounds.radius(), 1e-300));
    if (extreme_ || !divisorsFit(nearestPlain, farthest, steepest_) || !sumFits(draw, worst_))
        return false;
    const double margin = std::exp2(nearestPlain);
    const glm::dvec3 low = bounds.low() - margin, high = bounds.high() + margin;
    auto light = std::lower_bound(byX_.begin(), byX_.end(), low.x,
                                  [](const PointAddend* l, double x) { return l->position.x < x; });
    for (; light != byX_.end() && (*light)->position.x <= high.x; ++light) {
        const glm::dvec3& at = (*light)->position;
        if (at.y < low.y || at.y > high.y || at.z < low.z || at.z > high.z)
            continue;
        const MeshBounds::Distances d = bounds.to(at);
        if (!d.inside && d.nearest < nearestPlain)
            return false;
    }
    return true;
}

bool FloatRange::leftBy(const Draw& draw) const {
    if (byX_.empty())
        return !sumFits(draw, everywhere_);
    const MeshBounds bounds(draw);
    if (clearlyStays(draw, bounds))
        return false;
    double sum = everywhere_;
    for (const PointAddend& light : plan_.point) {
        if (light.dark)
            continue;
        const MeshBounds::Distances d = bounds.to(light.position);
        if (light.exponent != 0 || !divisorsFit(d.nearest, d.farthest, light.decay))
            return true;
        const double factor = light.decay == 0 ? 1
                              : d.inside       ? largestFactor
                                               : std::min(std::exp2(-light.decay * d.nearest), largestFactor);
        sum += strength(light) * factor;
    }
    return !sumFits(draw, sum);
}

void fitToFloats(PointAddend& light, double unit, bool attenuated) {
    light.position /= unit;
    light.distance /= unit;
    double shift = -std::log2(unit);  // of log2 d, from world units to what the shader sees
    const double farthest =
        std::max({std::abs(light.position.x), std::abs(light.position.y), std::abs(light.position.z)});
    if (farthest > 0x1p120) {
        const double nearer = 0x1p120 / powerOfTwoBelow(farthest);
        light.position *= nearer;
        light.distance *= nearer;
        shift += std::log2(nearer);
    }
    const double strongest = std::max(largest(light.color), light.intensity);
    if (!attenuated || light.decay == 0 || shift == 0 || strongest == 0)
        return;
    // L d^-k = (L 2^(k shift)) (d 2^shift)^-k
    const double exponent = light.decay * shift;
    const double whole = std::floor(exponent);
    light.color *= std::exp2(exponent - whole);
    light.intensity *= std::exp2(exponent - whole);
    if (std::abs(whole + std::log2(strongest)) < 100) {
        light.color *= std::exp2(whole);
        light.intensity *= std::exp2(whole);
    } else {
        light.exponent = std::clamp(whole, -1e30, 1e30);
    }
}

}  // namespace lighting
