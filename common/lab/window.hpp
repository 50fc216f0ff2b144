// What the lab needs of a window and its panel; the module lambert_window has the real one.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace lab {

/// How a piece of text on the panel looks.
enum class Tone { plain, active, idle, off, title };

/// A piece of text.
struct Span {
    std::string text;  // UTF-8
    Tone tone = Tone::plain;
};

/// A row with a number that is moved by hand: a bar that the mouse can drag, and text to its right.
struct Bar {
    double share = 0;  ///< how full, 0 to 1
    bool chosen = false;  ///< the one that the arrow keys move
    std::vector<Span> text;
};

/// What stands on the panel: plain text, so that another front end could draw it too.
struct Panel {
    std::vector<Span> equation;  ///< at the top, left to right
    std::string message;  ///< below the equation, may be empty
    std::vector<std::vector<Span>> rows;  ///< in the lower left corner, a line each; may be empty
    std::vector<Bar> bars;  ///< in the lower right corner, with the readings below; may be empty
    std::vector<std::vector<Span>> readings;  ///< a line each; may be empty
};

/// What the user did.
struct Event {
    enum class Kind { key, drag, pan, wheel, bar, redraw, close };
    Kind kind = Kind::redraw;
    int key =
        0;  ///< key: its character in upper case ('1', 'R', ' '), or one of the codes below; bar: its number
    double dx =
        0;  ///< drag, pan: to the right, fractions of the window's height; bar: its new share; wheel: unused
    double dy = 0;  ///< drag, pan: downwards; wheel: steps, forwards > 0
    bool modified = false;  ///< key: with shift or control
};
inline constexpr int keyEscape = 0x100;
inline constexpr int keyF2 = 0x101;
inline constexpr int keyTab = 0x102;
inline constexpr int keyLeft = 0x103;  ///< this and the next are repeated while held
inline constexpr int keyRight = 0x104;

/// A window with an OpenGL ES 3.0 context that is current.
class Window {
  public:
    virtual ~Window() = default;
    /// Size of what is drawn into, pixels; may be 0 while minimised.
    virtual void framebufferSize(int& width, int& height) const = 0;
    /// What happened since the last call. Waits for something to happen if `wait`, using no CPU.
    virtual std::vector<Event> events(bool wait) = 0;
    /// Draws the panel over the frame and shows both.
    virtual void show(const Panel& panel) = 0;
};

/// Opens a window by loading the module. Null with a reason where there is no display or no module.
std::unique_ptr<Window> openWindow(int width, int height, const std::string& title, std::string& reason);

/// The module's one entry point (extern "C" lambertOpenWindow): null, with a reason, where it cannot.
using OpenWindowFunction = Window* (*)(int width, int height, const char* title, std::string& reason);

}  // namespace lab
