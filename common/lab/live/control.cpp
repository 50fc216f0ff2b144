// One table for everything that can be moved.
// SPDX-License-Identifier: MIT
#include "lab/live/control.hpp"

#include "lab/failure.hpp"
#include "lab/live/values.hpp"
#include "lab/number.hpp"
#include "three/geometry_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lab {

namespace {

const std::vector<ControlChoice> onOff = {{"on", {"acceso", "on"}}, {"off", {"spento", "off"}}};

std::size_t indexOf(const std::vector<ControlChoice>& choices, const std::string& name) {
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&name](const ControlChoice& choice) { return choice.name == name; });
    if (found != choices.end())
        return static_cast<std::size_t>(found - choices.begin());
    std::string names;
    for (const ControlChoice& choice : choices)
        names += (names.empty() ? "" : ", ") + choice.name;
    throw UsageError("expected one of " + names + "; found '" + name + "'");
}

// What `work` gives; what it refuses is said with the control's name.
template <class Work>
auto named(const Control& control, const Work& work) {
    try {
        return work();
    } catch (const UsageError& error) {
        throw UsageError(control.name + ": " + error.what());
    }
}

}  // namespace

std::string Control::next(int steps) const {
    if (kind == WidgetKind::number) {
        const double count = readNumber(get(), -1e36, 1e36) / step;
        const double onGrid = (steps > 0 ? std::floor(count + 1e-6) : std::ceil(count - 1e-6)) + steps;
        // Divided by a whole number where steps are fractions, so that it is the double nearest to its digits.
        const double value = step < 1 ? onGrid / std::round(1 / step) : onGrid * step;
        return THREE::numberText(std::clamp(value, min, max));
    }
    if (choices.empty())
        throw UsageError("expected a value; only what has a list of values has a next one");
    const auto count = static_cast<int>(choices.size());
    const auto now = static_cast<int>(indexOf(choices, get()));
    return choices[static_cast<std::size_t>(((now + steps) % count + count) % count)].name;
}

Control& ControlTable::add(Control control) {
    if (control.kind == WidgetKind::toggle)
        control.choices = onOff;
    return controls_.emplace_back(std::move(control));
}

Control& ControlTable::addToggle(const std::string& name, const std::string& group, lighting::Text help,
                                 bool& value, bool own) {
    Control control{.name = name, .group = group, .help = help};
    control.get = [&value] { return std::string(value ? "on" : "off"); };
    control.set = [&value](const std::string& text) { value = indexOf(onOff, text) == 0; };
    control.moved = [&value, own] { return value != own; };
    control.reset = [&value, own] { value = own; };
    return add(std::move(control));
}

Control& ControlTable::addChoice(const std::string& name, const std::string& group, lighting::Text help,
                                 std::vector<ControlChoice> choices, std::function<int()> get,
                                 std::function<void(int)> set, int own) {
    Control control{.name = name,
                    .kind = WidgetKind::choice,
                    .group = group,
                    .help = help,
                    .choices = std::move(choices)};
    control.get = [choices = control.choices, get] { return choices[static_cast<std::size_t>(get())].name; };
    control.set = [choices = control.choices, set](const std::string& text) {
        set(static_cast<int>(indexOf(choices, text)));
    };
    control.moved = [get, own] { return get() != own; };
    control.reset = [set, own] { set(own); };
    return add(std::move(control));
}

Control& ControlTable::addNumber(const std::string& name, const std::string& group, lighting::Text help,
                                 double min, double max, double& value, double own) {
    Control control{
        .name = name, .kind = WidgetKind::number, .group = group, .help = help, .min = min, .max = max};
    control.get = [&value] { return THREE::numberText(value); };
    control.set = [&value, min, max](const std::string& text) { value = readNumber(text, min, max); };
    control.moved = [&value, own] { return value != own; };
    control.reset = [&value, own] { value = own; };
    return add(std::move(control));
}

Control* ControlTable::find(std::string_view name) {
    const auto found = std::find_if(controls_.begin(), controls_.end(),
                                    [name](const Control& control) { return control.name == name; });
    return found == controls_.end() ? nullptr : &*found;
}

void ControlTable::give(const Control& control, const std::string& value) {
    const Control now = control;  // giving it a value may make the table anew
    named(now, [&] { now.set(value); });
}

void ControlTable::set(const Control& control, const std::string& value) {
    const Control now = control;
    if (value == "reset")
        return now.reset();
    give(now, named(now, [&] {
             return value == "toggle" || value == "next" ? now.next()
                    : value == "previous"                ? now.next(-1)
                                                         : value;
         }));
}

State ControlTable::state() const {
    State state;
    for (const Control& control : controls_)
        if (control.saved && control.moved())
            state.emplace(control.name, control.get());
    return state;
}

void ControlTable::apply(const State& wanted) {
    // By number: a control that brings others with it makes the table anew, and stands before them.
    for (std::size_t i = 0; i < controls_.size(); ++i) {
        Control& control = controls_[i];
        if (!control.saved)
            continue;
        const auto value = wanted.find(control.name);
        if (value != wanted.end() && control.get() != value->second)
            give(control, value->second);
        else if (value == wanted.end() && control.moved())
            set(control, "reset");
    }
    for (const auto& [name, value] : wanted)
        if (const Control* control = find(name); control == nullptr || !control->saved)
            throw UsageError("unknown control '" + name + "'; this program has no such thing to set");
}

}  // namespace lab
