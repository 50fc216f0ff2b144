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

}  // namespace lab
