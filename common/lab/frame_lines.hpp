// The lines of --frames-from: read one at a time, split into words as a shell does.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <fstream>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace lab {

/// The words of a line. Blanks part them; '...' and "..." hold what is between them together, a backslash takes the next
/// character as it is (inside "..." only a " or another backslash, inside '...' none); # where a word could begin starts a
/// comment. Nothing else is special: no $, no *, no ~. Throws UsageError for a quote without its end, a backslash before
/// nothing, and a NUL.
std::vector<std::string> splitWords(std::string_view line);

/// Gives a file's lines as they come, so that a program at the other end of a pipe may wait for the answer to each.
class LineReader {
  public:
    /// "-" is stdin. Throws UsageError for a file that cannot be read.
    explicit LineReader(const std::string& file);

    /// The next line, without its end (LF or CR LF; the last one needs none). False at the end. Of a line longer than
    /// `longest` bytes the rest is passed over, and isTooLong() says so.
    bool next(std::string& line);
    bool isTooLong() const { return tooLong_; }
    /// Of the line that next() gave: 1, 2, ...
    int number() const { return number_; }
    /// "frames.txt:3", or "stdin:3".
    std::string place() const;
    /// How much of the file is read, 0 to 1; 0 where its size is not known.
    double share() const;

    static constexpr std::size_t longest = 65'536;

  private:
    int nextByte();

    std::string name_;
    std::ifstream file_;
    std::istream* in_;
    std::uintmax_t size_ = 0;
    std::uintmax_t read_ = 0;
    int number_ = 0;
    bool tooLong_ = false;
};

}  // namespace lab
