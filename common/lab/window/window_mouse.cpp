// The state of the mouse between its events.
// SPDX-License-Identifier: MIT
#include "lab/window/window_mouse.hpp"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <utility>

namespace lab {

Mouse::Mouse(GLFWwindow* window, PanelDrawer& panel, std::function<void(Event)> tell)
    : window_(window), panel_(panel), tell_(std::move(tell)) {
    glfwGetCursorPos(window, &x_, &y_);  // so that the first drag does not jump
}

bool Mouse::down(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

// An event with the place of the mouse, and with what is held besides.
Event Mouse::event(Event::Kind kind) const {
    int width = 1, height = 1;
    glfwGetWindowSize(window_, &width, &height);
    Event event{kind};
    event.x = x_ / std::max(1, width);
    event.y = y_ / std::max(1, height);
    event.modified = down(GLFW_KEY_LEFT_SHIFT) || down(GLFW_KEY_RIGHT_SHIFT);
    event.control = down(GLFW_KEY_LEFT_CONTROL) || down(GLFW_KEY_RIGHT_CONTROL);
    return event;
}

void Mouse::button(int button, bool pressed, int modifiers) {
    panel_.modifiers((modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0);
    if (pressed && held_ == Held::nothing)
        press(button);
    else if (!pressed && held_ != Held::nothing && button == heldButton_)
        letGo();
}

void Mouse::press(int button) {
    settle();
    heldButton_ = button;
    if (panel_.takesMouse()) {
        held_ = Held::panel;
        return panel_.button(button, true);
    }
    grab_ = panel_.grabAt(x_, y_);
    if (panel_.takesText()) {  // a field that is being typed into is left
        panel_.button(button, true);
        panel_.button(button, false);
    }
    if (button == GLFW_MOUSE_BUTTON_RIGHT)
        held_ = Held::pan;
    else if (button != GLFW_MOUSE_BUTTON_LEFT)
        return;
    else if (grab_.kind == Grab::Kind::nothing)
        held_ = Held::picture;
    else
        held_ = grab_.kind == Grab::Kind::handle ? Held::handle : Held::divider;
}

void Mouse::letGo() {
    if (std::exchange(held_, Held::nothing) == Held::panel)
        panel_.button(heldButton_, false);
    else
        tell_(event(Event::Kind::release));
    if (inside_)
        panel_.mouseAt(x_, y_);
    else
        panel_.mouseAway();
    moved_ = true;
}

void Mouse::move(double x, double y) {
    int height = 1;
    glfwGetWindowSize(window_, nullptr, &height);
    const double dx = (x - x_) / std::max(1, height), dy = (y - y_) / std::max(1, height);
    x_ = x;
    y_ = y;
    switch (held_) {
    case Held::nothing:
    case Held::panel:
        panel_.mouseAt(x, y);
        moved_ = true;
        return;
    case Held::picture:
    case Held::pan: {
        Event moved = event(held_ == Held::pan ? Event::Kind::pan : Event::Kind::drag);
        moved.dx = dx;
        moved.dy = dy;
        return tell_(std::move(moved));
    }
    case Held::handle:
    case Held::divider:
        return dragGrab();
    }
}

// The thing stays as far from the mouse as it was when it was taken.
void Mouse::dragGrab() {
    int width = 1, height = 1;
    glfwGetWindowSize(window_, &width, &height);
    const double x = x_ + static_cast<double>(grab_.offset.x), y = y_ + static_cast<double>(grab_.offset.y);
    Event moved = event(held_ == Held::handle ? Event::Kind::handle : Event::Kind::divider);
    moved.text = grab_.name;
    moved.x = held_ == Held::divider ? panel_.dividerShare(x) : x / std::max(1, width);
    moved.y = y / std::max(1, height);
    tell_(std::move(moved));
}

void Mouse::settle() {
    if (!std::exchange(moved_, false))
        return;
    panel_.settle();
    if (held_ != Held::nothing)
        return;
    const bool onPicture = inside_ && !panel_.takesMouse();
    panel_.showGrab(onPicture ? panel_.grabAt(x_, y_) : Grab{});
    panel_.settle();
    if (onPicture)
        tell_(event(Event::Kind::hover));
    else if (hovers_)
        tell_({Event::Kind::leave});
    hovers_ = onPicture;
}

void Mouse::enter(bool entered) {
    inside_ = entered;
    if (held_ != Held::nothing)
        return;
    if (entered)
        panel_.mouseAt(x_, y_);
    else
        panel_.mouseAway();
    moved_ = true;
}

void Mouse::wheel(double dx, double dy) {
    settle();
    if (panel_.takesMouse())
        return panel_.wheel(dx, dy);
    Event turned = event(Event::Kind::wheel);
    turned.dy = dy;
    tell_(std::move(turned));
}

}  // namespace lab
