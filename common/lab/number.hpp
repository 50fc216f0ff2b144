// Numbers as people type them: for options and --set.
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace lab {

/// All of `text` as a number, or nothing.
template <class T>
std::optional<T> number(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// The same for a quantity, which may have a + before it; NaN and infinity are read as such.
inline std::optional<double> quantity(std::string_view text) {
    return number<double>(text.starts_with('+') ? text.substr(1) : text);
}

}  // namespace lab
