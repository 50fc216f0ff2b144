// From GLFW's keys to those of Event; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

namespace lab {

/// Event::key of a key of GLFW, by what the keyboard's layout writes on it where that is one ASCII character;
/// 0: none.
int keyCode(int glfwKey, int scancode);

/// Whether Event::key is told again while the key is held.
bool keyRepeats(int code);

/// Whether a typed character says better than the key what is meant: + is shift and = on one keyboard, a key
/// of its own on another; / is shift and 7 on an Italian one.
bool typedMeans(unsigned character);

}  // namespace lab
