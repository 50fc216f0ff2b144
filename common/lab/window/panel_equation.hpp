// The equation of the panel, as symbols that one clicks; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window/panel_text.hpp"

namespace lab {

/// Draws it from ImGui's cursor on, `width` wide at most: smaller where that suffices, else on several lines.
void drawEquation(Brush& brush, const Panel& panel, float width);

}  // namespace lab
