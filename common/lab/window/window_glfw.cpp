// The window: GLFW with an EGL context for OpenGL ES 3.0.
// SPDX-License-Identifier: MIT
#include "lab/window.hpp"

#include "lab/window/panel_imgui.hpp"
#include "lab/window/window_keys.hpp"
#include "lab/window/window_lost.hpp"
#include "lab/window/window_mouse.hpp"
#include "lab/window/window_outside.hpp"

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
    explicit GlfwWindow(GLFWwindow* window)
        : window_(window), panel_(window),
          mouse_(window, panel_, [this](Event event) { add(std::move(event)); }) {
        glfwSetWindowUserPointer(window, this);
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
        mouse_.settle();
        setCursor();
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
    static GlfwWindow& of(GLFWwindow* w) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(w)); }

    void listen() {
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
            of(w).key(key, scancode, action, modifiers);
        });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) { of(w).character(code); });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int modifiers) {
            of(w).mouse_.button(button, action == GLFW_PRESS, modifiers);
            of(w).collectPanel();
        });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { of(w).mouse_.move(x, y); });
        glfwSetCursorEnterCallback(window_,
                                   [](GLFWwindow* w, int in) { of(w).mouse_.enter(in == GLFW_TRUE); });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) { of(w).mouse_.wheel(x, y); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).add({}); });
        glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { of(w).add({}); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).add({}); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
            glfwSetWindowShouldClose(w, GLFW_FALSE);  // the program decides, and may stay
            of(w).add({Event::Kind::close});
        });
    }

    // One movement on top of the one before it is one movement: a slow program does not fall behind the
    // mouse.
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
        const bool typing = panel_.takesText();
        if (typing || action == GLFW_RELEASE)
            panel_.key(key, scancode, action, modifiers);
        if (typing)
            return collectPanel();
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
    Mouse mouse_;
    std::optional<Outside> outside_;
    std::vector<Event> events_;
    std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors_{};  // null: the arrow
    int cursor_ = ImGuiMouseCursor_Arrow;
    bool charMayFollow_ = false;  // the last event is the key that is being told
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
