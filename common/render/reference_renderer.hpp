// The renderer that needs no driver: lighting::reference, in doubles, on all cores.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/reference.hpp"
#include "render/renderer.hpp"

#include <atomic>

namespace render {

/// Draws a reference into a frame of its size, on all cores. Once `stop` is set, by any thread, it ends
/// within milliseconds (the memory of a frame of 3840 x 2160 alone takes 40) and returns none. `nonfinite`:
/// where to count pixels that met NaN or infinity. Codes cannot be had of NaN: image::Error.
std::optional<image::Frame> drawReference(const lighting::reference::Reference<double>& reference,
                                          bool floats, const Progress& progress = {},
                                          const std::atomic<bool>* stop = nullptr,
                                          long long* nonfinite = nullptr);

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
