// The panel drawn with Dear ImGui; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window.hpp"
#include "lab/window/panel_overlay.hpp"
#include "lab/window/panel_text.hpp"

#include <map>

struct GLFWwindow;

namespace lab {

/// Draws a Panel over the frame of a window, and answers the mouse and the keys where they concern it.
///
/// What ImGui is told of the mouse is worked off at once, by a pass that lays the last panel out again and
/// draws nothing: so each press meets the widgets where they are, however slowly the program draws.
class PanelDrawer {
  public:
    explicit PanelDrawer(GLFWwindow* window);
    /// Draws it; the window's context is current and its framebuffer bound.
    void draw(const Panel& panel);
    /// Before the window's context goes.
    void shutDown();

    /// The mouse is at a place of the window; or nowhere, as long as it moves the picture.
    void mouseAt(double x, double y);
    void mouseAway();
    /// Before the others of this kind, where a key is held.
    void modifiers(bool shift, bool control);
    void button(int button, bool pressed);
    void wheel(double dx, double dy);
    /// While takesText(), and whenever a key is let go.
    void key(int glfwKey, int scancode, int action, int modifiers);
    void character(unsigned code);
    /// Works off what the mouse did.
    void settle();

    bool takesMouse() const;  ///< as settled: it is over a box, or a popup is open
    bool takesText() const;  ///< a field is being typed into
    /// Closes what is open over the panel; false: nothing was.
    bool closePopup();
    /// What the mouse would take hold of on the picture; draw() shows it until the next.
    Grab grabAt(double x, double y) const;
    void showGrab(const Grab& grab);
    /// The places of the picture that a divider can be dragged to, 0 to 1.
    double dividerShare(double x) const;

    /// What widgets and symbols have said since the last call.
    std::vector<std::string> takeCommands();
    /// Whether the panel looks different now although the program did nothing.
    bool takeChanged();
    /// The cursor that fits where the mouse is, as ImGuiMouseCursor.
    int cursor() const { return cursor_; }

    /// Where each thing was drawn last, its centre, in the window's pixels, one per line: "symbol term cosine
    /// 300 52", "widget term ambient 812 240", "group terms 800 90", "handle light 2 500 300", "divider 480
    /// 330". What is scrolled out of sight or folded away is missing.
    std::string placesText() const;

  private:
    struct Box {
        ImVec2 content{0, 0};  // size of what is in it, as last laid out
        ImVec2 at{0, 0}, size{0, 0};  // where it is in the window
        ImVec4 color;
        bool drawn = false;  // in this pass
    };

    static void fill(const ImDrawList*, const ImDrawCmd* command);
    template <class Content>
    ImVec2 box(const char* name, ImVec2 place, ImVec2 pivot, ImVec2 most, const Content& content,
               bool fill = false);
    bool pass();
    void layOut();
    void column(Brush& brush, float top, float width);
    ImVec2 readings(float top, float right, float most);
    void below(float right, float most, float rowsMost);

    GLFWwindow* window_;
    Look look_;
    Panel panel_;  // the last one, with what the user did to it since
    bool shown_ = false;  // there was one
    Free free_{};
    Grab grab_;
    std::map<std::string, Box> boxes_;
    bool legendApart_ = false;  // it has a box of its own
    float rowsWide_ = 0;  // of the rows by themselves
    bool unsettled_ = false;  // one of them has changed
    bool mouseMoved_ = false;
    bool changed_ = false;
    bool closing_ = false;
    int cursor_ = 0;
    unsigned hovered_ = 0;
    double time_ = 0;
    std::vector<std::string> said_;
    std::string typed_;  // not yet said
    std::vector<Brush::Place> places_;
};

}  // namespace lab
