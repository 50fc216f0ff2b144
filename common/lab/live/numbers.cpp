// Digits through std::to_chars, which knows no locale.
// SPDX-License-Identifier: MIT
#include "lab/live/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace lab {

namespace {

std::string digitsOf(double value, std::chars_format format, int precision) {
    std::array<char, 512> text{};  // 1e308 in full has 309 digits
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
    std::string result(text.data(), end.ptr);
    const bool isZero = result.find_first_of("123456789in") == std::string::npos;
    return isZero && result.starts_with('-') ? result.substr(1) : result;
}

bool whole(double value) { return value == std::round(value) && std::abs(value) < 1e6; }

std::string joined(const std::string& x, const std::string& y, const std::string& z) {
    return "(" + x + ", " + y + ", " + z + ")";
}

}  // namespace

std::string significant(double value, int digits) {
    return digitsOf(value, std::chars_format::general, std::clamp(digits, 1, 17));
}

std::string significant(const glm::dvec3& v, int digits) {
    return joined(significant(v.x, digits), significant(v.y, digits), significant(v.z, digits));
}

glm::dvec3 dusted(const glm::dvec3& v, double size) {
    const double least = 1e-12 * std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z), size});
    const auto part = [least](double x) { return std::abs(x) <= least ? 0 : x; };
    return {part(v.x), part(v.y), part(v.z)};
}

std::string shortText(const glm::dvec3& v) { return significant(dusted(v), 3); }

std::string shortText(double value) {
    if (whole(value))
        return digitsOf(value, std::chars_format::fixed, 0);
    const double size = std::abs(value);
    return size >= 0.095 && size < 1e4 ? digitsOf(value, std::chars_format::fixed, 2) : significant(value, 2);
}

std::string colorText(const glm::dvec3& v) {
    if (whole(v.x) && whole(v.y) && whole(v.z))
        return joined(shortText(v.x), shortText(v.y), shortText(v.z));
    const auto part = [](double x) {
        return std::abs(x) < 1e4 ? digitsOf(x, std::chars_format::fixed, 2) : significant(x, 3);
    };
    return joined(part(v.x), part(v.y), part(v.z));
}

}  // namespace lab
