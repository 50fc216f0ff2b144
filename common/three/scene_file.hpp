// Scene files as text: reading them whole, and saying where in them something is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace THREE {

/// Files beyond this are refused: a scene of that size is a wrong file, and reading it would stall the machine.
inline constexpr std::size_t largestSceneFile = std::size_t{1} << 30;

/// The whole file. Throws SceneError if it is missing, no regular file, empty, unreadable or above 1 GiB.
std::string readSceneFile(const std::string& file);

/// "line 3, column 14" of a byte of `text`, both from 1; a byte past the end means the end.
std::string placeIn(std::string_view text, std::size_t byte);

/// `text` for a message: control characters and bytes outside ASCII as \xNN, cut to `most` characters.
std::string printable(std::string_view text, std::size_t most = 60);

}  // namespace THREE
