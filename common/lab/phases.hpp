// Phases: where the time of a frame goes, from the program's start to the written file.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <utility>
#include <vector>

namespace lab {

/// Stretches of time by name, one after the other, in the order in which they were first named. Costs a clock reading each.
class Phases {
  public:
    /// Ends the stretch that began with the last mark (or with this object, or restart) and gives it a name.
    void mark(const char* name) { add(name, lap()); }
    /// The milliseconds since the last mark; the next stretch begins now.
    double lap();
    /// Adds milliseconds to what has this name.
    void add(const char* name, double milliseconds);
    /// Forgets everything; a stretch begins now. For the next frame of many.
    void restart();

    const std::vector<std::pair<const char*, double>>& all() const { return all_; }

  private:
    using Clock = std::chrono::steady_clock;

    std::vector<std::pair<const char*, double>> all_;
    Clock::time_point last_ = Clock::now();
};

}  // namespace lab
