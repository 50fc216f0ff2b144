// From the world to the picture and back: what is drawn over it, and what the mouse points at.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/panel.hpp"
#include "three/scene.hpp"

#include <optional>

namespace lab {

/// A camera as it is at the moment, its world matrix up to date.
class Projection {
  public:
    explicit Projection(const THREE::PerspectiveCamera& camera);

    /// World space to view space: the camera looks along -z.
    glm::dvec3 view(const glm::dvec3& world) const;
    glm::dvec3 world(const glm::dvec3& view) const;
    /// Where a point is seen, also beside the picture; none in front of the near plane, behind the eye, or
    /// more than 1e6 pictures away.
    std::optional<PanelPoint> point(const glm::dvec3& world) const;
    /// Through a place of the picture: the point of view space at depth 1, z = -1.
    glm::dvec3 ray(const PanelPoint& at) const;
    /// The part of a straight line between two points of the world that is behind the near plane and within a
    /// picture's width and height of the picture; none if there is none. Without its end an arrow loses its
    /// head. Always finite.
    std::optional<PanelStroke> stroke(const glm::dvec3& from, const glm::dvec3& to, Ink ink,
                                      bool arrow = false, double width = 2) const;
    /// World units of the camera that a share of the picture's height spans at the depth of a point; 0 behind
    /// the near plane.
    double lengthAt(const glm::dvec3& world, double share) const;
    /// The eye, world space.
    glm::dvec3 eye() const { return world(glm::dvec3(0)); }

  private:
    glm::dmat4 toWorld_, toView_;
    double halfWidth_, halfHeight_;  // of the picture at depth 1
    double near_;
};

/// Whether a place is within the picture.
bool inPicture(const PanelPoint& at);

}  // namespace lab
