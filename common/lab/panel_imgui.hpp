// The panel drawn with Dear ImGui; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window.hpp"

struct GLFWwindow;

namespace lab {

/// Draws a Panel over the frame in the corner of a window.
class PanelDrawer {
  public:
    explicit PanelDrawer(GLFWwindow* window);
    void draw(const Panel& panel);
    /// Before the window's context goes.
    void shutDown();
};

}  // namespace lab
