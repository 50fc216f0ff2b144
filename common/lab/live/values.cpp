// Colours, numbers and vectors, to text and back.
// SPDX-License-Identifier: MIT
#include "lab/live/values.hpp"

#include "lab/failure.hpp"
#include "lab/number.hpp"
#include "three/geometry_builder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace lab {

namespace {

constexpr double largest = 1e36;

}  // namespace

std::string colorText(const THREE::Color& color) {
    const std::uint32_t hex = color.getHex();
    if (!(THREE::Color(hex) == color))
        return numbersText({color.r, color.g, color.b});
    std::string digits = color.getHexString();
    std::transform(digits.begin(), digits.end(), digits.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return "0x" + digits;
}

THREE::Color readColor(std::string_view text) {
    const auto wrong = [text] {
        return UsageError("expected a colour: 0xRRGGBB, #rrggbb, a CSS name, or r,g,b from 0 on (1 is full), "
                          "found '" +
                          std::string(text) + "'");
    };
    if (text.starts_with("0x") || text.starts_with("0X")) {
        std::uint32_t hex = 0;
        const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), hex, 16);
        if (error != std::errc() || end != text.data() + text.size() || text.size() != 8)
            throw wrong();
        return THREE::Color(hex);
    }
    if (text.find(',') != std::string_view::npos && text.find('(') == std::string_view::npos) {
        const std::vector<double> rgb = readNumbers(text, 3, 3);
        if (rgb[0] < 0 || rgb[1] < 0 || rgb[2] < 0)
            throw wrong();
        return {rgb[0], rgb[1], rgb[2]};
    }
    try {
        return THREE::Color(text);
    } catch (const std::invalid_argument&) {
        throw wrong();
    }
}

std::string vectorText(const THREE::Vector3& vector) { return numbersText({vector.x, vector.y, vector.z}); }

std::string numbersText(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : ",") + THREE::numberText(number + 0.0);
    return text;
}

std::vector<double> readNumbers(std::string_view text, std::size_t least, std::size_t most) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::optional<double> value = quantity(text.substr(begin, end - begin));
        if (!value || !(std::abs(*value) <= largest))
            throw UsageError("expected finite numbers with commas between them, found '" + std::string(text) +
                             "'");
        numbers.push_back(*value);
        begin = end + 1;
    }
    if (numbers.size() < least || numbers.size() > most)
        throw UsageError("expected " + std::to_string(least) +
                         (most > least ? " to " + std::to_string(most) : "") +
                         " numbers with commas between them, found " + std::to_string(numbers.size()) +
                         " in '" + std::string(text) + "'");
    return numbers;
}

THREE::Vector3 readVector(std::string_view text) {
    const std::vector<double> xyz = readNumbers(text, 3, 3);
    return {xyz[0], xyz[1], xyz[2]};
}

double readNumber(std::string_view text, double min, double max) {
    const std::optional<double> value = quantity(text);
    if (!value || !(*value >= min && *value <= max))
        throw UsageError("expected a number from " + THREE::numberText(min) + " to " +
                         THREE::numberText(max) + ", found '" + std::string(text) + "'");
    return *value;
}

}  // namespace lab
