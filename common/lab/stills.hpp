// Frames without a window: written, timed, counted, dumped.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/view.hpp"
#include "render/renderer.hpp"

namespace lab {

/// Does what the command line asks for without a window.
void runStills(View& view, const Options& options);

/// Draws what the view shows at `time` and writes it to `path`, with what is needed to know the picture again.
void writePicture(View& view, render::Renderer& renderer, const std::string& path, double time,
                  const lighting::Switches& switches, int width, int height, const Options& options);

}  // namespace lab
