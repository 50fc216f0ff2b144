// What stands in a folder of submissions, or of results.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace grader {

/// All entries, sorted by the bytes of their names, but for those that begin with a dot: they are a system's or our own, not yet whole.
/// Throws UsageError where there is no such folder.
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

}  // namespace grader
