// The OpenGL ES 3.0 renderer.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/gpu_clusters.hpp"
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
    /// Compile::aside is for windows: no frame waits for a program that another one can stand in for.
    explicit GlRenderer(std::string shaderDirectory, Compile when = Compile::atOnce);
    ~GlRenderer() override;
    GlRenderer(const GlRenderer&) = delete;
    GlRenderer& operator=(const GlRenderer&) = delete;

    image::Frame render(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                        const lighting::Settings& settings, const FrameRequest& request) override;
    /// Draws into a target of the renderer's own without reading it back; waits until it is done.
    void renderOnly(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                    const lighting::Settings& settings, const FrameRequest& request) override;
    FrameStats stats() const override { return stats_; }
    std::string name() const override;

    /// Waits until every program that is being compiled aside is ready.
    void finishCompiling() { programs_.finish(); }

    /// Draws a plan instead of a scene; tests change plans by hand.
    image::Frame render(const lighting::FramePlan& plan, const lighting::Settings& settings,
                        const FrameRequest& request);
    /// Draws into the window whose context is current.
    void drawToWindow(const lighting::FramePlan& plan, const lighting::Settings& settings, int width,
                      int height);
    /// Copies a frame of another renderer into the window whose context is current.
    void showInWindow(const image::Frame& frame);

  private:
    void draw(const lighting::FramePlan& plan, const lighting::Settings& settings, int width, int height);
    RenderTarget& target(const FrameRequest& request, bool countNonfinite);
    void drawMesh(const lighting::Draw& draw, const glm::dvec3& eyePosition,
                  const lighting::Settings& settings);
    const Program& useProgram(const lighting::Draw& draw, bool reuse);

    Programs programs_;
    GpuGeometries geometries_;
    GpuLights lights_;
    GpuClusters clusters_;
    // What the last draw of this frame used: most draws want the same.
    struct InUse {
        lighting::Variant variant;  // as the plan has it
        std::size_t lights = 0;
        const Program* program = nullptr;
    } inUse_;
    std::unique_ptr<RenderTarget> target_;
    GLuint shown_ = 0;  // texture of showInWindow
    FrameStats stats_;
};

}  // namespace render
