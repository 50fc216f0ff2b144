// What a part of the benchmark leaves behind: its results, with machine, driver, version and date, as JSON and CSV.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bench {

/// How a part was asked to run.
struct Options {
    std::filesystem::path out;  ///< where results go; made if it is missing
    bool quick = false;  ///< fewer rounds and sizes: under a minute
    bool smoke = false;  ///< hardly any: seconds, for a test that only wants to see that it works
};

/// Reads `DIR [--quick|--smoke]` after the program's name; on anything else it says what was expected and ends the program with 2.
Options readOptions(int count, char** arguments);

/// What a target asks of a value.
enum class Goal { atMost, atLeast };

/// One number. `ok` is set where there is a target.
struct Result {
    std::string name;
    double value = 0;
    std::string unit;  ///< "ms", "ratio", ...
    std::optional<double> target;
    std::optional<bool> ok;
};

/// The results of a part: DIR/<part>.json, and DIR/<part>.csv for the chart.
class Report {
  public:
    /// `driver` is what the driver calls itself; where nothing was drawn with one, say so.
    Report(std::string part, std::string driver);

    void add(const std::string& name, double value, const std::string& unit);
    void add(const std::string& name, double value, const std::string& unit, Goal goal, double target);
    const std::vector<Result>& results() const { return results_; }

    /// The whole report as JSON text; fields as tests/bench/README.md lists them. Throws std::runtime_error for a value that is not finite.
    std::string json() const;
    /// Writes both files, each whole or not at all. Throws image::Error.
    void write(const std::filesystem::path& directory) const;
    /// The same with a table of the part's own as CSV: a header and its rows.
    void write(const std::filesystem::path& directory, const std::string& csv) const;

  private:
    std::string part_, driver_;
    std::vector<Result> results_;
};

/// The processor, as the machine calls it.
std::string processorName();

/// YYYY-MM-DD.
std::string today();

/// The middle of the values, between the two middle ones of an even number; 0 of none.
double median(std::vector<double> values);

/// A number as JSON and tables want it: 4 significant digits.
std::string digits(double value);

/// Runs a program's measurements; a failure is said on stderr, and becomes the exit status 1.
int guarded(const char* program, void (*measure)(const Options&), const Options& options);

/// "[3/12] what" on stderr, so that one sees a long run move.
void progress(std::size_t step, std::size_t steps, const std::string& what);

}  // namespace bench
