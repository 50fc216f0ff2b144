// What happens when the display goes away while a window is open; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

namespace lab {

/// After glfwInit: from then on a lost X display ends the process with exit status 3 and one line on stderr.
/// Xlib allows no other end: whatever returns from its handler, or calls it again, is lost.
void handleLostDisplay();

}  // namespace lab
