// Renderers: what draws frames without a window, made when first needed and then kept.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/options.hpp"
#include "lab/progress.hpp"
#include "render/context.hpp"
#include "render/renderer.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace lab {

/// One context, one GL renderer for each folder of shaders, and the reference.
class Renderers {
  public:
    /// What --renderer and --shaders ask for. A folder's shader files are read once, when a frame first needs them.
    /// Throws NoRenderer, ShaderError.
    render::Renderer& get(const Options& options);
    /// To be told after each picture; the first one is remembered.
    void pictureIsDrawn();
    /// 0 if none is drawn yet.
    double millisecondsSinceFirstPicture() const;
    /// Whether the slow reference shows a bar for each frame.
    bool showProgress = true;

  private:
    std::optional<render::HeadlessContext> context_;
    std::map<std::string, std::unique_ptr<render::Renderer>> gl_;  // by --shaders; before the context goes
    std::unique_ptr<render::Renderer> reference_;
    std::optional<Progress> progress_;  // of the reference's frame
    std::optional<std::chrono::steady_clock::time_point> firstPicture_;
};

}  // namespace lab
