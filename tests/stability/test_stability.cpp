// The stability suite: each row on the CPU in strict IEEE, on the graphics driver, and against the truth.
// SPDX-License-Identifier: MIT
#include "stability/rows.hpp"

#include <gtest/gtest.h>
#include <set>

namespace {

using stability::Kind;
using stability::Row;

std::vector<std::string> idsToRun() {
    std::vector<std::string> ids;
    for (const Row& row : stability::rows())
        if (row.kind != Kind::later)
            ids.emplace_back(row.id);
    return ids;
}

class Stability : public testing::TestWithParam<std::string> {};

TEST_P(Stability, HoldsItsBound) {
    const Row& row = stability::row(GetParam());
    ASSERT_TRUE(!row.setups.empty() || row.matrix || row.also) << "nothing is tested";
    const stability::Outcome outcome = stability::run(row);
    for (const std::string& failure : outcome.failures)
        ADD_FAILURE() << row.id << ", " << row.name << ": " << failure;
    if (outcome.error >= 0)
        std::cout << row.id << ": at most " << outcome.error << " u S, bound " << outcome.bound
                  << "; view space: " << outcome.spaces << '\n';
}

INSTANTIATE_TEST_SUITE_P(Rows, Stability, testing::ValuesIn(idsToRun()),
                         [](const auto& test) { return test.param; });

TEST(StabilityTable, NamesAllRowsOnce) {
    std::vector<std::string> expected, found;
    for (const auto& [family, count] :
         {std::pair('G', 17), {'L', 23}, {'A', 10}, {'M', 14}, {'C', 7}, {'S', 7}, {'F', 6}})
        for (int i = 1; i <= count; ++i)
            expected.push_back(family + std::to_string(i));
    std::set<std::string> waiting;
    for (const Row& row : stability::rows()) {
        found.emplace_back(row.id);
        if (row.kind == Kind::later)
            waiting.insert(row.id);
        EXPECT_FALSE(row.kind == Kind::later && row.waitsFor == nullptr) << row.id;
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(waiting, std::set<std::string>{"G15"});
}

}  // namespace
