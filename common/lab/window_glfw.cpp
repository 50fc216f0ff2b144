// The window: GLFW with an EGL context for OpenGL ES 3.0.
// SPDX-License-Identifier: MIT
#include "lab/window.hpp"

#include "lab/panel_imgui.hpp"
#include "lab/window_keys.hpp"
#include "lab/window_lost.hpp"
#include "lab/window_outside.hpp"

#define GLFW_INCLUDE_ES3
#include <GLFW/glfw3.h>

#include <algorithm>
#include <imgui.h>
#include <optional>
#include <utility>

namespace lab {

namespace {

std::string glfwReason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "GLFW gave no reason";
}

class GlfwWindow final : public Window {
  public:
    explicit GlfwWindow(GLFWwindow* window) : window_(window), panel_(window) {
        glfwSetWindowUserPointer(window, this);
        glfwGetCursorPos(window, &x_, &y_);  // so that the first drag does not jump
        listen();
        for (const auto& [imgui, glfw] : {std::pair{ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR},
                                          std::pair{ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR},
                                          std::pair{ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR}})
            cursors_[static_cast<std::size_t>(imgui)] = glfwCreateStandardCursor(glfw);
        outside_.emplace([] { glfwPostEmptyEvent(); });
    }
    ~GlfwWindow() override {
        outside_.reset();  // which posts events
        panel_.shutDown();
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    void framebufferSize(int& width, int& height) const override {
        glfwGetFramebufferSize(window_, &width, &height);
    }

    std::vector<Event> events(bool wait) override {
        takeOutside();
        collectPanel();
        if (wait && events_.empty())
            glfwWaitEvents();
        else
            glfwPollEvents();
        settleMouse();
        takeOutside();
        collectPanel();
        return std::exchange(events_, {});
    }

    void wake() override { glfwPostEmptyEvent(); }

    void show(const Panel& panel) override {
        int width = 0, height = 0;
        framebufferSize(width, height);
        if (width < 1 || height < 1)
            return;
        panel_.draw(panel);
        setCursor();
        glfwSwapBuffers(window_);
    }

    void watch(const std::vector<std::string>& folders) override { outside_->watch(folders); }

    void setTitle(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }

    void toggleFullscreen() override {
        if (glfwGetWindowMonitor(window_) != nullptr) {
            glfwSetWindowMonitor(window_, nullptr, place_[0], place_[1], place_[2], place_[3],
                                 GLFW_DONT_CARE);
            return;
        }
        glfwGetWindowPos(window_, &place_[0], &place_[1]);
        glfwGetWindowSize(window_, &place_[2], &place_[3]);
        if (GLFWmonitor* const monitor = nearestMonitor())
            if (const GLFWvidmode* const mode = glfwGetVideoMode(monitor))
                glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

    std::string places() const override { return panel_.placesText(); }

  private:
    // What has the button that is down.
    enum class Held { nothing, panel, picture, pan, handle, divider };

    static GlfwWindow& of(GLFWwindow* w) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(w)); }

    void listen() {
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
            of(w).key(key, scancode, action, modifiers);
        });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) { of(w).character(code); });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int modifiers) {
            of(w).button(button, action == GLFW_PRESS, modifiers);
        });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { of(w).move(x, y); });
        glfwSetCursorEnterCallback(window_,
                                   [](GLFWwindow* w, int entered) { of(w).enter(entered == GLFW_TRUE); });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) { of(w).wheel(x, y); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).add({}); });
        glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { of(w).add({}); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).add({}); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
            glfwSetWindowShouldClose(w, GLFW_FALSE);  // the program decides, and may stay
            of(w).add({Event::Kind::close});
        });
    }

    // Where the mouse is, as every event of the mouse has it.
    Event mouseEvent(Event::Kind kind) const {
        int width = 1, height = 1;
        glfwGetWindowSize(window_, &width, &height);
        Event event{kind};
        event.x = x_ / std::max(1, width);
        event.y = y_ / std::max(1, height);
        event.modified = pressed(GLFW_KEY_LEFT_SHIFT) || pressed(GLFW_KEY_RIGHT_SHIFT);
        event.control = pressed(GLFW_KEY_LEFT_CONTROL) || pressed(GLFW_KEY_RIGHT_CONTROL);
        return event;
    }
    bool pressed(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

    // One movement on top of the one before it is one movement: a slow program does not fall behind the mouse.
    void add(Event event) {
        charMayFollow_ = false;
        const bool moves = event.kind == Event::Kind::drag || event.kind == Event::Kind::pan ||
                           event.kind == Event::Kind::hover || event.kind == Event::Kind::handle ||
                           event.kind == Event::Kind::divider || event.kind == Event::Kind::redraw;
        if (moves && !events_.empty() && events_.back().kind == event.kind &&
            events_.back().text == event.text && events_.back().modified == event.modified &&
            events_.back().control == event.control) {
            event.dx += events_.back().dx;
            event.dy += events_.back().dy;
            events_.back() = std::move(event);
        } else {
            events_.push_back(std::move(event));
        }
    }

    void takeOutside() {
        for (Event& event : outside_->take())
            add(std::move(event));
    }

    // What the panel has done by itself.
    void collectPanel() {
        for (std::string& command : panel_.takeCommands()) {
            Event event{Event::Kind::command};
            event.text = std::move(command);
            add(std::move(event));
        }
        if (panel_.takeChanged())
            add({});
    }

    void key(int key, int scancode, int action, int modifiers) {
        charMayFollow_ = false;
        const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0, control = (modifiers & GLFW_MOD_CONTROL) != 0;
        panel_.modifiers(shift, control);
        if (panel_.takesText()) {
            panel_.key(key, scancode, action, modifiers);
            return collectPanel();
        }
        const int code = keyCode(key, scancode);
        if (code == 0 || (modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0)
            return;
        if (action != GLFW_PRESS && !(action == GLFW_REPEAT && keyRepeats(code)))
            return;
        if (code == keyEscape && panel_.closePopup())
            return;
        Event event{Event::Kind::key, code};
        event.modified = shift;
        event.control = control;
        add(std::move(event));
        charMayFollow_ = true;
    }

    // GLFW tells what a key types directly after the key.
    void character(unsigned code) {
        if (panel_.takesText())
            panel_.character(code);
        else if (charMayFollow_ && typedMeans(code))
            events_.back().key = static_cast<int>(code);
        charMayFollow_ = false;
    }

    void button(int button, bool pressed, int modifiers) {
        panel_.modifiers((modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0);
        if (pressed && held_ == Held::nothing)
            press(button);
        else if (!pressed && held_ != Held::nothing && button == heldButton_)
            letGo();
    }

    void press(int button) {
        settleMouse();
        heldButton_ = button;
        const Grab grab = panel_.grabAt(x_, y_);
        if (panel_.takesMouse()) {
            held_ = Held::panel;
            panel_.button(button, true);
            return collectPanel();
        }
        panel_.button(button, true);  // on no box: a field that was open closes
        panel_.button(button, false);
        collectPanel();
        if (button == GLFW_MOUSE_BUTTON_RIGHT)
            held_ = Held::pan;
        else if (button != GLFW_MOUSE_BUTTON_LEFT)
            return;
        else if (grab.kind == Grab::Kind::nothing)
            held_ = Held::picture;
        else
            held_ = grab.kind == Grab::Kind::handle ? Held::handle : Held::divider;
        grab_ = grab;
    }

    void letGo() {
        const Held was = std::exchange(held_, Held::nothing);
        if (was == Held::panel)
            panel_.button(heldButton_, false);
        else
            add(mouseEvent(Event::Kind::release));
        panel_.mouseAt(x_, y_);
        moved_ = true;
        collectPanel();
    }

    void move(double x, double y) {
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
            Event event = mouseEvent(held_ == Held::pan ? Event::Kind::pan : Event::Kind::drag);
            event.dx = dx;
            event.dy = dy;
            return add(std::move(event));
        }
        case Held::handle:
        case Held::divider:
            return dragGrab();
        }
    }

    // The thing stays as far from the mouse as it was when it was taken.
    void dragGrab() {
        int width = 1, height = 1;
        glfwGetWindowSize(window_, &width, &height);
        Event event = mouseEvent(held_ == Held::handle ? Event::Kind::handle : Event::Kind::divider);
        event.text = grab_.name;
        event.x = (x_ + static_cast<double>(grab_.offset.x)) / std::max(1, width);
        event.y = (y_ + static_cast<double>(grab_.offset.y)) / std::max(1, height);
        if (held_ == Held::divider)
            event.x = panel_.dividerShare(x_ + static_cast<double>(grab_.offset.x));
        add(std::move(event));
    }

    // Tells the panel, and then the picture, where the mouse has come to.
    void settleMouse() {
        if (!std::exchange(moved_, false))
            return;
        panel_.settle();
        const bool onPicture = inside_ && !panel_.takesMouse() && held_ != Held::panel;
        if (held_ == Held::nothing)
            panel_.showGrab(onPicture ? panel_.grabAt(x_, y_) : Grab{});
        panel_.settle();
        setCursor();
        if (held_ == Held::nothing && onPicture)
            add(mouseEvent(Event::Kind::hover));
        else if (hovers_ && !onPicture)
            add({Event::Kind::leave});
        hovers_ = onPicture;
    }

    void enter(bool entered) {
        inside_ = entered;
        if (held_ != Held::nothing)
            return;
        if (entered)
            panel_.mouseAt(x_, y_);
        else
            panel_.mouseAway();
        moved_ = true;
    }

    void wheel(double dx, double dy) {
        settleMouse();
        if (panel_.takesMouse()) {
            panel_.wheel(dx, dy);
            return;
        }
        Event event = mouseEvent(Event::Kind::wheel);
        event.dy = dy;
        add(std::move(event));
    }

    void setCursor() {
        const int cursor = panel_.cursor();
        if (cursor == cursor_)
            return;
        cursor_ = cursor;
        glfwSetCursor(window_, cursor < 0 ? nullptr : cursors_[static_cast<std::size_t>(cursor)]);
    }

    // The one in which the window's middle is.
    GLFWmonitor* nearestMonitor() const {
        int count = 0;
        GLFWmonitor** const monitors = glfwGetMonitors(&count);
        const int middleX = place_[0] + place_[2] / 2, middleY = place_[1] + place_[3] / 2;
        for (int i = 0; i < count; ++i) {
            int x = 0, y = 0;
            glfwGetMonitorPos(monitors[i], &x, &y);
            const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
            if (mode != nullptr && middleX >= x && middleX < x + mode->width && middleY >= y &&
                middleY < y + mode->height)
                return monitors[i];
        }
        return glfwGetPrimaryMonitor();
    }

    GLFWwindow* window_;
    PanelDrawer panel_;
    std::optional<Outside> outside_;
    std::vector<Event> events_;
    std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors_{};  // null: the arrow
    int cursor_ = ImGuiMouseCursor_Arrow;
    Held held_ = Held::nothing;
    int heldButton_ = 0;
    Grab grab_;
    bool moved_ = false;  // since the mouse was last settled
    bool inside_ = true;
    bool hovers_ = false;  // the program believes that the mouse is over the picture
    bool charMayFollow_ = false;  // the last event is the key that is being told
    double x_ = 0;
    double y_ = 0;
    std::array<int, 4> place_{};  // x, y, width, height before fullscreen
};

std::weak_ptr<GlfwWindow> open;  // the one of this process

GLFWwindow* create(int width, int height, const char* title) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    return glfwCreateWindow(width, height, title, nullptr, nullptr);
}

}  // namespace

}  // namespace lab

extern "C" void lambertOpenWindow(int width, int height, const char* title,
                                  std::shared_ptr<lab::Window>& window, std::string& reason) {
    window = lab::open.lock();
    if (window) {
        window->setTitle(title);
        return;
    }
    lab::Outside::secureStdin();
    if (glfwInit() != GLFW_TRUE) {
        reason = lab::glfwReason();
        return;
    }
    lab::handleLostDisplay();
    GLFWwindow* const glfw = lab::create(width, height, title);
    if (glfw == nullptr) {
        reason = lab::glfwReason();
        glfwTerminate();
        return;
    }
    glfwMakeContextCurrent(glfw);
    glfwSwapInterval(1);
    const auto made = std::make_shared<lab::GlfwWindow>(glfw);
    lab::open = made;
    window = made;
}
