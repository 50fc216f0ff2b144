// The lights of a sum as numbers for a shader.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace render {

/// Directional lights first, then point lights; shaders/lights.glsl reads them so.
struct LightNumbers {
    std::vector<glm::vec4> geometry;  ///< (w, -) or (P_L, 1 / distance), lighting space
    std::vector<glm::vec4> radiance;  ///< (L, intensity alone)
    std::vector<glm::vec4> falloff;  ///< (k, exponent, -, -)
    std::vector<const THREE::Light*> lights;  ///< whose numbers they are; to be compared, it may be gone
    std::vector<bool> moves;  ///< whether it changed lately, so that it is no constant
    glm::vec3 ambient{-1};  ///< L_A; negative: not known yet
    bool ambientMoves = false;  ///< as moves

    std::size_t count() const { return geometry.size(); }
};

/// All lights of a plan in its order; none moves. What is beyond the largest float becomes the largest float.
LightNumbers numbersOf(const lighting::FramePlan& plan);

/// Those of one of the plan's sets, picked from all.
LightNumbers pick(const LightNumbers& all, const lighting::FramePlan& plan, const lighting::LightSet& set);

}  // namespace render
