// Who gets the mouse: a box of the panel, a handle, the divider, or the picture; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window/panel_imgui.hpp"

#include <functional>

namespace lab {

/// Turns what GLFW tells of the mouse into events, and tells the panel what is its own. What is pressed keeps
/// the mouse until it is let go, wherever that is. First come boxes and popups, then handles, then the
/// divider, then the picture.
class Mouse {
  public:
    /// `tell` gets each event as it happens.
    Mouse(GLFWwindow* window, PanelDrawer& panel, std::function<void(Event)> tell);

    /// As GLFW's callbacks.
    void button(int button, bool pressed, int modifiers);
    void move(double x, double y);
    void enter(bool entered);
    void wheel(double dx, double dy);
    /// After all of them: tells the panel, and then the picture, where the mouse has come to.
    void settle();

  private:
    enum class Held { nothing, panel, picture, pan, handle, divider };

    Event event(Event::Kind kind) const;
    bool down(int key) const;
    void press(int button);
    void letGo();
    void dragGrab();

    GLFWwindow* window_;
    PanelDrawer& panel_;
    std::function<void(Event)> tell_;
    Held held_ = Held::nothing;  // what has the button that is down
    int heldButton_ = 0;
    Grab grab_;
    bool moved_ = false;  // since it was last settled
    bool inside_ = true;  // the window
    bool hovers_ = false;  // the program believes that the mouse is over the picture
    double x_ = 0, y_ = 0;
};

}  // namespace lab
