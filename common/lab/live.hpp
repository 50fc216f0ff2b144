// The window's loop: keys, mouse, panel, and drawing only what changed.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/view.hpp"
#include "lab/window.hpp"

namespace lab {

/// Shows the view until the window is closed or Esc is pressed.
void runLive(View& view, Window& window, const Options& options);

}  // namespace lab
