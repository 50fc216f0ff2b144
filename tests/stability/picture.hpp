// The table as a picture in colours.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/table.hpp"

namespace stability {

/// Writes a PNG. Throws std::runtime_error with the path and the reason.
void drawTable(const std::vector<Line>& lines, const std::string& path);

}  // namespace stability
