// The stability suite: each row on the CPU in strict IEEE, on the graphics driver, and against the truth.
// SPDX-License-Identifier: MIT
#include "stability/rows.hpp"

#include <gtest/gtest.h>

namespace {

using stability::Row;

std::vector<std::string> ids() {
    std::vector<std::string> all;
    for (const Row& row : stability::rows())
        all.emplace_back(row.id);
    return all;
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

INSTANTIATE_TEST_SUITE_P(Rows, Stability, testing::ValuesIn(ids()),
                         [](const auto& test) { return test.param; });

TEST(StabilityTable, NamesAllRowsOnce) {
    std::vector<std::string> expected;
    for (const auto& [family, count] :
         {std::pair('G', 17), {'L', 23}, {'A', 10}, {'M', 14}, {'C', 7}, {'S', 7}, {'F', 6}, {'P', 22}})
        for (int i = 1; i <= count; ++i)
            expected.push_back(family + std::to_string(i));
    EXPECT_EQ(ids(), expected);
}

}  // namespace
