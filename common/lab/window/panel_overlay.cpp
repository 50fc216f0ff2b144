// Draws over the picture, everything with an outline so that it is seen on any picture.
// SPDX-License-Identifier: MIT
#include "lab/window/panel_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lab {

namespace {

// Where a point is in the window; none where it is not a number. What is far out is cut off there.
std::optional<ImVec2> placeOf(const PanelPoint& point) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
        return std::nullopt;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    return ImVec2{window.x * static_cast<float>(std::clamp(point.x, -8.0, 9.0)),
                  window.y * static_cast<float>(std::clamp(point.y, -8.0, 9.0))};
}

float lengthOf(ImVec2 v) { return std::sqrt(v.x * v.x + v.y * v.y); }

// Halfway between the boxes above and below it.
ImVec2 gripOf(const PanelDivider& divider, const Free& free) {
    const double share = std::isfinite(divider.share) ? std::clamp(divider.share, 0.0, 1.0) : 0.5;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float x = window.x * static_cast<float>(share);
    const float top = x < free.left ? free.below : free.top;
    const float bottom = x < free.rowsRight ? free.rowsTop : x > free.legendLeft ? free.legendTop : window.y;
    return {x, (top + bottom) / 2};
}

// One pass draws the outline, the next one the line itself.
void drawStroke(ImDrawList& list, ImVec2 from, ImVec2 to, float width, bool arrow, ImU32 color,
                float outline) {
    const ImVec2 along{to.x - from.x, to.y - from.y};
    const float length = lengthOf(along);
    if (!arrow || length < 1)
        return list.AddLine(from, to, color, width + 2 * outline);
    const ImVec2 u{along.x / length, along.y / length};
    const float head = std::min(width * 4.5F, length), half = head * 0.42F;
    const ImVec2 neck{to.x - u.x * head, to.y - u.y * head};
    list.AddLine(from, {neck.x + u.x * 0.5F, neck.y + u.y * 0.5F}, color, width + 2 * outline);
    const float grown = half + outline * 1.4F;
    const ImVec2 base{neck.x - u.x * outline, neck.y - u.y * outline};
    list.AddTriangleFilled({to.x + u.x * outline * 2.2F, to.y + u.y * outline * 2.2F},
                           {base.x - u.y * grown, base.y + u.x * grown},
                           {base.x + u.y * grown, base.y - u.x * grown}, color);
}

void drawStrokes(ImDrawList& list, const Look& look, const std::vector<PanelStroke>& strokes) {
    const float unit = look.em() / 16;
    for (const PanelStroke& stroke : strokes) {
        const auto from = placeOf(stroke.from), to = placeOf(stroke.to);
        if (!from || !to || !(stroke.width > 0))
            continue;
        const float width = static_cast<float>(std::min(stroke.width, 64.0)) * unit;
        drawStroke(list, *from, *to, width, stroke.arrow, look.outline(), 1.5F * unit);
        drawStroke(list, *from, *to, width, stroke.arrow, look.color(stroke.ink), 0);
    }
}

// Text on a backdrop, wholly within the window where that is possible.
void drawWord(ImDrawList& list, const Look& look, ImVec2 at, ImU32 color, const std::string& text) {
    if (text.empty())
        return;
    const float pad = look.em() * 0.2F;
    const float wide = richWidth(look, look.em(), text);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    at.x = std::max(pad, std::min(at.x, window.x - wide - pad));
    at.y = std::max(pad, std::min(at.y, window.y - look.em() - pad));
    list.AddRectFilled({at.x - pad, at.y - pad / 2}, {at.x + wide + pad, at.y + look.em() * 1.1F + pad / 2},
                       look.box(), pad);
    drawRich(list, look, at, look.em(), color, text);
}

void drawDivider(ImDrawList& list, Brush& brush, const PanelDivider& divider, const Free& free, bool held) {
    const Look& look = brush.look;
    const float unit = look.em() / 16, pad = look.gap();
    const ImVec2 grip = gripOf(divider, free);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    list.AddLine({grip.x, free.top}, {grip.x, window.y}, look.outline(), 5 * unit);
    list.AddLine({grip.x, free.top}, {grip.x, window.y}, look.color(Tone::plain), 2 * unit);
    const float radius = look.em() * (held ? 0.7F : 0.6F);
    list.AddCircleFilled(grip, radius + 1.5F * unit, look.outline());
    list.AddCircleFilled(grip, radius, look.color(Tone::plain));
    for (const float side : {-1.0F, 1.0F}) {
        const float near = grip.x + side * radius * 0.22F, far = grip.x + side * radius * 0.65F;
        list.AddTriangleFilled({far, grip.y}, {near, grip.y - radius * 0.4F}, {near, grip.y + radius * 0.4F},
                               look.outline());
    }
    const float leftWide = richWidth(look, look.em(), divider.left);
    const float leftX = grip.x - pad - leftWide;
    const bool underBox = leftX < free.left;
    drawWord(list, look, {leftX, (underBox ? free.below : free.top) + pad}, look.color(Tone::plain),
             divider.left);
    const bool rightUnderBox = grip.x + pad < free.left;
    drawWord(list, look, {grip.x + pad, (rightUnderBox ? free.below : free.top) + pad},
             look.color(Tone::plain), divider.right);
    brush.places.push_back({"divider", grip});
}

void drawHandle(ImDrawList& list, const Look& look, const PanelHandle& handle, ImVec2 at, bool held) {
    const float radius = look.em() * (held ? 0.48F : 0.4F), unit = look.em() / 16;
    list.AddCircleFilled(at, radius + 2 * unit, look.outline());
    list.AddCircleFilled(at, radius, look.color(handle.chosen ? Ink::chosen : Ink::light));
    list.AddCircleFilled(at, radius * 0.35F, look.outline());
    if (!handle.chosen)
        return;
    list.AddCircle(at, radius + 4.5F * unit, look.outline(), 0, 5 * unit);
    list.AddCircle(at, radius + 4.5F * unit, look.color(Ink::chosen), 0, 2.5F * unit);
}

}  // namespace

Grab grabAt(const Look& look, const Panel& panel, const Free& free, ImVec2 mouse) {
    Grab grab;
    float nearest = look.em() * 0.6F;
    for (const PanelHandle& handle : panel.handles) {
        const auto at = placeOf(handle.at);
        const ImVec2 offset = at ? ImVec2{at->x - mouse.x, at->y - mouse.y} : ImVec2{0, 0};
        if (!at || lengthOf(offset) > nearest)
            continue;
        nearest = lengthOf(offset);
        grab = {Grab::Kind::handle, handle.name, offset};
    }
    if (grab.kind != Grab::Kind::nothing || !panel.divider)
        return grab;
    const ImVec2 grip = gripOf(*panel.divider, free);
    const ImVec2 offset{grip.x - mouse.x, grip.y - mouse.y};
    if (lengthOf(offset) <= look.em() * 0.75F || std::abs(offset.x) <= look.em() * 0.2F)
        grab = {Grab::Kind::divider, {}, offset};
    return grab;
}

void drawOverlay(Brush& brush, const Panel& panel, const Free& free, const Grab& grab) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Look& look = brush.look;
    drawStrokes(list, look, panel.strokes);
    for (const PanelTag& tag : panel.tags)
        if (const auto at = placeOf(tag.at))
            drawWord(list, look, {at->x, at->y - look.em() / 2}, look.color(tag.ink), tag.text);
    if (panel.divider)
        drawDivider(list, brush, *panel.divider, free, grab.kind == Grab::Kind::divider);
    for (const PanelHandle& handle : panel.handles)
        if (const auto at = placeOf(handle.at)) {
            const bool held = grab.kind == Grab::Kind::handle && grab.name == handle.name;
            drawHandle(list, look, handle, *at, held);
            brush.places.push_back({"handle " + handle.name, *at});
            tooltip(look, handle.help, held);
        }
    if (grab.kind == Grab::Kind::divider)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    else if (grab.kind == Grab::Kind::handle)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace lab
