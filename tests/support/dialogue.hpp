// Talks with one of the lab's programs through pipes, line by line.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace support {

/// Starts build/bin/<arguments[0]> in `directory` without a display; its stdin and stdout are ours, its stderr nobody's.
class Dialogue {
  public:
    Dialogue(const std::vector<std::string>& arguments, const std::filesystem::path& directory);
    ~Dialogue();
    Dialogue(const Dialogue&) = delete;
    Dialogue& operator=(const Dialogue&) = delete;

    void say(const std::string& text);
    /// The next line without its end; waits for it, 20 seconds at most. Empty if none comes.
    std::string hear();
    /// Closes the program's stdin and waits for its exit status; what it still said can be heard.
    int end();

  private:
    pid_t child_ = -1;
    int to_ = -1;
    int from_ = -1;
    std::string heard_;
};

}  // namespace support
