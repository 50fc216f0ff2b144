// The renderer that needs no driver: lighting::reference, in doubles, on all cores.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/renderer.hpp"

namespace render {

/// Draws with lighting::reference::Reference<double>. Of the settings only the switches, the view and `only` count:
/// nothing is skipped.
class ReferenceRenderer final : public Renderer {
  public:
    /// `progress` is told how far each frame is.
    explicit ReferenceRenderer(Progress progress = {}) : progress_(std::move(progress)) {}

    image::Frame render(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                        const lighting::Settings& settings, const FrameRequest& request) override;
    FrameStats stats() const override { return stats_; }
    std::string name() const override { return "reference, double precision"; }

  private:
    Progress progress_;
    FrameStats stats_;
};

}  // namespace render
