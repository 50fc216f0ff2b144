// Decodes UTF-8 by hand: what is let through is decided code point by code point.
// SPDX-License-Identifier: MIT
#include "grader/report/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace grader {

namespace {

constexpr const char* replacement = "\xEF\xBF\xBD";  // U+FFFD

// A code point and how many bytes it takes; 0 bytes: they are no UTF-8.
struct Decoded {
    char32_t code = 0;
    std::size_t bytes = 0;
};

Decoded decode(std::string_view text) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const unsigned char first = byte(0);
    if (first < 0x80)
        return {first, 1};
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length)
        return {};
    char32_t code = first & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80)
            return {};
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < least[length] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF))
        return {};
    return {code, length};
}

bool endsLine(char32_t code) {
    return (code >= 0x0A && code <= 0x0D) || code == 0x85 || code == 0x2028 || code == 0x2029;
}

bool isHarmful(char32_t code) {
    const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    // Marks of direction, and what takes no room on the screen: names that look alike must be alike.
    const bool unseen = code == 0x061C || (code >= 0x200B && code <= 0x200F) ||
                        (code >= 0x202A && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) ||
                        code == 0xFEFF || (code >= 0xE0000 && code <= 0xE007F);
    const bool noCharacter = (code & 0xFFFEU) == 0xFFFE || (code >= 0xFDD0 && code <= 0xFDEF) ||
                             (code >= 0xFFF9 && code <= 0xFFFB);
    return control || unseen || noCharacter;
}

// How many bytes the escape sequence at the beginning of `text` takes, as in ESC [ 31 m.
std::size_t escapeLength(std::string_view text) {
    if (text.size() < 2 || text[1] != '[')
        return 1;
    const auto end = std::find_if(text.begin() + 2, text.end(), [](char c) { return c < 0x20 || c > 0x3F; });
    const auto length = static_cast<std::size_t>(end - text.begin());
    return end != text.end() && *end >= 0x40 && *end <= 0x7E ? length + 1 : length;
}

}  // namespace

std::string harmless(const std::string& text) {
    std::string result;
    result.reserve(text.size());
    for (std::string_view rest = text; !rest.empty();) {
        if (rest[0] == '\x1B') {
            rest.remove_prefix(escapeLength(rest));
            continue;
        }
        if (rest.starts_with("\r\n"))
            rest.remove_prefix(1);
        const Decoded decoded = decode(rest);
        const std::size_t length = std::max<std::size_t>(1, decoded.bytes);
        if (decoded.bytes > 0 && endsLine(decoded.code))
            result += '\n';
        else if (decoded.bytes == 0 || (isHarmful(decoded.code) && decoded.code != '\t'))
            result += replacement;
        else
            result.append(rest.substr(0, length));
        rest.remove_prefix(length);
    }
    return result;
}

std::string oneLine(const std::string& text) {
    std::string line = harmless(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::replace(line.begin(), line.end(), '\t', ' ');
    return line;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : harmless(text)) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

std::string shortened(const std::string& text, std::size_t bytes) {
    if (text.size() <= bytes)
        return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80)
        --bytes;
    return text.substr(0, bytes) + "...";
}

std::string number(double value) {
    if (!std::isfinite(value))
        return "?";
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

std::string points(double value) { return number(std::round(value * 100) / 100); }

std::string percent(double share) {
    if (!std::isfinite(share))
        return "?";
    const double rounded = std::round(100 * share);
    return number(share > 0 && share < 1 ? std::clamp(rounded, 1.0, 99.0) : rounded) + " %";
}

std::string base64(const std::string& bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    result.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = (group << 8U) | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            result += i <= count ? digits[(group >> (18U - 6U * i)) & 63U] : '=';
    }
    return result;
}

std::string wordFor(Language language, CheckStatus status) {
    switch (status) {
    case CheckStatus::pass:
        return say(language, "passed", "superato");
    case CheckStatus::partial:
        return say(language, "in part", "in parte");
    case CheckStatus::fail:
        return say(language, "not yet", "non ancora");
    case CheckStatus::skipped:
        break;
    }
    return say(language, "skipped", "saltato");
}

std::string regionName(Language language, const std::string& name) {
    struct Words {
        const char *name, *english, *italian;
    };
    constexpr Words known[] = {{"lit", "lit side", "lato illuminato"},
                               {"unlit", "unlit side", "lato in ombra"},
                               {"terminator", "border of light and shade", "confine tra luce e ombra"},
                               {"silhouette", "silhouette", "contorno"},
                               {"background", "background", "sfondo"}};
    for (const Words& words : known)
        if (name == words.name)
            return say(language, words.english, words.italian);
    return oneLine(name);
}

std::string colorText(const std::array<double, 3>& color) {
    std::string text;
    for (const double channel : color)
        text += (text.empty() ? "(" : ", ") + number(std::round(channel * 1e4) / 1e4);
    return text + ")";
}

}  // namespace grader
