// The pinhole camera in doubles.
// SPDX-License-Identifier: MIT
#include "lab/live/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

constexpr double farthestPlace = 1e6;

// What is left of the way from 0 to 1 where start + t step >= least.
void keep(double start, double step, double least, double& first, double& last) {
    if (step == 0) {
        if (!(start >= least))
            last = -1;
        return;
    }
    const double t = (least - start) / step;
    if (step > 0)
        first = std::max(first, t);
    else
        last = std::min(last, t);
}

}  // namespace

Projection::Projection(const THREE::PerspectiveCamera& camera)
    : toWorld_(camera.matrixWorld), toView_(camera.matrixWorldInverse()),
      halfHeight_(std::tan(camera.fov * std::numbers::pi / 360) / camera.zoom), near_(camera.near) {
    halfWidth_ = halfHeight_ * camera.aspect;
}

glm::dvec3 Projection::view(const glm::dvec3& world) const { return toView_ * glm::dvec4(world, 1); }
glm::dvec3 Projection::world(const glm::dvec3& view) const { return toWorld_ * glm::dvec4(view, 1); }

std::optional<PanelPoint> Projection::point(const glm::dvec3& world) const {
    const glm::dvec3 v = view(world);
    const double depth = -v.z;
    if (!(depth >= near_))
        return std::nullopt;
    const PanelPoint at{0.5 + 0.5 * v.x / (depth * halfWidth_), 0.5 - 0.5 * v.y / (depth * halfHeight_)};
    if (!(std::abs(at.x) < farthestPlace) || !(std::abs(at.y) < farthestPlace))
        return std::nullopt;
    return at;
}

glm::dvec3 Projection::ray(const PanelPoint& at) const {
    return {(2 * at.x - 1) * halfWidth_, (1 - 2 * at.y) * halfHeight_, -1};
}

std::optional<PanelStroke> Projection::stroke(const glm::dvec3& from, const glm::dvec3& to, Ink ink,
                                              bool arrow, double width) const {
    const glm::dvec3 a = view(from), step = view(to) - a;
    double first = 0, last = 1;
    // Planes of view space: the near plane, and four through the eye, three times as far apart as the
    // picture's edges.
    keep(-a.z, -step.z, near_, first, last);
    const std::array<double, 2> half{halfWidth_, halfHeight_};
    for (int axis = 0; axis < 2; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const double reach = 3 * half[static_cast<std::size_t>(axis)];
            keep(-a.z * reach - side * a[axis], -step.z * reach - side * step[axis], 0, first, last);
        }
    if (!(first <= last))
        return std::nullopt;
    const auto place = [&](double t) {
        const glm::dvec3 v = a + step * t;
        const double depth = std::max(-v.z, near_);  // rounding
        return PanelPoint{std::clamp(0.5 + 0.5 * v.x / (depth * halfWidth_), -1.0, 2.0),
                          std::clamp(0.5 - 0.5 * v.y / (depth * halfHeight_), -1.0, 2.0)};
    };
    const PanelStroke stroke{place(first), place(last), ink, arrow && last == 1, width};
    const bool finite = std::isfinite(stroke.from.x + stroke.from.y + stroke.to.x + stroke.to.y);
    return finite ? std::optional(stroke) : std::nullopt;
}

double Projection::lengthAt(const glm::dvec3& world, double share) const {
    const double depth = -view(world).z;
    return depth >= near_ ? 2 * share * halfHeight_ * depth : 0;
}

bool inPicture(const PanelPoint& at) { return at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1; }

}  // namespace lab
