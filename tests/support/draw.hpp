// Draws a scene in this process, without a window: what the frame tests look at.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"
#include "lighting/frame_plan.hpp"
#include "render/gl_renderer.hpp"
#include "three/three.hpp"

namespace support {

/// How a test wants its frame; the rest as lighting::Settings.
struct DrawOptions {
    int width = 64;
    int height = 64;
    bool floats = true;
    lighting::Settings settings;
};

/// A drawn frame, its plan and its cost.
struct Drawn {
    image::Frame frame;
    lighting::FramePlan plan;
    render::FrameStats stats;

    /// A pixel's three floats, from the top left.
    glm::vec3 at(int x, int y) const;
    const image::Floats& floats() const { return std::get<image::Floats>(frame.pixels); }
};

/// Updates matrices, validates, plans and draws with one context for the whole test program. Every frame is also
/// counted for NaN and infinity, and drawn again with its lights in uniforms and from the scene's JSON: a test fails if there
/// are any, or if one differs.
Drawn draw(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options = {});

/// The largest difference of any value of two float frames of one size.
double largestDifference(const Drawn& a, const Drawn& b);

/// The renderer, and the one context, that draw() uses.
render::GlRenderer& renderer();

/// u, the unit roundoff of float: half the distance from 1 to the next float.
inline constexpr double u = 0x1p-24;

}  // namespace support
