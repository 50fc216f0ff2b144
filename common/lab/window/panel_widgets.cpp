// Each kind of widget by the one of Dear ImGui that suits it.
// SPDX-License-Identifier: MIT
#include "lab/window/panel_widgets.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <imgui_internal.h>

namespace lab {

std::string numbersText(const double* numbers, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        char digits[32];
        const auto [end, error] = std::to_chars(digits, digits + sizeof digits, numbers[i]);
        text += (i > 0 ? "," : "") + std::string(digits, end);
    }
    return text;
}

std::string colorText(const std::array<double, 3>& color) {
    unsigned code = 0;
    for (const double component : color) {
        const double eight = std::round(std::clamp(component, 0.0, 1.0) * 255);
        if (!(eight / 255 == component))  // NaN is none either
            return numbersText(color.data(), color.size());
        code = code << 8 | static_cast<unsigned>(eight);
    }
    char text[16];
    std::snprintf(text, sizeof text, "0x%06X", code);
    return text;
}

namespace {

// ImGui wants ranges that it can halve, and numbers.
double sane(double number, double otherwise) {
    return std::isfinite(number) ? std::clamp(number, -1e300, 1e300) : otherwise;
}

// As many decimals as a step has, so that moving gives round numbers.
std::string formatFor(double step) {
    int decimals = 0;
    for (double unit = 1; decimals < 9 && step > 0 && std::abs(step / unit - std::round(step / unit)) > 1e-6;
         unit /= 10)
        ++decimals;
    return "%." + std::to_string(step > 0 ? decimals : 3) + "f";
}

bool toggle(Widget& widget) {
    bool on = widget.value == "on";
    if (!ImGui::Checkbox("##value", &on))
        return false;
    widget.value = on ? "on" : "off";
    return true;
}

// From here on ImGui's letters are as much smaller as `text` needs to fit into `room`, down to a limit.
void shrinkFor(const std::string& text, float room) {
    const float wide = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
    if (wide > room)
        ImGui::SetWindowFontScale(std::clamp(room / wide, 0.65F, 1.0F));
}

bool choice(Widget& widget) {
    const auto words = [&widget] {
        for (const auto& [name, text] : widget.choices)
            if (name == widget.value)
                return text;
        return widget.value;
    };
    bool changed = false;
    const std::string now = words();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float high = ImGui::GetFrameHeight();
    shrinkFor(now, ImGui::CalcItemWidth() - high - 2 * padding.x);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {padding.x, (high - ImGui::GetFontSize()) / 2});
    const bool opened = ImGui::BeginCombo("##value", now.c_str(), ImGuiComboFlags_HeightLarge);
    ImGui::PopStyleVar();
    if (!opened) {
        ImGui::SetWindowFontScale(1);
        return false;
    }
    for (const auto& [name, text] : widget.choices) {
        ImGui::PushID(name.c_str());
        if (ImGui::Selectable("##choice", name == widget.value) && name != widget.value) {
            widget.value = name;
            changed = true;
        }
        ImGui::SameLine(0, 0);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
        ImGui::PopID();
    }
    ImGui::EndCombo();
    ImGui::SetWindowFontScale(1);
    return changed;
}

bool number(Widget& widget) {
    const double low = sane(widget.min, 0);
    const double high = sane(widget.max, 1) > low ? sane(widget.max, 1) : low + 1;
    double value = sane(widget.numbers[0], low);
    if (!ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &low, &high,
                             formatFor(widget.step).c_str(), ImGuiSliderFlags_AlwaysClamp))
        return false;
    widget.numbers[0] = value;
    widget.value = numbersText(&value, 1);
    return true;
}

bool vector(Widget& widget) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i)
        values[i] = sane(widget.numbers[i], 0);
    const float speed = static_cast<float>(std::clamp(sane(widget.step, 0.01), 1e-9, 1e9));
    if (!ImGui::DragScalarN("##value", ImGuiDataType_Double, values.data(), 3, speed, nullptr, nullptr,
                            formatFor(widget.step).c_str()))
        return false;
    if (values == widget.numbers ||
        !std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
        return false;
    widget.numbers = values;
    widget.value = numbersText(values.data(), 3);
    return true;
}

bool color(Widget& widget) {
    float shown[3], before[3];
    for (std::size_t i = 0; i < 3; ++i)
        shown[i] = before[i] = static_cast<float>(sane(widget.numbers[i], 0));
    if (!ImGui::ColorEdit3("##value", shown))
        return false;
    std::array<double, 3> numbers = widget.numbers;
    for (std::size_t i = 0; i < 3; ++i)
        if (shown[i] != before[i])  // what is not moved keeps its number
            numbers[i] = std::round(std::clamp(static_cast<double>(shown[i]), 0.0, 1.0) * 255) / 255;
    if (numbers == widget.numbers)
        return false;
    widget.numbers = numbers;
    widget.value = colorText(numbers);
    return true;
}

bool action(const Look& look, const Widget& widget) {
    const std::string text = widget.key.empty() ? widget.label : widget.label + " [" + widget.key + "]";
    const float room = ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x;
    shrinkFor(text, room);
    const ImVec2 size{-1, look.em() + 2 * ImGui::GetStyle().FramePadding.y};
    const bool pressed = ImGui::Button((text + "###value").c_str(), size);
    ImGui::SetWindowFontScale(1);
    return pressed;
}

Line labelOf(const Widget& widget) {
    Line line{{widget.label, widget.tone}};
    if (!widget.key.empty())
        line.push_back({"\u00A0[" + widget.key + "]", Tone::idle});
    return line;
}

bool value(Widget& widget) {
    switch (widget.kind) {
    case WidgetKind::choice:
        return choice(widget);
    case WidgetKind::number:
        return number(widget);
    case WidgetKind::vector:
        return vector(widget);
    case WidgetKind::color:
        return color(widget);
    case WidgetKind::toggle:
    case WidgetKind::action:
        break;
    }
    return toggle(widget);
}

// The label, then its control on the same line where both have room, else below it.
bool labelled(const Look& look, Widget& widget, ImVec2& centre) {
    const Line label = labelOf(widget);
    const float room = ImGui::GetContentRegionAvail().x;
    float wide = 0;
    for (const Span& span : label)
        wide += richWidth(look, look.em(), span.text);
    const bool simple = widget.kind == WidgetKind::number || widget.kind == WidgetKind::choice;
    const float control = room * (simple ? 0.5F : 0.68F);
    float words = 0;  // of the longest choice, so that nothing jumps when another one is made
    for (const auto& choice : widget.choices)
        words = std::max(words, ImGui::CalcTextSize(choice[1].c_str()).x + 2 * look.em());
    const float left = ImGui::GetCursorPosX();
    const bool beside = wide + look.gap() <= room - control && words <= control;
    if (beside)
        ImGui::AlignTextToFramePadding();
    const ImVec2 at = ImGui::GetCursorPos();
    if (beside)
        ImGui::SetCursorPosY(at.y + ImGui::GetStyle().FramePadding.y);
    flow(look, {label}, room);
    if (beside)
        ImGui::SetCursorPos({left + room - control, at.y});
    ImGui::SetNextItemWidth(beside ? control : room);
    const bool changed = value(widget);
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    centre = {(from.x + to.x) / 2, (from.y + to.y) / 2};
    return changed;
}

// A box to tick; its words tick it too.
bool ticked(const Look& look, Widget& widget, ImVec2& centre) {
    bool changed = toggle(widget);
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    centre = {(from.x + to.x) / 2, (from.y + to.y) / 2};
    ImGui::SameLine();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + ImGui::GetStyle().FramePadding.y);
    flow(look, {labelOf(widget)}, ImGui::GetContentRegionAvail().x);
    if (!changed && ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        widget.value = widget.value == "on" ? "off" : "on";
        changed = true;
    }
    return changed;
}

// What is typed counts when it is complete: 2 and 2.7 are not meant where 2.75 is.
void tell(Brush& brush, const Widget& widget) {
    if (widget.kind == WidgetKind::action)
        brush.said.push_back(widget.command);
    else if (ImGui::GetIO().WantTextInput)
        brush.typed = widget.command + " " + widget.value;
    else
        brush.said.push_back(widget.command + " " + widget.value);
}

void drawWidget(Brush& brush, Widget& widget) {
    const Look& look = brush.look;
    ImVec2 centre;
    bool changed = false;
    ImGui::BeginGroup();
    const bool dim = widget.tone == Tone::idle || widget.tone == Tone::off;
    ImGui::PushStyleColor(ImGuiCol_Text, look.color(dim ? widget.tone : Tone::plain));
    if (widget.kind == WidgetKind::toggle) {
        changed = ticked(look, widget, centre);
    } else if (widget.kind == WidgetKind::action) {
        changed = action(look, widget);
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        centre = {(from.x + to.x) / 2, (from.y + to.y) / 2};
    } else {
        changed = labelled(look, widget, centre);
    }
    ImGui::PopStyleColor();
    ImGui::EndGroup();
    tooltip(look, widget.help, ImGui::IsItemHovered() && !ImGui::IsAnyItemActive());
    if (changed)
        tell(brush, widget);
    if (ImGui::GetCurrentWindow()->ClipRect.Contains(centre))  // not scrolled out of sight
        brush.places.push_back({"widget " + widget.command, centre});
}

}  // namespace

void drawGroup(Brush& brush, WidgetGroup& group) {
    const std::string& id = group.id.empty() ? group.title : group.id;
    ImGui::PushID(id.c_str());
    const bool open =
        ImGui::CollapsingHeader((group.title + "###title").c_str(),
                                group.open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const ImVec2 centre{(from.x + to.x) / 2, (from.y + to.y) / 2};
    if (ImGui::GetCurrentWindow()->ClipRect.Contains(centre))
        brush.places.push_back({"group " + id, centre});
    int repeated = 0;
    for (std::size_t i = 0; open && i < group.widgets.size(); ++i) {
        repeated = i > 0 && group.widgets[i].command == group.widgets[i - 1].command ? repeated + 1 : 0;
        ImGui::PushID(repeated);
        ImGui::PushID(group.widgets[i].command.c_str());
        drawWidget(brush, group.widgets[i]);
        ImGui::PopID();
        ImGui::PopID();
    }
    ImGui::PopID();
}

}  // namespace lab
