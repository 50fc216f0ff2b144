// The OpenGL ES 3.0 renderer.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/gpu_clusters.hpp"
#include "render/gpu_geometry.hpp"
#include "render/gpu_lights.hpp"
#include "render/program.hpp"
#include "render/render_target.hpp"
#include "render/renderer.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace render {

/// Draws with the context that is current when it is made and whenever it is used.
class GlRenderer final : public Renderer {
  public:
    /// Compile::aside is for windows: no frame waits for a program that another one can stand in for.
    explicit GlRenderer(std::string shaderDirectory, Compile when = Compile::atOnce);
    ~GlRenderer() override = default;
    GlRenderer(const GlRenderer&) = delete;
    GlRenderer& operator=(const GlRenderer&) = delete;

    image::Frame render(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                        const lighting::Settings& settings, const FrameRequest& request) override;
    /// Draws into a target of the renderer's own without reading it back; waits until it is done.
    void renderOnly(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                    const lighting::Settings& settings, const FrameRequest& request) override;
    FrameStats stats() const override { return stats_; }
    std::string name() const override;

    /// Waits until the driver has drawn what it was told to.
    void finishDrawing() const { glFinish(); }
    /// Waits until every program that is being compiled aside is ready.
    void finishCompiling() { programs_.finish(); }

    /// Draws a plan instead of a scene; tests change plans by hand.
    image::Frame render(const lighting::FramePlan& plan, const lighting::Settings& settings,
                        const FrameRequest& request);
    /// Draws one part or two into one frame: the bytes of each plan's own frame in its columns; others are not defined. Nonfinite
    /// pixels are counted if the first part's settings say so. Throws std::invalid_argument for another number of parts.
    image::Frame render(std::span<const Part> parts, const FrameRequest& request);

    // The window's picture: it is drawn when something has changed, into a target of its own, and shown as often as the panel over it.

    /// Draws the picture and returns true; or returns false and leaves it as it was, because a program is missing and is being compiled
    /// aside now: try again when onCompiled calls. A first picture, or one of another size, is drawn at once, whatever has to be compiled.
    /// One part or two, which cover all columns. Throws NoRenderer, and ShaderError where a shader file does not compile, again and again
    /// until reload(); the picture before stays, unless this was to be the first or of another size.
    bool drawPicture(std::span<const Part> parts, int width, int height);
    /// Makes a frame of another renderer the picture.
    void setPicture(const image::Frame& frame);
    /// Copies the picture into the window whose context is current; does nothing where there is none.
    void showPicture();
    /// The picture, read back. Throws std::logic_error where there is none.
    image::Frame picture() const;
    /// The 8-bit code of one of its pixels; 0,0 is the top left. Throws std::logic_error where there is no picture.
    std::array<std::uint8_t, 3> pixel(int x, int y) const;
    /// Has what a plan needs compiled aside when there is nothing else to do, so that its picture is drawn at once if it is ever wanted.
    void prepare(const lighting::FramePlan& plan);
    /// Whether drawPicture() has left the picture as it was for a program that is not there yet.
    bool compiling() const { return programs_.compiling(); }
    /// Is called, on another thread, when it is there: wakes a loop that sleeps. Not while it is being set.
    void onCompiled(std::function<void()> call) { programs_.onCompiled(std::move(call)); }
    /// Takes shader files as they are now: those of the last frame at once, the others when they are wanted. If one does not compile,
    /// everything stays as it was, and `error` has its file, line, the driver's message, and the lines around it. The picture stays too,
    /// until drawPicture() is called.
    bool reload(std::string& error) { return programs_.reload(error); }

  private:
    void check(std::span<const Part> parts) const;
    void draw(std::span<const Part> parts, int width, int height);
    void drawPart(const Part& part, int width, int height);
    void count(const lighting::FramePlan& plan);
    bool ready(std::span<const Part> parts);
    void drawIntoPicture(std::span<const Part> parts, int width, int height);
    RenderTarget& pictureTarget(int width, int height);
    RenderTarget& target(const FrameRequest& request, bool countNonfinite);
    void drawMesh(const lighting::Draw& draw, const glm::dvec3& eyePosition,
                  const lighting::Settings& settings);
    const Program& useProgram(const lighting::Draw& draw, bool reuse);
    bool worthCompiling(std::size_t lights) const;

    Programs programs_;
    GpuGeometries geometries_;
    std::array<GpuLights, 2> partLights_;  // each part's, so that none seem to move from one to the other
    GpuLights* lights_ = partLights_.data();  // of the part that is being drawn
    GpuClusters clusters_;
    // What the last draw of this frame used: most draws want the same.
    struct InUse {
        lighting::Variant variant;  // as the plan has it
        std::size_t lights = 0;
        const Program* program = nullptr;
    } inUse_;
    std::unique_ptr<RenderTarget> target_;
    std::unique_ptr<RenderTarget> picture_;
    bool pictureDrawn_ = false;
    FrameStats stats_;
};

}  // namespace render
