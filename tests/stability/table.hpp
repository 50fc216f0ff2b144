// The rows' results as a table: what the report shows and a test compares.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/rows.hpp"

#include <array>
#include <string>
#include <vector>

namespace stability {

/// One cell, and what to make of it.
struct Cell {
    std::string text;
    Peer::Verdict verdict = Peer::none;
};

enum Column {
    id,
    what,
    input,
    naive,
    legacy,
    physical,
    strict,
    gl,
    expected,
    bound,
    error,
    verdict,
    columns
};
inline constexpr std::array<const char*, columns> titles{
    "id",        "case",     "input",    "naive GLSL", "three.js legacy", "three.js physical",
    "ours, CPU", "ours, GL", "expected", "bound",      "error in u S",    "verdict"};

/// Figures that differ a little from machine to machine.
inline bool isMeasured(int column) { return column == strict || column == gl || column == error; }

using Line = std::array<Cell, columns>;

/// Runs all rows.
std::vector<Line> tableLines();
/// A row's line.
Line line(const Row& row, const Outcome& outcome);

/// The whole page; its first line says which command makes it.
std::string markdown(const std::vector<Line>& lines);
/// The cells of the page's table, row by row, without its head.
std::vector<std::vector<std::string>> readMarkdown(const std::string& page);
/// A cell as the page shows it.
std::string markdownCell(const Cell& cell);

}  // namespace stability
