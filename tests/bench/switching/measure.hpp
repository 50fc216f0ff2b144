// The measurements of one process, whose shader cache is as its environment says.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bench {

/// Measures `part`, "toggle", "prepared" or "compile", and prints lines `group<TAB>name<TAB>milliseconds`, the first with the group "driver"
/// and the driver's name. `size` is "", "--quick" or "--smoke". Answers the exit status.
int switchingChild(const std::string& part, const std::string& size);

/// What a command prints on stdout. Throws std::runtime_error if it fails.
std::string outputOf(const std::string& command);

}  // namespace bench
