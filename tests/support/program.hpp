// Runs the lab's programs as a user does, and keeps what they said.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace support {

/// What a program left behind.
struct Outcome {
    int status = -1;  ///< exit status; 128 + n if signal n ended it
    std::string out;  ///< stdout
    std::string err;  ///< stderr
};

/// Runs build/bin/<arguments[0]> in `directory`, with DISPLAY and WAYLAND_DISPLAY unset and LANG=C, plus `environment`.
Outcome run(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
            const std::vector<std::pair<std::string, std::string>>& environment = {});

/// A folder of its own for a test, removed at the end.
class TemporaryDirectory {
  public:
    TemporaryDirectory();
    ~TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// The full name of a file in it.
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    /// Names of everything in it, sorted.
    std::vector<std::string> contents() const;

  private:
    std::filesystem::path path_;
};

/// The whole file; empty if it cannot be read.
std::string readFile(const std::filesystem::path& path);
void writeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace support
