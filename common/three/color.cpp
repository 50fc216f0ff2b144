// Color: reading CSS notations, and colours to and from hexadecimal.
// SPDX-License-Identifier: MIT
#include "three/color.hpp"

#include "three/color_names.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace THREE {

namespace {

/// A colour as a file may hold it is of any length; a message is not.
constexpr std::size_t longestQuote = 60;

[[noreturn]] void refuse(std::string_view css, std::string_view why) {
    std::string text = "colour \"" + std::string(css.substr(0, longestQuote));
    text += css.size() > longestQuote ? "...\"" : "\"";
    text += ": " + std::string(why);
    text +=
        "; expected a CSS name such as \"orange\", or one of \"#rgb\", \"#rrggbb\", \"rgb(255, 136, 85)\", "
        "\"rgb(100%, 53%, 33%)\", \"hsl(20, 100%, 67%)\"";
    throw std::invalid_argument(text);
}

// std::tolower depends on the locale: in some, 'I' has no 'i'.
std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view spaces = " \t\r\n\f";
    const std::size_t first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

std::vector<std::string_view> splitAtCommas(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
        parts.push_back(trimmed(text.substr(0, comma)));
        text.remove_prefix(comma + 1);
    }
    parts.push_back(trimmed(text));
    return parts;
}

/// Digits with at most one point between or before them; no sign, no exponent, no "nan".
std::optional<double> parseNumber(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789.") != std::string_view::npos || text.back() == '.')
        return std::nullopt;
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

bool isPercentage(std::string_view text) { return !text.empty() && text.back() == '%'; }

/// One argument as 0..1, where `full` stands for 1; beyond it a colour would not be what was meant.
double parseShare(std::string_view css, std::string_view argument, double full) {
    const bool percent = isPercentage(argument);
    const auto value = parseNumber(percent ? argument.substr(0, argument.size() - 1) : argument);
    const std::string found = "found \"" + std::string(argument.substr(0, longestQuote)) + "\"";
    if (!value)
        refuse(css, found + " where a number without sign should be");
    const double most = percent ? 100 : full;
    if (*value > most)
        refuse(css, found + ", more than " + (percent ? "100%" : "255"));
    return *value / most;
}

std::optional<std::uint32_t> parseHex(std::string_view digits) {
    if (digits.size() != 3 && digits.size() != 6)
        return std::nullopt;
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (error != std::errc{} || end != digits.data() + digits.size())
        return std::nullopt;
    if (digits.size() == 6)
        return value;
    // Each digit twice: 0xF85 means 0xFF8855.
    return ((value & 0xF00) << 8 | (value & 0xF0) << 4 | (value & 0xF)) * 0x11;
}

std::optional<std::uint32_t> findName(std::string_view name) {
    const auto found = std::lower_bound(
        namedColors.begin(), namedColors.end(), name,
        [](const NamedColor& color, std::string_view wanted) { return color.name < wanted; });
    if (found == namedColors.end() || found->name != name)
        return std::nullopt;
    return found->hex;
}

Color parseFunction(std::string_view css, std::string_view lower) {
    const bool isRgb = lower.starts_with("rgb(");
    if (!isRgb && !lower.starts_with("hsl("))
        refuse(css, "no such notation");
    if (lower.find(')') != lower.size() - 1)
        refuse(css, "the text must end with its first \")\"");
    const auto arguments = splitAtCommas(lower.substr(4, lower.size() - 5));
    if (arguments.size() != 3)
        refuse(css, "found " + std::to_string(arguments.size()) + " values instead of 3");
    const bool percent = isPercentage(arguments[1]);
    if (isPercentage(arguments[2]) != percent || isPercentage(arguments[0]) != (isRgb && percent) ||
        (!isRgb && !percent))
        refuse(css, "found \"%\" after the wrong values");
    if (isRgb)
        return {parseShare(css, arguments[0], 255), parseShare(css, arguments[1], 255),
                parseShare(css, arguments[2], 255)};
    const auto degrees = parseNumber(arguments[0]);
    if (!degrees)
        refuse(css, "the hue is not a number of degrees without sign");
    return Color().setHSL(*degrees / 360, parseShare(css, arguments[1], 1), parseShare(css, arguments[2], 1));
}

/// One of three channels of a pure hue: a ramp up, a plateau, a ramp down, all over one turn.
double hueChannel(double low, double high, double turn) {
    turn -= std::floor(turn);
    if (turn < 1.0 / 6)
        return low + (high - low) * 6 * turn;
    if (turn < 1.0 / 2)
        return high;
    if (turn < 2.0 / 3)
        return low + (high - low) * 6 * (2.0 / 3 - turn);
    return low;
}

// The first comparison is false for NaN too, which no cast may see.
std::uint32_t toCode(double channel) {
    if (!(channel > 0))
        return 0;
    return channel < 1 ? static_cast<std::uint32_t>(std::floor(channel * 255 + 0.5)) : 255;
}

}  // namespace

Color& Color::set(std::uint32_t hex) {
    return set((hex >> 16 & 0xFF) / 255.0, (hex >> 8 & 0xFF) / 255.0, (hex & 0xFF) / 255.0);
}

Color& Color::set(std::string_view css) {
    const std::string lower = lowerCase(css);
    if (lower.starts_with('#')) {
        const auto hex = parseHex(std::string_view(lower).substr(1));
        if (!hex)
            refuse(css, "\"#\" takes 3 or 6 hexadecimal digits");
        return set(*hex);
    }
    if (lower.find('(') != std::string::npos)
        return *this = parseFunction(css, lower);
    const auto hex = findName(lower);
    if (!hex)
        refuse(css, "not one of the 148 CSS colour names");
    return set(*hex);
}

Color& Color::set(double red, double green, double blue) {
    r = red;
    g = green;
    b = blue;
    return *this;
}

Color& Color::setHSL(double hue, double saturation, double lightness) {
    // Not a number stays so in every channel, for validate() to refuse; comparisons below would hide it.
    if (!std::isfinite(hue) || std::isnan(saturation) || std::isnan(lightness))
        return setScalar(std::numeric_limits<double>::quiet_NaN());
    const double s = std::clamp(saturation, 0.0, 1.0);
    const double l = std::clamp(lightness, 0.0, 1.0);
    const double high = l <= 0.5 ? l * (1 + s) : l + s - l * s;
    const double low = 2 * l - high;
    const double turn = hue - std::floor(hue);
    return set(hueChannel(low, high, turn + 1.0 / 3), hueChannel(low, high, turn),
               hueChannel(low, high, turn - 1.0 / 3));
}

std::uint32_t Color::getHex() const { return toCode(r) << 16 | toCode(g) << 8 | toCode(b); }

std::string Color::getHexString() const {
    constexpr std::string_view digits = "0123456789abcdef";
    const std::uint32_t hex = getHex();
    std::string text;
    for (int shift = 20; shift >= 0; shift -= 4)
        text += digits[hex >> shift & 0xF];
    return text;
}

Color& Color::add(const Color& other) { return set(r + other.r, g + other.g, b + other.b); }

Color& Color::multiply(const Color& other) { return set(r * other.r, g * other.g, b * other.b); }

Color& Color::multiplyScalar(double factor) { return set(r * factor, g * factor, b * factor); }

Color& Color::lerp(const Color& other, double t) {
    return set(std::lerp(r, other.r, t), std::lerp(g, other.g, t), std::lerp(b, other.b, t));
}

}  // namespace THREE
