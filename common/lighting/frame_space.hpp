// The space that a frame is planned in: world space about an anchor near the camera, in units that floats hold well.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace lighting {

/// The point nearest to `p` on a grid that is coarser than `scale` (> 0); `p` itself where doubles are coarser.
glm::dvec3 snapToGrid(const glm::dvec3& p, double scale);

/// World units in a frame unit: 1, or, where the view is very small or very large, a power of two.
double frameUnit(const THREE::Scene& scene, const Settings& settings, const glm::dvec3& anchor);

/// Takes frame space to lighting space; `cameraPlace`: camera space to frame space.
glm::dmat4 lightingSpace(Space space, const glm::dmat4& cameraPlace);

/// Whether the matrix turns right-handed triangles into left-handed ones.
bool mirrors(const glm::dmat3& m);

/// The least distance between opposite faces of the draw's box, frame units; 0 where it is squashed flat.
double thickness(const Draw& draw);

/// Normals by the model matrix alone, as slide 33 words it, up to a positive factor.
glm::dmat3 withoutInverseTranspose(const glm::dmat3& model);

}  // namespace lighting
