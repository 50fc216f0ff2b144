// Loops over lights, written out where that pays: three.js does the same with its `#pragma unroll_loop_start`.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace render {

/// A loop of GLSL: `for (int i = BEGIN; i < END; ++i)` and its statement, a line or a block.
struct Loop {
    std::string variable, begin, end;
    std::size_t head;  ///< line of the `for`, from 0
    std::size_t last;  ///< last line of the statement
};

/// A line of a loop that was written out, and the line of the file that it came from (from 0).
struct LoopLine {
    std::string text;
    std::size_t from;
};

/// Writes loops out as a preamble asks: every turn by itself where the lights are constants (LIGHTS_ARE_CONSTANTS 1), so that
/// each turn has its own; four lights a turn where there are very many (LONG_LOOPS 1), because drivers may end a loop after
/// 65,535 turns without a word. Elsewhere loops stay as they are.
class LoopWriter {
  public:
    explicit LoopWriter(const std::string& preamble);

    /// The loop whose `#pragma unroll` stands in line `pragma`, if there is one and it is to be written out. Its bounds must be
    /// numbers, or #defined as numbers, where every turn is.
    std::optional<Loop> read(const std::vector<std::string>& lines, std::size_t pragma) const;
    std::vector<LoopLine> writeOut(const Loop& loop, const std::vector<std::string>& lines) const;

  private:
    bool is(const char* name) const;
    std::optional<int> value(const std::string& text) const;

    std::map<std::string, std::string> defines_;
};

}  // namespace render
