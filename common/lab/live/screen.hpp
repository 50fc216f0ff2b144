// Screen: the picture in the window, by the graphics driver at once and by the reference as soon as it is ready. Nothing waits: where
// something new is not ready yet, the picture before stays.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/reference_aside.hpp"
#include "lab/live/session.hpp"
#include "lab/window.hpp"
#include "render/difference_view.hpp"
#include "render/gl_renderer.hpp"
#include "render/reference_renderer.hpp"

#include <array>
#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lab {

class Screen {
  public:
    /// Draws with the context of the window, which must live longer. Throws NoRenderer, ShaderError.
    Screen(const Options& options, Window& window);

    /// The window's size in pixels; false while it has none.
    bool size(int& width, int& height) const;
    /// Draws into the window, anew where `changed` or where the window has another size. False while it has none. Throws THREE::SceneError.
    bool draw(Session& session, View* before, bool changed);

    /// What has become ready since the last draw.
    enum class News { none, panel, picture };
    News news();
    /// Whether the picture is an old one, because shaders are being compiled.
    bool waiting() const { return waiting_; }
    /// Gets ready for one more of the things that the user may do next. False where there is nothing left to do.
    bool prepare(Session& session);
    /// What is wrong with the shaders, if something is: the picture is the last good one.
    const std::optional<std::string>& problem() const { return problem_; }

    /// Takes a changed file of the shaders; none if it is no such file, else what is wrong with it, or an empty text.
    std::optional<std::string> reload(const std::string& file);
    /// The folders that such files are in.
    std::vector<std::string> shaderFolders() const;

    /// Writes what the session shows, as a frame without a window would be. Throws as image::write does.
    void write(Session& session, View* before, const std::string& file, int width, int height);
    /// What a light costs, in words.
    std::string lightCost(Session& session);
    /// The 8-bit code of P that the driver drew into a pixel; 0,0 is the top left. None where the picture is not P, or not ready.
    std::optional<std::array<std::uint8_t, 3>> pixel(const Session& session, int x, int y);
    const render::FrameStats& stats() const { return drawn_; }
    /// For differences what the colours mean and the largest one, and how far the reference is; else none.
    std::optional<PanelLegend> legend(const Session& session) const;

  private:
    void bringUp(Session& session);
    void drawByDriver(std::span<const Side> sides);
    void askReference();
    void takeReference();

    const std::string shaders_;  // --shaders
    const std::string program_;
    Window& window_;
    std::atomic<bool> compiled_ = false;  // something, since the last draw
    std::atomic<bool> evaluated_ = false;
    render::GlRenderer gl_;
    render::ReferenceRenderer reference_;
    render::FrameStats drawn_;
    std::optional<State> drawnState_;  // of the last picture
    std::optional<std::string> problem_;
    int width_ = 0, height_ = 0;  // of the picture
    bool waiting_ = false;  // for programs
    bool differs_ = false;  // the picture is to be a difference
    bool byDriver_ = true;  // it is what the driver drew
    std::vector<Side> asked_;  // of the reference
    std::vector<image::Frame> evaluatedSides_;
    std::optional<render::DifferenceView> difference_;
    std::size_t prepared_ = 0;  // how many of the things that may come next
    ReferenceAside aside_;  // last: it tells the members above
};

}  // namespace lab
