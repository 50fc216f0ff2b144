// What others make of the same numbers: deliberately other equations than the lab's, in strict IEEE float. For the report.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/setup.hpp"

#include <glm/mat4x4.hpp>

namespace stability {

/// The plane's middle in GLSL as one writes it first: normalize() wherever a unit vector is wanted, pow for f(d).
glm::vec3 naiveGlsl(const Setup& setup);
/// three.js r146: normal and light direction by normalize(); its attenuation only where a light has a `distance`.
glm::vec3 threeLegacy(const Setup& setup);
/// The same with physicallyCorrectLights: 1 / max(d^decay, 0.01) times its window.
glm::vec3 threePhysical(const Setup& setup);

/// A normal by transpose(inverse(mat3(model))) in the shader, and by three.js's normal matrix, which is formed in double.
glm::vec3 naiveNormal(const glm::dmat4& model, const glm::dvec3& normal);
glm::vec3 threeNormal(const glm::dmat4& model, const glm::dvec3& normal);

/// normalize(cross(b - a, c - a)) in float.
glm::vec3 naiveTriangleNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The length of an axis that a float matrix was multiplied into `turns` times, by `step` radians about z each.
double naiveSpunLength(int turns, double step);

/// The nearest half-precision number, ties to even; beyond 65504 infinite. `truncated` towards zero, as some drivers store.
float half(float x);
float halfTruncated(float x);

/// A light straight above at distance d, k = 2, in a fragment shader that is mediump throughout: half precision on phones.
float mediump(double d, double L);

}  // namespace stability
