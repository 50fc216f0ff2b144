// What is refused before a frame is drawn, by name of object and field.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/scene.hpp"

#include <stdexcept>

namespace THREE {

/// A scene that cannot be drawn; what() names the object, the field, what was expected and what was found.
class SceneError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Numbers beyond this are refused: their differences and squares must stay inside what floats can be scaled to.
inline constexpr double largestNumber = 1e36;

/// A mesh that reaches farther from the camera than this many times `near` is refused: floats cannot interpolate over it.
inline constexpr double largestReach = 1e30;

/// From `from`, world space, to the farthest point of the mesh's bounding sphere. Its matrices must be up to date.
double reach(const Mesh& mesh, const Vector3& from);

/// "PointLight 'luce2'" or "Mesh (no name, child 3 of Scene)": how messages call an object.
std::string describe(const Object3D& object);

/// Throws SceneError for the first bad number in what is visible: NaN, infinite or beyond 1e36, negative colour, intensity,
/// decay or distance, directional light without direction, zero `up`, fov outside (0,180), near >= far, an index without
/// its vertex, a geometry or material that was destroyed, a mesh beyond largestReach. Albedo above 1 is allowed. Matrices must be up to date.
void validate(const Scene& scene, const PerspectiveCamera& camera);

}  // namespace THREE
