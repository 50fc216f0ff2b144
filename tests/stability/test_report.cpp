// The committed report is what the rows say now.
// SPDX-License-Identifier: MIT
#include "stability/table.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

namespace {

using stability::Cell;
using stability::Line;
using Cells = std::vector<std::vector<std::string>>;

TEST(StabilityReport, IsReadAsItWasWritten) {
    Line line;
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] = {"cell " + std::to_string(i),
                   i % 2 == 0 ? stability::Peer::wrong : stability::Peer::notFinite};
    const Cells cells = stability::readMarkdown(stability::markdown({line}));
    ASSERT_EQ(cells.size(), 1U);
    ASSERT_EQ(cells[0].size(), line.size());
    for (std::size_t i = 0; i < line.size(); ++i)
        EXPECT_EQ(cells[0][i], stability::markdownCell(line[i]));
}

// Measured figures may differ a little from machine to machine; all other columns may not.
TEST(StabilityReport, CommittedPageIsUpToDate) {
    const std::string page = support::readFile(std::string(LAMBERT_SOURCE_DIR) + "/slides_refs/stability.md");
    const std::vector<Line> lines = stability::tableLines();
    const std::string now = stability::markdown(lines);
    EXPECT_EQ(page.substr(0, page.find("| id")), now.substr(0, now.find("| id")))
        << "run tests/stability/report";
    const Cells committed = stability::readMarkdown(page);
    ASSERT_EQ(committed.size(), lines.size()) << "run tests/stability/report";
    for (std::size_t row = 0; row < lines.size(); ++row) {
        ASSERT_EQ(committed[row].size(), lines[row].size()) << "row " << lines[row][stability::id].text;
        for (std::size_t column = 0; column < stability::columns; ++column) {
            if (stability::isMeasured(static_cast<int>(column)))
                continue;
            EXPECT_EQ(committed[row][column], stability::markdownCell(lines[row][column]))
                << "row " << lines[row][stability::id].text << ", column '" << stability::titles[column]
                << "': run tests/stability/report";
        }
    }
}

}  // namespace
