// The table of controls as JSON: what another front end, such as a web page, needs to draw it.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/control.hpp"

#include <string>

namespace lab {

/// One line: an array of {name, kind, group, help {it, en}, value, own, saved, min, max, step, choices [{name, it, en}], key}.
std::string controlsJson(const ControlTable& table);

}  // namespace lab
