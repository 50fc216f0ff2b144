// Draws the table of the probe, the diagrams and the legend.
// SPDX-License-Identifier: MIT
#include "lab/window/panel_notes.hpp"

#include <algorithm>
#include <cmath>

namespace lab {

namespace {

// Letters of a table never become smaller than this, in lines of text.
constexpr float smallestShare = 0.75F;

std::vector<float> columnWidths(const Look& look, const std::vector<Line>& lines, float size) {
    std::vector<float> widths;
    for (const Line& line : lines) {
        if (line.size() < 2)
            continue;
        widths.resize(std::max(widths.size(), line.size()), 0.0F);
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], richWidth(look, size, line[i].text) + size);
    }
    return widths;
}

float sum(const std::vector<float>& widths) {
    float all = 0;
    for (const float width : widths)
        all += width;
    return all;
}

}  // namespace

void drawTable(const Look& look, const std::vector<Line>& lines, float width) {
    float size = look.em();
    if (const float wide = sum(columnWidths(look, lines, size)); wide > width)
        size = std::max(size * smallestShare, std::floor(size * width / wide));
    const std::vector<float> widths = columnWidths(look, lines, size);
    const bool fits = sum(widths) <= width;
    for (const Line& line : lines) {
        if (line.size() < 2 || !fits) {
            Line spaced;
            for (const Span& span : line) {
                spaced.push_back(span);
                spaced.push_back({"  "});
            }
            flow(look, {spaced}, width);
            continue;
        }
        const ImVec2 from = ImGui::GetCursorScreenPos();
        float x = from.x;
        for (std::size_t i = 0; i < line.size(); ++i) {
            drawSpan(*ImGui::GetWindowDrawList(), look, {x, from.y}, size, line[i]);
            x += widths[i];
        }
        ImGui::Dummy({x - from.x, size * 1.2F});
    }
}

namespace {

bool finite(const PanelPoint& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

// Where the dot's text hides the least of the line: around the dot, or in the corners.
template <class Place>
ImVec2 roomiest(const Look& look, const PanelCurve& curve, ImVec2 dot, ImVec2 corner, ImVec2 size,
                const Place& place) {
    const ImVec2 text{richWidth(look, look.em(), curve.dotText), look.em() * 1.2F};
    const ImVec2 end{corner.x + size.x - text.x, corner.y + size.y - text.y};
    const float off = look.em() * 0.4F;
    ImVec2 best{corner.x, corner.y};
    int fewest = -1;
    for (const float x : {dot.x + off, dot.x - off - text.x, end.x, corner.x + off})
        for (const float y : {dot.y - off - text.y, dot.y + off, corner.y, end.y}) {
            const ImVec2 at{std::max(corner.x, std::min(x, end.x)), std::max(corner.y, std::min(y, end.y))};
            int hidden = 0;
            const auto count = [&](ImVec2 p, int weight) {
                const bool over =
                    p.x > at.x - off && p.x < at.x + text.x + off && p.y > at.y && p.y < at.y + text.y;
                hidden += over ? weight : 0;
            };
            for (const PanelPoint& point : curve.line)
                if (finite(point))
                    count(place(point), 4);
            count(dot, 100);
            if (fewest < 0 || hidden < fewest) {
                fewest = hidden;
                best = at;
            }
        }
    return best;
}

// What of the diagram lies between the axes.
void drawInside(ImDrawList& list, const Look& look, const PanelCurve& curve, ImVec2 corner, ImVec2 size) {
    const auto place = [corner, size](const PanelPoint& point) {
        return ImVec2{corner.x + size.x * static_cast<float>(std::clamp(point.x, 0.0, 1.0)),
                      corner.y + size.y * static_cast<float>(1 - std::clamp(point.y, 0.0, 1.0))};
    };
    const float thin = look.em() / 12;
    for (std::size_t i = 1; i < curve.line.size(); ++i)
        if (finite(curve.line[i - 1]) && finite(curve.line[i]))
            list.AddLine(place(curve.line[i - 1]), place(curve.line[i]), look.color(Ink::normal), thin * 2);
    const ImU32 axes = look.color(Ink::faint);
    list.AddLine(corner, {corner.x, corner.y + size.y}, axes, thin);
    list.AddLine({corner.x, corner.y + size.y}, {corner.x + size.x, corner.y + size.y}, axes, thin);
    if (!finite(curve.dot))
        return;
    const ImVec2 dot = place(curve.dot);
    list.AddLine(dot, {dot.x, corner.y + size.y}, axes, thin);
    list.AddCircleFilled(dot, look.em() * 0.3F, look.outline());
    list.AddCircleFilled(dot, look.em() * 0.24F, look.color(Ink::reflected));
    const ImVec2 text = roomiest(look, curve, dot, corner, size, place);
    drawRich(list, look, text, look.em(), look.color(Ink::reflected), curve.dotText);
}

void drawCurve(const Look& look, const PanelCurve& curve, float width) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float em = look.em(), line = em * 1.2F;
    const ImVec2 size{width, em * 5};
    drawRich(list, look, from, em, look.color(Tone::title), curve.title);
    drawInside(list, look, curve, {from.x, from.y + line}, size);
    drawRich(list, look, {from.x, from.y + line + size.y + em * 0.15F}, look.small(), look.color(Tone::idle),
             curve.across);
    ImGui::Dummy({width, line + size.y + em * 0.15F + look.small() * 1.1F});
}

}  // namespace

void drawCurves(const Look& look, const std::vector<PanelCurve>& curves, float width) {
    const float gap = look.em();
    float used = 0;
    for (const PanelCurve& curve : curves) {
        const float texts = std::max({richWidth(look, look.em(), curve.title),
                                      richWidth(look, look.em(), curve.dotText) + gap,
                                      richWidth(look, look.small(), curve.across)});
        const float wide = std::max(1.0F, std::min(width, std::max(look.em() * 11, texts)));
        if (used > 0 && used + gap + wide <= width)
            ImGui::SameLine(0, gap);
        else
            used = 0;
        used += (used > 0 ? gap : 0) + wide;
        drawCurve(look, curve, wide);
    }
}

void drawLegend(const Look& look, const PanelLegend& legend, float width) {
    if (!legend.title.empty())
        flow(look, {{{legend.title, Tone::title}}}, width);
    const float em = look.em();
    for (const PanelLegend::Entry& entry : legend.entries) {
        const ImVec2 from = ImGui::GetCursorScreenPos();
        ImVec4 color{0, 0, 0, 1};
        for (std::size_t i = 0; i < 3; ++i)  // NaN is drawn as 0
            (&color.x)[i] = entry.color[i] > 0 ? static_cast<float>(std::min(entry.color[i], 1.0)) : 0.0F;
        const ImVec2 end{from.x + em * 1.4F, from.y + em};
        ImGui::GetWindowDrawList()->AddRectFilled(from, end, ImGui::ColorConvertFloat4ToU32(color));
        ImGui::GetWindowDrawList()->AddRect(from, end, look.color(Ink::faint));
        ImGui::SetCursorScreenPos({from.x + em * 1.9F, from.y});
        flow(look, {{{entry.text}}}, width - em * 1.9F);
    }
}

}  // namespace lab
