// JSON text to a tree of values, with errors that name line and column.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace THREE {

/// Brackets deeper than this are refused; three.js needs two per level of its object tree.
inline constexpr int deepestJson = 1000;

/// Throws SceneError with line and column for anything that is not JSON (NaN, 1e999, invalid UTF-8, a NUL byte, a cut
/// file), for brackets deeper than 1000, and with its path for a key that an object has twice. A leading UTF-8 byte
/// order mark is skipped.
nlohmann::json parseJsonText(const std::string& text, const std::string& file);

}  // namespace THREE
