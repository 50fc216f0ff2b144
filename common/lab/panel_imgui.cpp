// Dear ImGui as a plain text drawer: spans in tones, the symbols that are off struck through.
// SPDX-License-Identifier: MIT
#include "lab/panel_imgui.hpp"

#include <GLES3/gl3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <filesystem>
#include <imgui.h>

namespace lab {

namespace {

// Debian's fonts-dejavu-core; without it ImGui's own font draws the letters, and question marks for Greek ones.
constexpr const char* fontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float fontSize = 15;
constexpr float equationFontSize = 26;

ImVec4 color(Tone tone) {
    switch (tone) {
    case Tone::active:
        return {1.00F, 0.85F, 0.45F, 1};
    case Tone::idle:
        return {0.62F, 0.60F, 0.55F, 1};
    case Tone::off:
        return {0.55F, 0.55F, 0.58F, 1};
    case Tone::title:
        return {0.65F, 0.80F, 1.00F, 1};
    case Tone::plain:
        break;
    }
    return {0.92F, 0.92F, 0.92F, 1};
}

void drawSpan(const Span& span) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::PushStyleColor(ImGuiCol_Text, color(span.tone));
    ImGui::TextUnformatted(span.text.c_str());
    ImGui::PopStyleColor();
    if (span.tone != Tone::off)
        return;
    const ImVec2 size = ImGui::GetItemRectSize();
    const float y = from.y + size.y * 0.55F;
    ImGui::GetWindowDrawList()->AddLine({from.x, y}, {from.x + size.x, y},
                                        ImGui::GetColorU32(color(Tone::off)), 2);
}

void drawLine(const std::vector<Span>& spans) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if (i > 0)
            ImGui::SameLine(0, 0);
        drawSpan(spans[i]);
    }
    if (spans.empty())
        ImGui::NewLine();
}

// A box of text at `place`; `pivot` is the corner of the box that stands there.
template <class Content>
void box(const char* name, ImVec2 place, ImVec2 pivot, const Content& content) {
    ImGui::SetNextWindowPos(place, ImGuiCond_Always, pivot);
    ImGui::SetNextWindowBgAlpha(0.72F);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings;
    ImGui::Begin(name, nullptr, flags);
    content();
    ImGui::End();
}

// ImGui loads libGL by itself and leaves errors on ES contexts that are not ours to report.
void drainErrors() {
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

}  // namespace

PanelDrawer::PanelDrawer(GLFWwindow* window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is written beside the lesson
    ImGui::StyleColorsDark();
    static const ImWchar letters[] = {0x20,   0x17F,  0x370, 0x3FF,
                                      0x2000, 0x22FF, 0};  // Latin, Greek, signs and operators
    std::error_code ignored;
    for (const float size : {fontSize, equationFontSize})
        if (std::filesystem::exists(fontFile, ignored))
            io.Fonts->AddFontFromFileTTF(fontFile, size, nullptr, letters);
        else
            io.Fonts->AddFontDefault();
    ImGui_ImplGlfw_InitForOpenGL(window, false);
    ImGui_ImplOpenGL3_Init("#version 300 es");
    drainErrors();
}

void PanelDrawer::shutDown() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void PanelDrawer::drawBar(const Bar& bar) {
    constexpr float width = 80, height = 11;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    const float top = from.y + (line - height) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 edge = ImGui::GetColorU32(color(bar.chosen ? Tone::title : Tone::off));
    const ImVec2 end{from.x + width, top + height};
    list.AddRectFilled({from.x, top}, {from.x + width * static_cast<float>(bar.share), end.y}, edge);
    list.AddRect({from.x, top}, end, edge);
    bars_.push_back({from.x, from.y, end.x, from.y + line});
    ImGui::Dummy({width + 8, line});
    ImGui::SameLine(0, 0);
    drawLine(bar.text);
}

int PanelDrawer::barAt(double x, double y) const {
    const auto holds = [x, y](const Place& p) {
        return x >= p.left - 4 && x <= p.right + 4 && y >= p.top && y <= p.bottom;
    };
    const auto found = std::find_if(bars_.begin(), bars_.end(), holds);
    return found == bars_.end() ? noBar : static_cast<int>(found - bars_.begin());
}

double PanelDrawer::shareAt(int bar, double x) const {
    const Place& p = bars_.at(static_cast<std::size_t>(bar));
    return std::clamp((x - p.left) / (p.right - p.left), 0.0, 1.0);
}

void PanelDrawer::draw(const Panel& panel) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    box("equation", {10, 10}, {0, 0}, [&panel] {
        ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
        drawLine(panel.equation);
        ImGui::PopFont();
        if (!panel.message.empty())
            drawSpan({panel.message, Tone::title});
    });
    const float bottom = ImGui::GetIO().DisplaySize.y - 10;
    if (!panel.rows.empty())
        box("legend", {10, bottom}, {0, 1}, [&panel] {
            for (const std::vector<Span>& row : panel.rows)
                drawLine(row);
        });
    bars_.clear();
    if (!panel.bars.empty() || !panel.readings.empty())
        box("controls", {ImGui::GetIO().DisplaySize.x - 10, bottom}, {1, 1}, [this, &panel] {
            for (const Bar& bar : panel.bars)
                drawBar(bar);
            for (const std::vector<Span>& reading : panel.readings)
                drawLine(reading);
        });
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    drainErrors();
}

}  // namespace lab
