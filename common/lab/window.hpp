// What the lab needs of a window and its panel; the module lambert_window has the real one.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/panel.hpp"

#include <memory>
#include <string>
#include <vector>

namespace lab {

/// What the user did, or what came from outside.
struct Event {
    enum class Kind {
        key,  ///< `key`, `modified`
        drag,  ///< left button on the picture: dx, dy
        pan,  ///< right button on the picture: dx, dy
        release,  ///< a drag, pan, handle or divider was let go
        wheel,  ///< dy: steps, forwards > 0
        hover,  ///< the mouse is over the picture, at x, y
        leave,  ///< it is over it no longer
        handle,  ///< the handle `text` is dragged to x, y
        divider,  ///< the divider is dragged to x
        command,  ///< a widget or a symbol says `text`
        line,  ///< `text` is a line of stdin
        endOfLines,  ///< stdin has ended
        file,  ///< the file `text`, as watch() would find it, was saved
        redraw,
        close
    };
    Kind kind = Kind::redraw;
    int key = 0;  ///< its character in upper case ('1', 'R', ' '), or one of the codes below
    double dx = 0;  ///< to the right, fractions of the window's height
    double dy = 0;  ///< downwards
    bool modified = false;  ///< with shift
    bool control = false;  ///< with control
    double x = 0, y = 0;  ///< place on the picture, as PanelPoint
    std::string text = {};
};
inline constexpr int keyEscape = 0x100;
inline constexpr int keyTab = 0x102;
inline constexpr int keyLeft = 0x103;  ///< this and the next are repeated while held
inline constexpr int keyRight = 0x104;
inline constexpr int keyPageUp = 0x105;
inline constexpr int keyPageDown = 0x106;
inline constexpr int keyDelete = 0x107;
inline constexpr int keyF1 = 0x110;  ///< F2 is the next, and so on to F12
inline constexpr int keyF2 = 0x111;
inline constexpr int keyF11 = 0x11A;

/// A window with an OpenGL ES 3.0 context that is current.
class Window {
  public:
    virtual ~Window() = default;
    /// Size of what is drawn into, pixels; may be 0 while minimised.
    virtual void framebufferSize(int& width, int& height) const = 0;
    /// What happened since the last call. Waits for something to happen if `wait`, using no CPU.
    virtual std::vector<Event> events(bool wait) = 0;
    /// Ends a wait of events(); from any thread.
    virtual void wake() = 0;
    /// Draws the panel over the frame and shows both.
    virtual void show(const Panel& panel) = 0;
    /// From now on, saved files of these folders are told as Event::Kind::file (in place of those told
    /// before).
    virtual void watch(const std::vector<std::string>& folders) = 0;
    virtual void setTitle(const std::string& title) = 0;
    virtual void toggleFullscreen() = 0;
    /// Where each thing of the panel was drawn last, so that a test knows where to click: its kind, what it
    /// says, its centre in the window's pixels, one per line: "symbol term cosine 300 52", "widget term
    /// ambient 812 240", "group terms 800 90", "handle light 2 500 300", "divider 480 330". What is folded
    /// away or scrolled out of sight is missing.
    virtual std::string places() const = 0;
};

/// Opens a window by loading the module, or gives back the one that is open in this process. Null with a
/// reason where there is no display or no module.
std::shared_ptr<Window> openWindow(int width, int height, const std::string& title, std::string& reason);

/// The module's one entry point (extern "C" lambertOpenWindow): leaves `window` null, with a reason, where it
/// cannot.
using OpenWindowFunction = void (*)(int width, int height, const char* title, std::shared_ptr<Window>& window,
                                    std::string& reason);

}  // namespace lab
