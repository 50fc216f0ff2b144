// The shaders' own text, run on the CPU in strict IEEE float: what a driver may hide, such as NaN, shows here.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace support {

/// What shaders/mesh.vert makes of a vertex.
struct StrictVertex {
    glm::vec4 clip;  ///< clip space
    glm::vec3 worldPosition;  ///< frame space
    glm::vec3 worldNormal;  ///< frame space, unit length
};

/// What shaders/gouraud.vert makes of a vertex: the equation is in it. Also what a rasteriser makes of several.
struct StrictGouraudVertex {
    glm::vec4 clip;  ///< clip space
    glm::vec3 frontColor, backColor;  ///< P on both sides, scaled as shaders/range.glsl does for its way
    float metNonfinite;  ///< above 0 where a vertex met NaN or infinity, before any max or clamp
};

/// What shaders/mesh.frag or gouraud.frag makes of a fragment.
struct StrictFragment {
    glm::vec3 P;  ///< the pixel's colour, not limited to [0,1]
    bool nonfinite;  ///< watch() of shaders/variant.glsl met NaN or infinity, before any max or clamp
};

/// Runs mesh.vert on a vertex in object space, which goes through the roundings that the renderer's upload does:
/// relative to draw.origin, the normal normalised in double.
StrictVertex strictVertex(const lighting::Draw& draw, const glm::dvec3& position, const glm::dvec3& normal);

/// Runs mesh.frag on a point and a normal as the rasteriser interpolated them, frame space, with all terms on. For
/// draws with a lit material only; one that the plan found to be of one colour has that. draw.variant.scaled picks the text (shaders/range.glsl); `front` matters only
/// where the draw is double-sided.
StrictFragment strictFragment(const lighting::FramePlan& plan, const lighting::Draw& draw,
                              const glm::vec3& worldPosition, const glm::vec3& worldNormal,
                              bool front = true);

/// Runs view.frag, all terms on, on the one light of a data view's plan; `place`: gl_FragCoord.
StrictFragment strictView(const lighting::FramePlan& plan, const lighting::Draw& draw,
                          const glm::vec3& worldPosition, const glm::vec3& worldNormal,
                          const glm::vec2& place = {0.5F, 0.5F});

/// What present.glsl makes of P in ViewMode::green and ViewMode::overexposed.
glm::vec3 strictGreen(const glm::vec3& P);
glm::vec3 strictOverexposed(const glm::vec3& P, const glm::vec2& place);

/// Runs gouraud.vert, as strictVertex and strictFragment do mesh.vert and mesh.frag.
StrictGouraudVertex strictGouraudVertex(const lighting::FramePlan& plan, const lighting::Draw& draw,
                                        const glm::dvec3& position, const glm::dvec3& normal);

/// Runs gouraud.frag on what lies between vertices.
StrictFragment strictGouraudFragment(const lighting::Draw& draw, const StrictGouraudVertex& between,
                                     bool front = true);

}  // namespace support
