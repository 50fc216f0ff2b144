// The folder of one graded submission: its report, and what says whether it is still good.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/grading/grader.hpp"

#include <optional>

namespace grader {

/// grading.json: what a result was made from. All hashes are SHA-256.
struct ResultKey {
    std::string submission, tool, rubric;
    bool operator==(const ResultKey&) const = default;
};

/// What mergeClass knows of a result besides its report.
struct Result {
    Report report;
    ResultKey key;
    std::map<std::string, std::string> sources, files;  ///< as Graded's, without what all have in common
    std::string frames;  ///< as Graded's
    std::string folder;  ///< the submission's own name, any bytes; its result is report/results/<folder>
};

/// Where the results of a class stand: report/results.
std::filesystem::path resultsFolder(const std::filesystem::path& report);
/// Writes a result in place of the one that is there: whole, by rename.
void writeResult(const Graded& graded, const ResultKey& key, const Grader& grader,
                 const std::filesystem::path& folder, const std::string& formats);
/// Reads one; none if it is missing or not whole.
std::optional<Result> readResult(const std::filesystem::path& folder);
/// Whether a result that was read has all its pictures, and its report in these formats.
bool hasAllFiles(const Result& result, const std::filesystem::path& folder, const std::string& formats);

}  // namespace grader
