// Folders written whole on a disk that others write to as well: under hidden names first, then renamed.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace grader {

/// ".<machine>.<process>": how this process begins the names of what is not whole yet. No other process has it, on no machine and in no
/// container, however many write to the same disk.
std::string scratchMark();

/// Puts the folder `fresh` in the place of `place`, whatever stands there; both in the same folder. At any time `place` is the old
/// one, nothing, or the new one. Throws std::filesystem::filesystem_error.
void replaceFolder(const std::filesystem::path& fresh, const std::filesystem::path& place);

/// Removes what processes that were killed left in a folder under such names: this machine's dead ones at once, those of other
/// machines, about which nothing is known from here, after an hour.
void sweep(const std::filesystem::path& folder);

}  // namespace grader
