// Screen: the picture in the window, by the graphics driver at once and by the reference as soon as it is ready; nothing waits.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/reference_aside.hpp"
#include "lab/live/session.hpp"
#include "lab/window.hpp"
#include "render/gl_renderer.hpp"
#include "render/reference_renderer.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lab {

class Screen {
  public:
    /// Throws NoRenderer, ShaderError.
    Screen(const Options& options, Window& window);

    /// The window's size in pixels; false while it has none.
    bool size(int& width, int& height) const;
    bool sizeChanged() const;
    /// Draws into the window, anew where `changed`; false while it has no size. Where something new is not ready yet, the picture
    /// before stays. Throws THREE::SceneError.
    bool draw(Session& session, View* before, bool changed);
    /// Whether something has become ready since the last draw, so that another one is worth it.
    bool hasNews();
    /// Gets ready for what the user may do next; costs nothing where it is done already.
    void prepare(Session& session);
    /// What is wrong with the shaders, if something is: the picture is the last good one.
    const std::optional<std::string>& problem() const { return problem_; }

    /// Takes a changed shader file; none if the file is no shader's, else what is wrong, or an empty text.
    std::optional<std::string> reload(const std::string& file);
    std::vector<std::string> shaderFolders() const;

    void write(Session& session, View* before, const std::string& file, int width, int height);
    std::string lightCost(Session& session);
    /// What stands in a pixel of the picture, 0,0 is its top left.
    std::array<std::uint8_t, 3> pixel(int x, int y) { return gl_.pixel(x, y); }
    render::FrameStats stats() const;
    /// What the colours mean where the picture is a difference; else none.
    std::optional<PanelLegend> legend(const Session& session) const;

  private:
    void drawGl(std::span<const Side> sides, int width, int height);
    void askReference(std::span<const Side> sides, int width, int height);
    void takeReference(const Session& session);

    const Options& options_;
    Window& window_;
    render::GlRenderer gl_;
    render::ReferenceRenderer reference_;
    ReferenceAside aside_;
};

}  // namespace lab
