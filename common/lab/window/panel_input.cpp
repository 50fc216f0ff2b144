// What PanelDrawer does with mouse and keys: each step is told to Dear ImGui by itself and worked off at once.
// SPDX-License-Identifier: MIT
#include "lab/window/panel_imgui.hpp"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <cfloat>
#include <cmath>
#include <imgui_internal.h>
#include <utility>

namespace lab {

void PanelDrawer::mouseAt(double x, double y) {
    ImGui::GetIO().MousePos = {static_cast<float>(x), static_cast<float>(y)};
    mouseMoved_ = true;
}

void PanelDrawer::mouseAway() {
    ImGui::GetIO().MousePos = {-FLT_MAX, -FLT_MAX};
    mouseMoved_ = true;
}

void PanelDrawer::modifiers(bool shift, bool control) {
    ImGui::GetIO().KeyShift = shift;
    ImGui::GetIO().KeyCtrl = control;
}

void PanelDrawer::settle() {
    if (mouseMoved_)
        pass();
}

void PanelDrawer::button(int button, bool pressed) {
    if (button < 0 || button >= ImGuiMouseButton_COUNT)
        return;
    settle();
    ImGui::GetIO().MouseDown[button] = pressed;
    pass();
    pass();  // in which a popup or field that has just opened tells that it takes the keys
    changed_ = true;
}

void PanelDrawer::wheel(double dx, double dy) {
    settle();
    ImGui::GetIO().MouseWheelH += static_cast<float>(dx);
    ImGui::GetIO().MouseWheel += static_cast<float>(dy);
    pass();
    pass();  // which lays out what has been scrolled
    changed_ = true;
}

void PanelDrawer::key(int glfwKey, int scancode, int action, int modifiers) {
    if (action !=
        GLFW_PRESS)  // held, it is pressed again: ImGui repeats by its own clock, which stands still here
        ImGui_ImplGlfw_KeyCallback(window_, glfwKey, scancode, GLFW_RELEASE, modifiers);
    if (!takesText())
        return;
    pass();
    if (action != GLFW_RELEASE) {
        ImGui_ImplGlfw_KeyCallback(window_, glfwKey, scancode, GLFW_PRESS, modifiers);
        pass();
        pass();  // in which a field that has been left says what was typed
    }
    changed_ = true;
}

void PanelDrawer::character(unsigned code) {
    ImGui::GetIO().AddInputCharacter(code);
    pass();
    changed_ = true;
}

bool PanelDrawer::takesMouse() const { return ImGui::GetIO().WantCaptureMouse; }

bool PanelDrawer::takesText() const { return ImGui::GetIO().WantTextInput; }

bool PanelDrawer::closePopup() {
    if (ImGui::GetCurrentContext()->OpenPopupStack.Size == 0)
        return false;
    closing_ = true;
    pass();
    pass();
    changed_ = true;
    return true;
}

Grab PanelDrawer::grabAt(double x, double y) const {
    if (!shown_ || takesMouse())
        return {};
    return lab::grabAt(look_, panel_, free_, {static_cast<float>(x), static_cast<float>(y)});
}

void PanelDrawer::showGrab(const Grab& grab) {
    changed_ = changed_ || grab.kind != grab_.kind || grab.name != grab_.name;
    mouseMoved_ = mouseMoved_ || changed_;
    grab_ = grab;
}

double PanelDrawer::dividerShare(double x) const {
    const double width = std::max(1.0F, ImGui::GetIO().DisplaySize.x);
    const double end =
        std::clamp((free_.right - look_.em()) / width, 0.0, 1.0);  // never where it could not be taken again
    return std::clamp(x / width, 0.0, free_.right < ImGui::GetIO().DisplaySize.x ? end : 1.0);
}

std::vector<std::string> PanelDrawer::takeCommands() { return std::exchange(said_, {}); }

bool PanelDrawer::takeChanged() { return std::exchange(changed_, false); }

std::string PanelDrawer::placesText() const {
    std::string text;
    for (const Brush::Place& place : places_)
        text += place.what + " " + std::to_string(std::lround(place.at.x)) + " " +
                std::to_string(std::lround(place.at.y)) + "\n";
    return text;
}

}  // namespace lab
