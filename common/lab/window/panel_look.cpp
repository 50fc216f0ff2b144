// Fonts baked from DejaVu Sans, two themes with colours that colour-blind people tell apart (after Okabe and Ito).
// SPDX-License-Identifier: MIT
#include "lab/window/panel_look.hpp"

#include <GLES3/gl3.h>
#include <algorithm>
#include <backends/imgui_impl_opengl3.h>
#include <cmath>
#include <fstream>
#include <imgui_internal.h>
#include <iterator>
#include <string_view>

namespace lab {

namespace {

// Debian's fonts-dejavu-core; without it ImGui's own font draws the letters, and question marks for Greek
// ones.
constexpr const char* fontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

ImU32 rgb(unsigned code, unsigned alpha = 255) {
    return IM_COL32((code >> 16) & 255, (code >> 8) & 255, code & 255, alpha);
}

// The characters of `text` that need no baking are those which `known` has; says whether there was another
// one.
bool add(std::string_view text, std::vector<bool>& known) {
    bool added = false;
    for (const char *at = text.data(), *end = at + text.size(); at < end;) {
        unsigned code = static_cast<unsigned char>(*at);
        if (code < 0x80) {
            ++at;
            continue;
        }
        at += ImTextCharFromUtf8(&code, at, end);
        if (code >= 0x80 && code < known.size() && !known[code])
            known[code] = added = true;
    }
    return added;
}

template <class Visit>
void eachText(const Panel& panel, const Visit& visit) {
    for (const PanelSymbol& symbol : panel.equation)
        for (const std::string* text : {&symbol.text, &symbol.key, &symbol.slide, &symbol.help})
            visit(*text);
    visit(panel.slide);
    for (const std::vector<Line>* lines : {&panel.message, &panel.probe, &panel.rows})
        for (const Line& line : *lines)
            for (const Span& span : line)
                visit(span.text);
    for (const PanelCurve& curve : panel.curves)
        for (const std::string* text : {&curve.title, &curve.across, &curve.dotText})
            visit(*text);
    for (const WidgetGroup& group : panel.groups) {
        visit(group.title);
        for (const Widget& widget : group.widgets) {
            for (const std::string* text : {&widget.label, &widget.value, &widget.key, &widget.help})
                visit(*text);
            for (const auto& choice : widget.choices)
                visit(choice[1]);
        }
    }
    for (const PanelTag& tag : panel.tags)
        visit(tag.text);
    for (const PanelHandle& handle : panel.handles)
        visit(handle.help);
    if (panel.divider)
        for (const std::string* text : {&panel.divider->left, &panel.divider->right})
            visit(*text);
    if (panel.legend) {
        visit(panel.legend->title);
        for (const PanelLegend::Entry& entry : panel.legend->entries)
            visit(entry.text);
    }
}

std::vector<ImWchar> ranges(const std::vector<bool>& known) {
    std::vector<ImWchar> pairs;
    for (std::size_t i = 0x20; i < known.size(); ++i) {
        if (!known[i])
            continue;
        pairs.push_back(static_cast<ImWchar>(i));
        while (i + 1 < known.size() && known[i + 1])
            ++i;
        pairs.push_back(static_cast<ImWchar>(i));
    }
    pairs.push_back(0);
    return pairs;
}

}  // namespace

bool Look::learn(const Panel& panel) {
    bool added = false;
    eachText(panel, [this, &added](const std::string& text) { added |= add(text, text_); });
    for (const PanelSymbol& symbol : panel.equation)
        added |= add(symbol.text, symbols_);
    return added;
}

void Look::prepare(const Panel& panel, float contentScale, float density) {
    if (file_.empty()) {
        std::ifstream stream(fontFile, std::ios::binary);
        file_.assign(std::istreambuf_iterator<char>(stream), {});
        std::fill(text_.begin() + 0x20, text_.begin() + 0x100, true);
        std::fill(symbols_.begin() + 0x20, symbols_.begin() + 0x7F, true);
    }
    const bool newLetters = learn(panel);
    const float pixels = std::round(static_cast<float>(std::clamp(panel.style.fontSize, 16, 48)) *
                                    std::clamp(contentScale, 0.5F, 4.0F));
    const bool sameSize = pixels == pixels_ && density == density_;
    if (newLetters || !sameSize)
        bake(pixels, density);
    if (sameSize && panel.style.light == light_)
        return;
    light_ = panel.style.light;
    applyStyle();
}

void Look::bake(float pixels, float density) {
    const bool first = pixels_ <= 0;
    pixels_ = pixels;
    density_ = density;
    em_ = pixels / density;
    textRanges_ = ranges(text_);
    symbolRanges_ = ranges(symbols_);
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    for (const float share : {1.0F, smallShare, equationShare}) {
        ImFontConfig config;
        config.SizePixels = std::round(pixels * share);
        config.OversampleH = config.SizePixels < 24 ? 2 : 1;  // what is large needs no more
        config.FontDataOwnedByAtlas = false;
        const std::vector<ImWchar>& letters = share == equationShare ? symbolRanges_ : textRanges_;
        if (file_.empty())
            atlas.AddFontDefault(&config);
        else
            atlas.AddFontFromMemoryTTF(file_.data(), static_cast<int>(file_.size()), config.SizePixels,
                                       &config, letters.data());
    }
    if (first) {
        ImGui_ImplOpenGL3_NewFrame();  // which makes shaders, buffers and the texture
    } else {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    atlas.ClearTexData();  // the driver has it
    ImGui::GetIO().FontGlobalScale = 1 / density;
}

ImFont* Look::font(float size) const {
    ImFont* best = nullptr;
    for (ImFont* font : ImGui::GetIO().Fonts->Fonts) {
        const bool enough = font->FontSize >= size * density_ - 0.75F;
        if (best == nullptr ||
            (enough && (best->FontSize < size * density_ - 0.75F || font->FontSize < best->FontSize)) ||
            (!enough && best->FontSize < font->FontSize))
            best = font;
    }
    return best;
}

void Look::applyStyle() const {
    ImGuiStyle style;
    if (light_)
        ImGui::StyleColorsLight(&style);
    else
        ImGui::StyleColorsDark(&style);
    const float u = em_ / 16;
    style.WindowPadding = {8 * u, 6 * u};
    style.FramePadding = {5 * u, 2 * u};
    style.ItemSpacing = {6 * u, 4 * u};
    style.ItemInnerSpacing = {5 * u, 3 * u};
    style.IndentSpacing = 8 * u;
    style.ScrollbarSize = 11 * u;
    style.GrabMinSize = 11 * u;
    style.WindowRounding = style.FrameRounding = style.PopupRounding = style.GrabRounding = 3 * u;
    style.WindowMinSize = {1, 1};
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 1;  // so that a box to tick is seen on any projector
    const auto set = [&style](int slot, ImU32 value) {
        style.Colors[slot] = ImGui::ColorConvertU32ToFloat4(value);
    };
    const bool l = light_;
    set(ImGuiCol_Text, color(Tone::plain));
    set(ImGuiCol_WindowBg, box());
    set(ImGuiCol_PopupBg, l ? rgb(0xFFFFFF, 250) : rgb(0x1B1E24, 250));
    set(ImGuiCol_Border, l ? rgb(0x6E7680) : rgb(0x7C8694));
    set(ImGuiCol_FrameBg, l ? rgb(0xE4E8ED) : rgb(0x2A303A));
    set(ImGuiCol_FrameBgHovered, l ? rgb(0xCFE0F2) : rgb(0x36485E));
    set(ImGuiCol_FrameBgActive, l ? rgb(0xB5D2F0) : rgb(0x3F5F83));
    set(ImGuiCol_CheckMark, l ? rgb(0x004A94) : rgb(0xFFD166));
    set(ImGuiCol_SliderGrab, l ? rgb(0x2F7CC4) : rgb(0x56B4E9));
    set(ImGuiCol_SliderGrabActive, l ? rgb(0x004A94) : rgb(0xFFD166));
    for (const int slot : {ImGuiCol_Button, ImGuiCol_Header})
        set(slot, l ? rgb(0xD3DEEA) : rgb(0x303C4C));
    for (const int slot : {ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
        set(slot, l ? rgb(0xB9D3EE) : rgb(0x3E5878));
    for (const int slot : {ImGuiCol_ButtonActive, ImGuiCol_HeaderActive})
        set(slot, l ? rgb(0x93BCE6) : rgb(0x4C739F));
    set(ImGuiCol_ScrollbarBg, rgb(0, 0));
    ImGui::GetStyle() = style;
}

ImU32 Look::color(Tone tone) const {
    switch (tone) {
    case Tone::active:
        return light_ ? rgb(0x004A94) : rgb(0xFFD166);
    case Tone::idle:
        return light_ ? rgb(0x6A6A6A) : rgb(0xA0A4AA);
    case Tone::off:
        return light_ ? rgb(0x707070) : rgb(0x989CA4);
    case Tone::title:
        return light_ ? rgb(0x6B3A00) : rgb(0x8CCBF2);
    case Tone::wrong:
        return light_ ? rgb(0xB03000) : rgb(0xFF9966);
    case Tone::plain:
        break;
    }
    return light_ ? rgb(0x141414) : rgb(0xF0F0F0);
}

ImU32 Look::color(Ink ink) const {
    switch (ink) {
    case Ink::faint:
        return light_ ? rgb(0x5A5A5A) : rgb(0xB4B8BE);
    case Ink::normal:
        return light_ ? rgb(0x0063A0) : rgb(0x56B4E9);
    case Ink::light:
        return light_ ? rgb(0x7A6400) : rgb(0xF0E442);
    case Ink::reflected:
        return light_ ? rgb(0xB84A00) : rgb(0xF2A516);
    case Ink::view:
        return light_ ? rgb(0x00694C) : rgb(0x2FCB9B);
    case Ink::chosen:
        return light_ ? rgb(0x9C3274) : rgb(0xF29CCB);
    case Ink::text:
        break;
    }
    return color(Tone::plain);
}

ImU32 Look::box() const { return light_ ? rgb(0xFAFAF8, 225) : rgb(0x14171C, 225); }

ImU32 Look::outline() const { return light_ ? rgb(0xFFFFFF, 235) : rgb(0x0A0C10, 235); }

ImU32 Look::chip(bool hovered) const {
    if (light_)
        return rgb(0x2F7CC4, hovered ? 90 : 36);
    return rgb(0xFFD166, hovered ? 90 : 34);
}

}  // namespace lab
