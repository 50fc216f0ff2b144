// What stands in a folder of submissions, or of results.
// SPDX-License-Identifier: MIT
#include "grader/class/entries.hpp"

#include "grader/grading/grader.hpp"

#include <algorithm>
#include <system_error>

namespace grader {

namespace fs = std::filesystem;

std::vector<fs::path> entriesOf(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> entries;
    for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
        if (!i->path().filename().string().starts_with('.'))
            entries.push_back(i->path());
    if (error)
        throw UsageError(folder.string() + ": " + error.message() +
                         "; expected a folder with one entry per submission");
    std::sort(entries.begin(), entries.end());
    return entries;
}

}  // namespace grader
