// Results into cells, cells into Markdown and back.
// SPDX-License-Identifier: MIT
#include "stability/table.hpp"

#include <sstream>

namespace stability {

Line line(const Row& row, const Outcome& outcome) {
    Line cells;
    cells[id] = {row.id};
    cells[what] = {row.name};
    cells[input] = {row.input};
    for (Cell& cell : cells)
        if (cell.text.empty())
            cell.text = "-";
    const auto put = [&cells](Column column, const std::string& text, Peer::Verdict as) {
        if (!text.empty())
            cells[column] = {text, as};
    };
    const Peer::Verdict own = outcome.failures.empty() ? Peer::ok : Peer::wrong;
    put(naive, outcome.naive.text, outcome.naive.verdict);
    put(legacy, outcome.legacy.text, outcome.legacy.verdict);
    put(physical, outcome.physical.text, outcome.physical.verdict);
    put(strict, outcome.twin, own);
    put(gl, outcome.gl, own);
    put(expected, outcome.expected, Peer::none);
    put(bound, outcome.bound, Peer::none);
    if (outcome.error >= 0)
        put(error, outcome.error > 0 && outcome.error < 0.01 ? "< 0.01" : number(outcome.error), Peer::none);
    put(verdict, own == Peer::ok ? "ok" : "FAILS", own);
    return cells;
}

std::vector<Line> tableLines() {
    std::vector<Line> lines;
    for (const Row& row : rows())
        lines.push_back(line(row, run(row)));
    return lines;
}

std::string markdownCell(const Cell& cell) {
    switch (cell.verdict) {
    case Peer::wrong:
        return cell.text + " (wrong)";
    case Peer::notFinite:
        return "**" + cell.text + "**";
    case Peer::none:
    case Peer::ok:
        break;
    }
    return cell.text;
}

std::string markdown(const std::vector<Line>& lines) {
    std::ostringstream out;
    out << R"(<!-- Made by `tests/stability/report`; do not edit. -->
# How lighting goes wrong in floats, and what the lab does about it

Every row is a test (`tests/stability/`). It runs on the CPU in strict IEEE float, on the text of the shaders themselves, and on
the graphics driver, into 32-bit floats, each time in world and in view space; all are judged by the same equation in
`long double`. *Naive GLSL* normalises wherever a unit vector is wanted and calls `pow`; *three.js* is its formula (r146) with
the lights of then (legacy) and with the physical ones, 1 / max(d^k, 0.01), without their factor pi; all three in strict IEEE
float, with `max` and `clamp` as GLSL defines them, so that NaN shows as NaN: a driver may hide it. three.js knows neither
Phong's R nor lighting per vertex: there its columns are empty.

**Bold**: NaN or infinite. *(wrong)*: off by more than one code of a picture that shows the right answer, or, where the right
answer is a refusal, taken without a word. u = 2^-24; S is the pixel's sum with every cosine and power taken as 1; A = 16/255 is
the ambient light of every row that does not say otherwise. The error is the worst of all that the row measures, on the CPU and
on the driver.

![The same table in colours](pictures/stability.png)

)";
    const auto put = [&out](const auto& cells, const auto& text) {
        out << '|';
        for (const auto& cell : cells)
            out << ' ' << text(cell) << " |";
        out << '\n';
    };
    put(titles, [](const char* title) { return title; });
    put(titles, [](const char*) { return "---"; });
    for (const Line& line : lines)
        put(line, markdownCell);
    return out.str();
}

std::vector<std::vector<std::string>> readMarkdown(const std::string& page) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream in(page);
    for (std::string text; std::getline(in, text);) {
        if (!text.starts_with("| "))
            continue;
        std::vector<std::string>& cells = rows.emplace_back();
        for (std::size_t from = 2, bar; (bar = text.find(" |", from)) != std::string::npos; from = bar + 3)
            cells.push_back(text.substr(from, bar - from));
    }
    if (rows.size() >= 2)
        rows.erase(rows.begin(), rows.begin() + 2);
    return rows;
}

}  // namespace stability
