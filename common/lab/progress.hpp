// Progress: a bar on stderr for what takes longer than two seconds, where somebody looks.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace lab {

/// A bar that shows only on a terminal, and only after two seconds. It ends its line when it goes.
class Progress {
  public:
    Progress() = default;
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// The share that is done, 0 to 1, and what to say behind the bar.
    void step(double share, const std::string& text);
    /// Takes the bar away, for a message of its own line; the next step draws it again.
    void clear();

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    int filled_ = -1;
    bool shown_ = false;
};

}  // namespace lab
