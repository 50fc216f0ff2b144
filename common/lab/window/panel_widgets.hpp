// The controls of the panel; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window/panel_text.hpp"

namespace lab {

/// Draws a group from ImGui's cursor on. What the user changes is said, and changed in the group as well:
/// until the program answers with a new panel, the next frame goes on from there.
void drawGroup(Brush& brush, WidgetGroup& group);

/// Numbers as a command has them, shortest so that they are read back as the same: "1,2.5,3".
std::string numbersText(const double* numbers, std::size_t count);

/// A colour as a command has it: "0xDD6666" if its components are 8-bit codes, else its three numbers.
std::string colorText(const std::array<double, 3>& color);

}  // namespace lab
