// Lays the panel's boxes out: equation at the top, readings at the left, widgets at the right, rows and legend at the bottom.
// SPDX-License-Identifier: MIT
#include "lab/window/panel_imgui.hpp"

#include "lab/window/panel_equation.hpp"
#include "lab/window/panel_notes.hpp"
#include "lab/window/panel_widgets.hpp"

#include <GLES3/gl3.h>
#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cfloat>
#include <cmath>
#include <imgui_internal.h>
#include <utility>

namespace lab {

namespace {

constexpr float curveWidth = 12;  // of a column of curves, heights of a line

// ImGui loads libGL by itself and leaves errors on ES contexts that are not ours to report.
void drainErrors() {
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

}  // namespace

PanelDrawer::PanelDrawer(GLFWwindow* window) : window_(window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is written beside the lesson
    io.ConfigInputTextCursorBlink = false;  // a still window draws nothing
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ImGui_ImplGlfw_InitForOpenGL(window, false);  // keys and clipboard; the rest is told by this class
    ImGui_ImplOpenGL3_Init("#version 300 es");
    drainErrors();
}

void PanelDrawer::shutDown() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

// The background of a box, opaque so that its text is legible on any picture, and cleared: on a driver
// without a GPU, blending it took as long as all that stands on it.
void PanelDrawer::fill(const ImDrawList*, const ImDrawCmd* command) {
    const Box& box = *static_cast<const Box*>(command->UserCallbackData);
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const float bottom = ImGui::GetIO().DisplaySize.y - box.at.y - box.size.y;
    GLfloat before[4];
    glGetFloatv(GL_COLOR_CLEAR_VALUE, before);
    glScissor(static_cast<GLint>(box.at.x * scale.x), static_cast<GLint>(bottom * scale.y),
              static_cast<GLsizei>(box.size.x * scale.x), static_cast<GLsizei>(box.size.y * scale.y));
    glClearColor(box.color.x, box.color.y, box.color.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearColor(before[0], before[1], before[2], before[3]);
}

// A box of `content` at `place`; `pivot` is the corner of the box that stands there. It is as large as its
// content was in the pass before, or as wide as `most` if it is to `fill` it; another pass follows if that
// has changed. Beyond `most` it scrolls. Returns its size.
template <class Content>
ImVec2 PanelDrawer::box(const char* name, ImVec2 place, ImVec2 pivot, ImVec2 most, const Content& content,
                        bool fills) {
    Box& known = boxes_[name];
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    const bool scrolls = known.content.y + 2 * pad.y > most.y;
    const float bar = scrolls ? ImGui::GetStyle().ScrollbarSize : 0;
    const float wide = fills ? most.x : known.content.x + 2 * pad.x + bar;
    const ImVec2 size{std::ceil(std::clamp(wide, 1.0F, std::max(1.0F, most.x))),
                      std::ceil(std::clamp(known.content.y + 2 * pad.y, 1.0F, std::max(1.0F, most.y)))};
    ImGui::SetNextWindowPos({std::floor(place.x), std::floor(place.y)}, ImGuiCond_Always, pivot);
    ImGui::SetNextWindowSize(size);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                       ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground;
    ImGui::Begin(name, nullptr,
                 flags | (scrolls ? ImGuiWindowFlags_AlwaysVerticalScrollbar : ImGuiWindowFlags_NoScrollbar));
    known.at = ImGui::GetWindowPos();
    known.size = ImGui::GetWindowSize();
    known.color = ImGui::ColorConvertU32ToFloat4(look_.box());
    known.drawn = true;
    ImGui::BeginGroup();
    content();
    ImGui::EndGroup();
    const ImVec2 now = ImGui::GetItemRectSize();
    ImGui::End();
    if ((!fills && std::abs(now.x - known.content.x) >= 0.5F) || std::abs(now.y - known.content.y) >= 0.5F)
        unsettled_ = true;
    known.content = now;
    return size;
}

// Lays the panel out once; false: there is nothing to see.
bool PanelDrawer::pass() {
    int width = 0, height = 0, pixelsWide = 0, pixelsHigh = 0;
    glfwGetWindowSize(window_, &width, &height);
    glfwGetFramebufferSize(window_, &pixelsWide, &pixelsHigh);
    if (!shown_ || width < 1 || height < 1)
        return false;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DisplayFramebufferScale = {static_cast<float>(pixelsWide) / io.DisplaySize.x,
                                  static_cast<float>(pixelsHigh) / io.DisplaySize.y};
    const double now = glfwGetTime();
    io.DeltaTime = static_cast<float>(std::clamp(now - time_, 1e-5, 1.0));
    time_ = now;
    unsettled_ = mouseMoved_ = false;
    ImGui::NewFrame();
    layOut();
    ImGui::EndFrame();
    cursor_ = ImGui::GetMouseCursor();
    const unsigned hovered = ImGui::GetHoveredID();
    changed_ = changed_ || io.WantCaptureMouse || hovered != hovered_;
    hovered_ = hovered;
    io.MouseWheel = io.MouseWheelH = 0;
    return true;
}

void PanelDrawer::draw(const Panel& panel) {
    panel_ = panel;
    shown_ = true;
    int width = 0, pixelsWide = 0;
    glfwGetWindowSize(window_, &width, nullptr);
    glfwGetFramebufferSize(window_, &pixelsWide, nullptr);
    float scale = 1;
    glfwGetWindowContentScale(window_, &scale, nullptr);
    if (width < 1 || pixelsWide < 1)
        return;
    look_.prepare(panel_, scale, static_cast<float>(pixelsWide) / static_cast<float>(width));
    constexpr int mostPasses = 4;
    for (int i = 0; i < mostPasses && pass() && unsettled_; ++i) {
    }
    changed_ = false;
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    drainErrors();
}

// The column of widgets at the right.
void PanelDrawer::column(Brush& brush, float top, float width) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float gap = look_.gap();
    box(
        "widgets", {window.x - gap, top}, {1, 0}, {width, window.y - top - gap},
        [this, &brush] {
            for (WidgetGroup& group : panel_.groups)
                drawGroup(brush, group);
        },
        true);
}

// Message, probe and curves, below the equation.
ImVec2 PanelDrawer::readings(float top, float right, float most) {
    const float gap = look_.gap(), room = right - gap;
    const float inside = room - 2 * ImGui::GetStyle().WindowPadding.x - ImGui::GetStyle().ScrollbarSize;
    const bool apart =
        !panel_.probe.empty() && panel_.probeAtRight && panel_.groups.empty() && !panel_.legend;
    if (apart)
        box("numbers", {right, top}, {1, 0}, {room, most}, [&] { drawTable(look_, panel_.probe, inside); });
    if (apart && panel_.message.empty() && panel_.curves.empty())
        return {0, 0};
    return box("readings", {gap, top}, {0, 0}, {room, most}, [&] {
        if (!panel_.message.empty())
            flow(look_, panel_.message, inside);
        if (!panel_.probe.empty() && !apart)
            drawTable(look_, panel_.probe, inside);
        if (!panel_.curves.empty())
            drawCurves(look_, panel_.curves, apart ? look_.em() * curveWidth : inside);
    });
}

// Rows in the lower left corner, and the legend beside them or, where that is too narrow, below them.
void PanelDrawer::below(float right, float most, float rowsMost) {
    const float gap = look_.gap(), room = right - gap;
    const float bottom = ImGui::GetIO().DisplaySize.y - gap;
    const float inside = room - 2 * ImGui::GetStyle().WindowPadding.x - ImGui::GetStyle().ScrollbarSize;
    const float legendWide = std::min(inside, look_.em() * 20);
    const float taken = boxes_["legend"].content.x + 2 * ImGui::GetStyle().WindowPadding.x;
    const bool beside = rowsWide_ + 2 * ImGui::GetStyle().WindowPadding.x + 3 * gap + taken <= right;
    const bool both = panel_.legend && !panel_.rows.empty() && !beside;
    if (!panel_.rows.empty()) {
        const ImVec2 size = box("rows", {gap, bottom}, {0, 1}, {room, rowsMost}, [&] {
            ImGui::BeginGroup();
            flow(look_, panel_.rows, inside);
            ImGui::EndGroup();
            rowsWide_ = ImGui::GetItemRectSize().x;
            if (both)
                drawLegend(look_, *panel_.legend, legendWide);
        });
        free_.rowsTop = bottom - size.y;
        free_.rowsRight = gap + size.x;
    }
    legendApart_ = panel_.legend && !both;
    if (!legendApart_)
        return;
    const ImVec2 size = box("legend", {right, bottom}, {1, 1}, {room, most * 0.6F},
                            [&] { drawLegend(look_, *panel_.legend, legendWide); });
    free_.legendTop = bottom - size.y;
    free_.legendLeft = right - size.x;
}

void PanelDrawer::layOut() {
    if (std::exchange(closing_, false))
        ImGui::ClosePopupToLevel(0, true);
    Brush brush{look_, {}, std::exchange(typed_, {}), {}};
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float gap = look_.gap();
    const float wide = window.x - 2 * gap;
    const float columnWide =
        panel_.groups.empty() ? 0 : std::floor(std::min(look_.em() * 19, window.x * 0.34F));
    const float columnLeft = columnWide > 0 ? window.x - gap - columnWide : window.x;
    const float right = columnLeft - gap;
    float top = gap, columnTop = gap;
    if (!panel_.equation.empty()) {
        const float inner = wide - 2 * ImGui::GetStyle().WindowPadding.x;
        const ImVec2 size = box("equation", {gap, gap}, {0, 0}, {wide, window.y * 0.6F},
                                [&] { drawEquation(brush, panel_, inner); });
        top += size.y + gap;
        columnTop = gap + size.x > right ? top : gap;
    }
    free_ = {top - gap, 0, top - gap, columnLeft, window.y, 0, window.y, window.x};
    const float most = window.y - top - gap;
    const float rows = panel_.rows.empty() ? 0 : boxes_["rows"].content.y;
    const float lines = std::max(rows, legendApart_ ? boxes_["legend"].content.y : 0) +
                        2 * ImGui::GetStyle().WindowPadding.y + gap;
    const bool reads = !panel_.message.empty() || !panel_.probe.empty() || !panel_.curves.empty();
    const float readingsMost = std::max(most * 0.6F, most - lines);
    float used = 0;
    if (reads) {
        const ImVec2 size = readings(top, right, readingsMost);
        used = size.y + gap;
        free_.left = gap + size.x;
        free_.below = top + size.y;
    }
    below(right, most, most - used);
    if (columnWide > 0)
        column(brush, columnTop, columnWide);
    drawOverlay(brush, panel_, free_, grab_);
    for (auto& [name, box] : boxes_)  // over what lies on the picture, under what stands in the boxes
        if (std::exchange(box.drawn, false))
            ImGui::GetBackgroundDrawList()->AddCallback(fill, &box);
    said_.insert(said_.end(), brush.said.begin(), brush.said.end());
    if (ImGui::GetIO().WantTextInput)
        typed_ = std::move(brush.typed);
    else if (!brush.typed.empty())
        said_.push_back(std::move(brush.typed));
    places_ = std::move(brush.places);
}

}  // namespace lab
