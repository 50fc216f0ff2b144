// The panel drawn with Dear ImGui; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window.hpp"

struct GLFWwindow;

namespace lab {

inline constexpr int noBar = -1;

/// Draws a Panel over the frame in the corner of a window.
class PanelDrawer {
  public:
    explicit PanelDrawer(GLFWwindow* window);
    void draw(const Panel& panel);
    /// The number of the panel's bar at a place in the window, as it was last drawn, or noBar.
    int barAt(double x, double y) const;
    /// The share of that bar which lies left of x, 0 to 1.
    double shareAt(int bar, double x) const;
    /// Before the window's context goes.
    void shutDown();

  private:
    struct Place {
        float left, top, right, bottom;
    };
    void drawBar(const Bar& bar);

    std::vector<Place> bars_;  // where they were drawn, window coordinates
};

}  // namespace lab
