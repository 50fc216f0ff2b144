// The results of all parts together: as a table for the terminal, and as README's section.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// A part's JSON file, read.
struct PartResults {
    std::string part, machine, driver, version, date;
    int cores = 0;
    std::vector<Result> results;
};

/// The parts whose JSON files are in a folder, in the order in which they are shown. Throws std::runtime_error that names a file
/// that is not such a report.
std::vector<PartResults> readParts(const std::filesystem::path& directory);

/// One line for each result that has a target, and for ratios; targets missed are marked.
std::string terminalTable(const std::vector<PartResults>& parts);

/// README's section, without its marks. `pictures` is where the PNG files are, as README names the folder; parts that
/// have none in `directory` get none.
std::string readmeSection(const std::filesystem::path& directory, const std::string& pictures);

/// What stands between the marks of `text`. Throws std::runtime_error if the marks are missing.
std::string markedPart(const std::string& text);
/// `text` with `section` between its marks.
std::string withMarkedPart(const std::string& text, const std::string& section);

}  // namespace bench
