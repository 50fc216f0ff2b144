// What a light costs (slide 39: each one is another addend at every pixel).
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/view.hpp"
#include "render/renderer.hpp"

#include <functional>
#include <vector>

namespace lab {

/// Times of frames with all lights and of frames without the directional and point ones.
struct LightCost {
    int lights = 0;  ///< directional and point ones that are computed
    std::vector<double> with, without;  ///< milliseconds each

    /// Milliseconds for each light; 0 without lights.
    double each() const;
};

/// Draws `frames` frames of each kind at `time`, one kind after the other. `done` is told how many of `frames` are drawn.
LightCost measureLights(View& view, render::Renderer& renderer, const lighting::Switches& switches,
                        double time, const render::FrameRequest& request, int frames,
                        const std::function<void(int)>& done = {});

/// The middle one, or the mean of the two in the middle; 0 for none.
double median(std::vector<double> values);

}  // namespace lab
