// Frames timed by Google Benchmark: in random turns, so that whatever else the machine does meets all of them alike.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace bench {

/// Something to time: a frame, drawn and waited for.
struct Case {
    std::string name;
    std::function<void()> frame;
};

/// Collects the times of all groups of cases of a part.
class Timing {
  public:
    /// Times each case `rounds` times, the cases in random turns: a frame that is not counted, then the mean of `frames` ones.
    /// Answers the median of each, in milliseconds, by name. A group that would take more than a minute is measured less often.
    std::map<std::string, double> measure(const std::vector<Case>& cases, int rounds, int frames = 1);
    /// Like measure(), but never less often; answers every round's time, in milliseconds, in the order in which they were measured.
    std::map<std::string, std::vector<double>> samples(const std::vector<Case>& cases, int rounds,
                                                       int frames = 1);
    /// Writes Google Benchmark's own JSON of everything measured so far. Throws image::Error.
    void write(const std::filesystem::path& file) const;

  private:
    std::vector<std::string> runs_;  // Google Benchmark's JSON, one text for each call of samples()
};

}  // namespace bench
