// A file that is written under a temporary name and gets its own name only when it is complete.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace image {

class TemporaryFile {
  public:
    // Creates an empty file with a name of its own in target's directory. Throws Error if that fails.
    explicit TemporaryFile(std::filesystem::path target);
    // Removes the file unless commit() has given it its name.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    std::FILE* stream() const { return stream_; }  // binary, for writing, from its beginning

    // Flushes, closes and renames to target, replacing what stood there. Throws Error if any of that fails.
    void commit();

  private:
    std::filesystem::path target_;
    std::filesystem::path name_;
    std::FILE* stream_ = nullptr;
};

// The operating system's words for an errno, fit for messages.
std::string systemReason(int error);

// Throws Error for a write to disk that failed with this errno.
[[noreturn]] void throwWriteError(int error);

}  // namespace image
