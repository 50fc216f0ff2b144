// The window: GLFW with an EGL context for OpenGL ES 3.0.
// SPDX-License-Identifier: MIT
#include "lab/window.hpp"

#include "lab/panel_imgui.hpp"

#define GLFW_INCLUDE_ES3
#include <GLFW/glfw3.h>

#include <cctype>
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
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
            of(w).key(key, action, (modifiers & (GLFW_MOD_SHIFT | GLFW_MOD_CONTROL)) != 0);
        });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
            of(w).button(button == GLFW_MOUSE_BUTTON_LEFT && action == GLFW_PRESS);
        });
        glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).move(x, y); });
        glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) {
            of(w).add({Event::Kind::wheel, 0, 0, y});
        });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).add({}); });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).add({}); });
        glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { of(w).add({Event::Kind::close, 0, 0, 0}); });
    }
    ~GlfwWindow() override {
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
        if (wait && events_.empty())
            glfwWaitEvents();
        else
            glfwPollEvents();
        return std::exchange(events_, {});
    }

    void show(const Panel& panel) override {
        panel_.draw(panel);
        glfwSwapBuffers(window_);
    }

  private:
    static GlfwWindow& of(GLFWwindow* w) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(w)); }

    void add(const Event& event) { events_.push_back(event); }

    void key(int key, int action, bool modified) {
        int code = key < 0x80 ? std::toupper(key) : 0;
        if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
            code = '0' + (key - GLFW_KEY_KP_0);
        else if (key == GLFW_KEY_ESCAPE)
            code = keyEscape;
        else if (key == GLFW_KEY_F2)
            code = keyF2;
        else if (key == GLFW_KEY_TAB)
            code = keyTab;
        else if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT)
            code = key == GLFW_KEY_LEFT ? keyLeft : keyRight;
        const bool repeats = code == keyLeft || code == keyRight;
        if (code != 0 && (action == GLFW_PRESS || (action == GLFW_REPEAT && repeats)))
            add({Event::Kind::key, code, 0, 0, modified});
    }

    // A press on a bar holds it until the button is let go, wherever the mouse goes.
    void button(bool pressedLeft) {
        held_ = pressedLeft ? panel_.barAt(x_, y_) : noBar;
        if (held_ != noBar)
            add({Event::Kind::bar, held_, panel_.shareAt(held_, x_), 0});
    }

    void move(double x, double y) {
        int width = 1, height = 1;
        glfwGetWindowSize(window_, &width, &height);
        const Event::Kind kind = pressed(GLFW_MOUSE_BUTTON_LEFT)    ? Event::Kind::drag
                                 : pressed(GLFW_MOUSE_BUTTON_RIGHT) ? Event::Kind::pan
                                                                    : Event::Kind::redraw;
        if (held_ != noBar)
            add({Event::Kind::bar, held_, panel_.shareAt(held_, x), 0});
        else if (kind != Event::Kind::redraw && height > 0)
            add({kind, 0, (x - x_) / height, (y - y_) / height});
        x_ = x;
        y_ = y;
    }

    bool pressed(int button) const { return glfwGetMouseButton(window_, button) == GLFW_PRESS; }

    GLFWwindow* window_;
    PanelDrawer panel_;
    std::vector<Event> events_;
    int held_ = noBar;
    double x_ = 0;
    double y_ = 0;
};

}  // namespace

}  // namespace lab

extern "C" lab::Window* lambertOpenWindow(int width, int height, const char* title, std::string& reason) {
    if (glfwInit() != GLFW_TRUE) {
        reason = lab::glfwReason();
        return nullptr;
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    GLFWwindow* window = glfwCreateWindow(width, height, title, nullptr, nullptr);
    if (window == nullptr) {
        reason = lab::glfwReason();
        glfwTerminate();
        return nullptr;
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return new lab::GlfwWindow(window);
}
