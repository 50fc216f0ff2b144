// Frames without a window: written, timed, counted, dumped.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/phases.hpp"
#include "lab/renderers.hpp"
#include "lab/view.hpp"
#include "render/renderer.hpp"

namespace lab {

/// Does what the options ask for without a window, for one picture: alone, or as one of many that share `renderers`.
/// `phases` goes on from where the caller left it.
void drawStill(View& view, const Options& options, Renderers& renderers, Phases& phases);

/// Draws what the view shows at `time` and writes it to `path`, with what is needed to know the picture again.
void writePicture(View& view, render::Renderer& renderer, const std::string& path, double time,
                  const lighting::Switches& switches, int width, int height, const Options& options);

}  // namespace lab
