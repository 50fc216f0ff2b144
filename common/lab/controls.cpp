// Steps of round numbers, and --set.
// SPDX-License-Identifier: MIT
#include "lab/controls.hpp"

#include "lab/number.hpp"
#include "three/geometry_builder.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace lab {

double Slider::step() const {
    const double hundredth = (max - min) / 100;
    const double power = std::pow(10, std::floor(std::log10(hundredth)));
    const double digit = hundredth / power;
    return power * (digit < 1.5 ? 1 : digit < 3.2 ? 2 : digit < 7 ? 5 : 10);
}

const double& Controls::add(const std::string& name, double start, double min, double max,
                            lighting::Text label) {
    const auto taken = [&name](const Slider& slider) { return slider.name == name; };
    if (name.empty() || name.find('=') != std::string::npos ||
        std::any_of(sliders_.begin(), sliders_.end(), taken))
        throw std::invalid_argument("slider '" + name + "': expected a new name without '='; choose another");
    if (!(min < max && min <= start && start <= max && std::isfinite(max - min)))
        throw std::invalid_argument(
            "slider '" + name + "': expected min <= start <= max and min < max, found " +
            THREE::numberText(min) + ", " + THREE::numberText(start) + ", " + THREE::numberText(max));
    return sliders_.emplace_back(Slider{name, start, min, max, label, start}).value;
}

std::string Controls::set(std::span<const std::string> assignments) {
    std::string known;
    for (const Slider& slider : sliders_)
        known += (known.empty() ? "" : ", ") + slider.name + " (" + THREE::numberText(slider.min) + " to " +
                 THREE::numberText(slider.max) + ")";
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        const std::string name = assignment.substr(0, equals);
        const auto slider = std::find_if(sliders_.begin(), sliders_.end(),
                                         [&name](const Slider& s) { return s.name == name; });
        const std::optional<double> value = equals == std::string::npos
                                                ? std::nullopt
                                                : quantity(std::string_view(assignment).substr(equals + 1));
        if (sliders_.empty())
            return "--set: found '" + assignment + "', but this program has no sliders; leave --set out";
        if (slider == sliders_.end() || !value || !(*value >= slider->min && *value <= slider->max))
            return "--set: expected NAME=VALUE with one of " + known + ", found '" + assignment + "'";
        slider->start = slider->value = *value;
    }
    return {};
}

void Controls::forgetSet() {
    for (Slider& slider : sliders_)
        slider.start = slider.value = slider.own;
}

void Controls::reset() {
    for (Slider& slider : sliders_)
        slider.value = slider.start;
}

std::string Controls::text() const {
    std::string text;
    for (const Slider& slider : sliders_)
        text += (text.empty() ? "" : " ") + slider.name + "=" + THREE::numberText(slider.value);
    return text;
}

std::string valueText(double value) {
    const bool whole = value == std::round(value) && std::abs(value) < 1e15;
    std::array<char, 64> digits{};
    const auto end = whole ? std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0,
                                           std::chars_format::fixed)
                           : std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                           std::chars_format::general, 4);
    return {digits.data(), end.ptr};
}

}  // namespace lab
