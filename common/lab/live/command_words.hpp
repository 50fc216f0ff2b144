// Words of commands.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/failure.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace lab {

inline std::string joined(std::span<const std::string> words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

// One line whatever a message holds.
inline std::string oneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

inline void expectNothing(std::span<const std::string> words) {
    if (!words.empty())
        throw UsageError("expected nothing more, found '" + joined(words) + "'");
}

inline const std::string& expectOne(std::span<const std::string> words, const char* what) {
    if (words.size() != 1)
        throw UsageError(std::string("expected ") + what + ", found " +
                         (words.empty() ? "nothing" : "'" + joined(words) + "'"));
    return words[0];
}

}  // namespace lab
