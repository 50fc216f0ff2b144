// Boxes and spheres out of object space.
// SPDX-License-Identifier: MIT
#include "lighting/mesh_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace lighting {

namespace {

constexpr double nearestInside = -14;

glm::dmat3 absolute(const glm::dmat3& m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])}; }

}  // namespace

MeshBounds::MeshBounds(const Draw& draw)
    : linear_(draw.model), place_(draw.model[3]), origin_(draw.origin),
      box_(draw.mesh->geometry->boundingBox()) {
    const THREE::Sphere& sphere = draw.mesh->geometry->boundingSphere();
    center_ = draw.model * glm::dvec4(glm::dvec3(sphere.center) - draw.origin, 1);
    radius_ = sphere.radius * std::sqrt(glm::dot(linear_[0], linear_[0]) + glm::dot(linear_[1], linear_[1]) +
                                        glm::dot(linear_[2], linear_[2]));
    const glm::dvec3 middle = (glm::dvec3(box_.min) + glm::dvec3(box_.max)) * 0.5;
    const glm::dvec3 half = absolute(linear_) * (glm::dvec3(box_.max) - middle);
    const glm::dvec3 place = draw.model * glm::dvec4(middle - draw.origin, 1);
    low_ = place - half;
    high_ = place + half;
    const double determinant = glm::determinant(linear_);
    turnsRound_ = determinant != 0 && std::isfinite(1 / determinant);
    if (turnsRound_)
        inverse_ = glm::inverse(linear_);
}

MeshBounds::Distances MeshBounds::to(const glm::dvec3& point) const {
    const double between = glm::length(point - center_);
    const double farthest = std::log2(std::max(between + radius_, 1e-300));
    if (between > 1.5 * radius_)
        return {std::log2(between - radius_), farthest, false};
    // Near the mesh the sphere says nothing: the box in object space does, if that is not too flat to be turned round.
    double nearest = 0;
    if (turnsRound_) {
        const glm::dvec3 local = inverse_ * (point - place_) + origin_;
        const glm::dvec3 inBox = glm::clamp(local, glm::dvec3(box_.min), glm::dvec3(box_.max));
        nearest = glm::length(linear_ * (local - inBox));
    }
    return nearest > 0 ? Distances{std::log2(nearest), farthest, false}
                       : Distances{nearestInside, farthest, true};
}

double MeshBounds::leastDistance(const glm::dvec3& point) const {
    const double toBox = glm::length(point - glm::clamp(point, low_, high_));
    return std::max(toBox, glm::length(point - center_) - radius_);
}

}  // namespace lighting
