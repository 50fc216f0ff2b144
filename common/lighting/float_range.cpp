// Bounds of distances and strengths, from boxes and spheres.
// SPDX-License-Identifier: MIT
#include "lighting/float_range.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace lighting {

namespace {

constexpr double nearestInside =
    -14;  // log2 of the distance that a light inside a mesh's box is taken to have
constexpr double largestFactor = 1e30;  // what one share can reach in the plain formula
constexpr double largestSum = 1e37;

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

// The distances that a light can have from the points of a mesh, as powers of two.
struct Distances {
    double nearest, farthest;
    bool inside;  // the light is in the box: nearest is a guess
};

// Where a mesh is, frame space: formed once for all lights.
class Bounds {
  public:
    Bounds(const Draw& draw, const THREE::Box3& box, const THREE::Sphere& sphere)
        : linear_(draw.model), place_(draw.model[3]), origin_(draw.origin), box_(box),
          center_(draw.model * glm::dvec4(glm::dvec3(sphere.center) - draw.origin, 1)) {
        const double stretch = std::sqrt(glm::dot(linear_[0], linear_[0]) + glm::dot(linear_[1], linear_[1]) +
                                         glm::dot(linear_[2], linear_[2]));
        radius_ = sphere.radius * stretch;
        const double determinant = glm::determinant(linear_);
        turnsRound_ = determinant != 0 && std::isfinite(1 / determinant);
        if (turnsRound_)
            inverse_ = glm::inverse(linear_);
    }

    Distances to(const glm::dvec3& light) const {
        const double between = glm::length(light - center_);
        const double farthest = std::log2(std::max(between + radius_, 1e-300));
        if (between > 1.5 * radius_)
            return {std::log2(between - radius_), farthest, false};
        // Near the mesh the sphere says nothing: the box in object space does, if that is not too flat to be turned round.
        double nearest = 0;
        if (turnsRound_) {
            const glm::dvec3 local = inverse_ * (light - place_) + origin_;
            const glm::dvec3 inBox = glm::clamp(local, glm::dvec3(box_.min), glm::dvec3(box_.max));
            nearest = glm::length(linear_ * (local - inBox));
        }
        return nearest > 0 ? Distances{std::log2(nearest), farthest, false}
                           : Distances{nearestInside, farthest, true};
    }

  private:
    glm::dmat3 linear_, inverse_{1.0};
    glm::dvec3 place_, origin_;
    THREE::Box3 box_;
    glm::dvec3 center_;
    double radius_ = 0;
    bool turnsRound_ = false;
};

// Whether d^(k + 1) and d^2 of distances from 2^nearest to 2^farthest are numbers that floats hold well.
bool divisorsFit(const Distances& d, double k) {
    const double power = std::max(k + 1, 2.0);
    return power * d.nearest >= -99 && power * d.farthest <= 120 && 2 * d.farthest <= 120;
}

}  // namespace

double powerOfTwoBelow(double x) { return std::ldexp(1.0, std::ilogb(x)); }

bool needsScaling(const FramePlan& plan, const Draw& draw, const THREE::Box3& box,
                  const THREE::Sphere& sphere) {
    double strongest = largest(plan.ambient);
    for (const DirectionalAddend& light : plan.directional)
        strongest += std::max(largest(light.color), light.intensity);
    const Bounds bounds(draw, box, sphere);
    for (const PointAddend& light : plan.point) {
        const Distances d = bounds.to(light.position);
        if (light.exponent != 0 || !divisorsFit(d, light.decay))
            return true;
        const double factor = light.decay == 0 ? 1
                              : d.inside       ? largestFactor
                                               : std::min(std::exp2(-light.decay * d.nearest), largestFactor);
        strongest += std::max(largest(light.color), light.intensity) * factor;
    }
    const double fresnel =
        draw.variant.blinn ? std::max(largest(draw.specular), 1.0) : largest(draw.specular);
    const double highlight = fresnel * std::max(1.0, (draw.shininess + 2) / 8);
    return !((std::max(largest(draw.albedo), 1.0) + highlight) * strongest + largest(draw.emitted) <=
             largestSum);
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
