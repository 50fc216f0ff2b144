// The files of a folder or of an archive, within limits.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/submission/submission.hpp"

namespace grader {

/// What was found, and what could not be taken.
struct Files {
    std::vector<NamedText> taken;  ///< sorted by name
    std::vector<SubmittedFile> leftOut;  ///< with a note
    std::string problem;  ///< an archive that cannot be read, or too much in it; empty if all is well
};

inline constexpr std::size_t mostFiles = 200;
inline constexpr std::size_t largestFile = 1 << 20;
inline constexpr std::size_t largestTotal = 8 << 20;
inline constexpr std::size_t largestArchive = 64 << 20;

/// Reads a folder (all levels) or a file: sources, shaders and archives; what is neither is listed only. Throws std::runtime_error if the path cannot be read.
Files filesAt(const std::filesystem::path& path, Language language);
/// Reads an archive's bytes: zip, tar, gzip.
Files filesInArchive(const std::string& bytes, Language language);
/// Whether a name says that it is an archive.
bool isArchive(const std::string& name);

}  // namespace grader
