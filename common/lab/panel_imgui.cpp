// Dear ImGui as a plain text drawer: spans in tones, the symbols that are off struck through.
// SPDX-License-Identifier: MIT
#include "lab/panel_imgui.hpp"

#include <GLES3/gl3.h>
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
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    drainErrors();
}

}  // namespace lab
