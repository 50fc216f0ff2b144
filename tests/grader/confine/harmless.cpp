// Takes out of a text what could act on a terminal or a page.
// SPDX-License-Identifier: MIT
#include "grader/confine/confine.hpp"

namespace grader {

namespace {

struct Character {
    char32_t code = 0;
    std::size_t size = 0;  ///< 0: the byte begins no character
};

Character decode(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at);
    const std::size_t size = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
    if (size < 2) {
        return {first, size};
    }
    char32_t code = first & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if (at + i >= text.size() || (byte(at + i) & 0xC0U) != 0x80) {
            return {};
        }
        code = code << 6 | (byte(at + i) & 0x3FU);
    }
    const char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < smallest[size] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) {
        return {};
    }
    return {code, size};
}

bool isHarmless(char32_t code) {
    const bool control = (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7F && code < 0xA0);
    const bool direction = code == 0x061C || (code >= 0x200B && code <= 0x200F) ||
                           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) ||
                           code == 0xFEFF;
    const bool none = (code & 0xFFFE) == 0xFFFE || (code >= 0xFDD0 && code <= 0xFDEF) ||
                      (code >= 0xFFF9 && code <= 0xFFFB) || (code >= 0xE0000 && code <= 0xE007F);
    return !control && !direction && !none;
}

}  // namespace

std::string harmless(const std::string& text) {
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = decode(text, at);
        if (character.size > 0 && isHarmless(character.code)) {
            clean.append(text, at, character.size);
        } else {
            clean += "\xEF\xBF\xBD";
        }
        at += character.size > 0 ? character.size : 1;
    }
    return clean;
}

}  // namespace grader
