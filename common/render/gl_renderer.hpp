// The OpenGL ES 3.0 renderer.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/gpu_geometry.hpp"
#include "render/gpu_lights.hpp"
#include "render/program.hpp"
#include "render/render_target.hpp"
#include "render/renderer.hpp"

#include <memory>

namespace render {

/// Draws with the context that is current when it is made and whenever it is used.
class GlRenderer final : public Renderer {
  public:
    explicit GlRenderer(std::string shaderDirectory);

    image::Frame render(const lighting::FramePlan& plan, const lighting::Settings& settings,
                        const FrameRequest& request) override;
    FrameStats stats() const override { return stats_; }
    std::string name() const override;

    /// Draws into a target of the renderer's own without reading it back, for timing; waits until it is done.
    void renderOnly(const lighting::FramePlan& plan, const lighting::Settings& settings,
                    const FrameRequest& request);
    /// Draws into the window whose context is current.
    void drawToWindow(const lighting::FramePlan& plan, const lighting::Settings& settings, int width,
                      int height);

  private:
    void draw(const lighting::FramePlan& plan, const lighting::Settings& settings, int width, int height);
    RenderTarget& target(const FrameRequest& request, bool countNonfinite);
    void drawMesh(const lighting::Draw& draw, const lighting::Settings& settings);

    Programs programs_;
    GpuGeometries geometries_;
    GpuLights lights_;
    std::unique_ptr<RenderTarget> target_;
    FrameStats stats_;
};

}  // namespace render
