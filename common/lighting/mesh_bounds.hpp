// Where a mesh of a draw is, so that lights can be asked how near they come to it.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

namespace lighting {

/// Box and sphere around a draw's mesh, lighting space. Formed once for all lights.
class MeshBounds {
  public:
    explicit MeshBounds(const Draw& draw);

    /// The distances that a point can have from the mesh, as powers of two.
    struct Distances {
        double nearest;  ///< log2; -14 by convention where the point is inside the mesh's own box
        double farthest;  ///< log2
        bool inside;  ///< nearest is that convention
    };
    Distances to(const glm::dvec3& point) const;

    /// No point of the mesh is nearer to `point` than this.
    double leastDistance(const glm::dvec3& point) const;

    const glm::dvec3& center() const { return center_; }
    double radius() const { return radius_; }  ///< of the sphere around center()
    const glm::dvec3& low() const { return low_; }  ///< of the box along lighting space's axes
    const glm::dvec3& high() const { return high_; }

  private:
    glm::dmat3 linear_, inverse_{1.0};
    glm::dvec3 place_, origin_;
    THREE::Box3 box_;  // object space
    glm::dvec3 center_, low_, high_;
    double radius_ = 0;
    bool turnsRound_ = false;
};

}  // namespace lighting
