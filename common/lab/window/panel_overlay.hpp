// What the panel draws over the picture itself: arrows, words, handles, the divider; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window/panel_text.hpp"

namespace lab {

/// Where there is room for the divider's line and its words, in the window's units.
struct Free {
    float top;  ///< below the equation
    float left, below;  ///< right and lower end of the box at the upper left
    float right;  ///< begin of the column
    float rowsTop, rowsRight;  ///< upper and right end of the box at the lower left
    float legendTop, legendLeft;  ///< upper and left end of the box at the lower right
};

/// What the mouse would take hold of at a place of the picture.
struct Grab {
    enum class Kind { nothing, handle, divider } kind = Kind::nothing;
    std::string name = {};  ///< handle: its name
    ImVec2 offset{0, 0};  ///< from the mouse to its centre
};

/// The nearest handle within 0.6 lines of text, else the divider's grip or line.
Grab grabAt(const Look& look, const Panel& panel, const Free& free, ImVec2 mouse);

/// Draws it all under ImGui's boxes. `grab` is what the mouse holds or is over: it is drawn larger, a handle
/// with its help.
void drawOverlay(Brush& brush, const Panel& panel, const Free& free, const Grab& grab);

}  // namespace lab
