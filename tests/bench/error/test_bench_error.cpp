// The error benchmark itself: it measures every method, tells the wrong ones from the right ones, and knows a front when it sees one.
// SPDX-License-Identifier: MIT
#include "bench/error/report.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace {

using namespace bench::error;
using Json = nlohmann::json;

// What a short run of one scene writes.
Json measured(const std::string& scene) {
    const support::TemporaryDirectory directory;
    const support::Outcome outcome = support::run(
        {"bench_error", "--out", "here", "--quick", "--size", "64", "--scene", scene}, directory.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const char* table : {"here/error.csv", "here/error_scenes.csv", "here/error_front.csv"})
        EXPECT_GT(support::readFile(directory.file(table)).size(), 100U) << table;
    return Json::parse(support::readFile(directory.file("here/error.json")));
}

// The rows of one method, one a case.
std::vector<Json> rowsOf(const Json& results, const std::string& method) {
    std::vector<Json> rows;
    for (const Json& row : results["cases"])
        if (row["method"] == method)
            rows.push_back(row);
    return rows;
}

double worst(const Json& results, const std::string& method) {
    double max = 0;
    for (const Json& row : rowsOf(results, method))
        max = std::max(max, row["max_uS"].get<double>());
    return max;
}

void expectSound(const Json& results, std::size_t cases) {
    EXPECT_FALSE(results["driver"].get<std::string>().empty());
    for (const Method& method : methods())
        EXPECT_EQ(rowsOf(results, method.id).size(), cases) << method.id;
    for (const Json& row : results["cases"]) {
        for (const char* number : {"max_uS", "p999_uS", "mean_codes", "wrong_share", "frame_ms",
                                   "lighting_ms", "spread_ms", "cost_ratio", "frame_over_floor"})
            EXPECT_TRUE(row[number].is_number()) << number << " of " << row["method"];  // null: not finite
        EXPECT_GT(row["frame_ms"], 0) << row["method"];
        EXPECT_GT(row["values"], 3000) << row["method"];
        EXPECT_GE(row["max_uS"], row["p999_uS"]) << row["method"];
        EXPECT_LE(row["mean_codes"], row["max_codes"]) << row["method"];
    }
    for (const Json& row : rowsOf(results, "default")) {
        EXPECT_TRUE(row["bound_held"].get<bool>());
        EXPECT_GT(row["max_uS"], 0.5) << "floats round";
        EXPECT_LE(row["max_codes"], 1);
    }
}

// What is wrong by design must be seen to be: further off than anything that only rounds differently.
void expectTold(const Json& results, const std::set<std::string>& notHere) {
    const double bound = rowsOf(results, "default").back()["bound_uS"];
    const bool sixteenBits = results["driver"].get<std::string>().find("llvmpipe") != std::string::npos;
    for (const Method& method : methods()) {
        const bool mediump = std::string(method.id).starts_with("mediump");
        if (notHere.contains(method.id) || (mediump && !sixteenBits))
            continue;
        if (method.approximate)
            EXPECT_GT(worst(results, method.id), 5 * bound) << method.id;
        else
            EXPECT_LT(worst(results, method.id), bound) << method.id;
    }
    EXPECT_LT(worst(results, "cpu_double"), worst(results, "default"));
}

TEST(BenchError, LectureScene) {
    const Json results = measured("S0");
    expectSound(results, 1);
    expectTold(results, {"cut_0.5", "cut_0.01"});  // no light here is so weak
    EXPECT_EQ(worst(results, "cut_0.5"), worst(results, "default"));
    EXPECT_GT(rowsOf(results, "per_vertex")[0]["max_codes"], 1);
}

TEST(BenchError, ManyLights) {
    const Json results = measured("S2");
    expectSound(results, 2);
    expectTold(results, {"cut_0.01"});  // which may drop nothing of so few lights
    EXPECT_GT(worst(results, "cut_0.5"), worst(results, "cut_0.01"));
}

TEST(BenchError, WrongUse) {
    const support::TemporaryDirectory directory;
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"bench_error"},
                                                      {"bench_error", "--out", "x", "--scene", "S10"},
                                                      {"bench_error", "--out", "x", "--size", "1"},
                                                      {"bench_error", "--out"}}) {
        const support::Outcome outcome = support::run(arguments, directory.path());
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.err.find("usage"), std::string::npos);
    }
    EXPECT_TRUE(directory.contents().empty());
}

// --- the parts, on numbers made up

Row row(std::size_t method, double error, double milliseconds) {
    Row row{};
    row.scene = "S0";
    row.method = method;
    row.error = {error, error, 3};
    row.shadingError = error;
    row.bound = 20;
    row.codes = {1, 0.5, 0.5};
    row.cost.lighting = milliseconds;
    row.cost.frame = milliseconds + 1;
    row.cost.overFloor = milliseconds + 1;
    row.ratio = milliseconds / 2;
    return row;
}

TEST(BenchErrorParts, TheFrontAllowsThreePercentOfNoise) {
    const auto defaultOnFront = [](double otherError, double otherCost) {
        return sumUp({row(defaultMethod, 5, 1), row(threeMethod, otherError, otherCost)})[0].onFront;
    };
    EXPECT_TRUE(defaultOnFront(5, 0.98));
    EXPECT_FALSE(defaultOnFront(5, 0.96));
    EXPECT_TRUE(defaultOnFront(6, 0.5)) << "cheaper, but not as exact";
    EXPECT_TRUE(defaultOnFront(1, 2)) << "more exact, but dearer";
    EXPECT_FALSE(defaultOnFront(1, 0.5));
}

TEST(BenchErrorParts, CasesAreSummedUp) {
    const std::vector<SceneRow> rows = sumUp(
        {row(defaultMethod, 5, 1), row(threeMethod, 2, 2), row(defaultMethod, 3, 4), row(threeMethod, 7, 6)});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].error.max, 5);
    EXPECT_EQ(rows[1].error.max, 7);
    EXPECT_DOUBLE_EQ(rows[0].ratio, 1) << "of 1/2 and 2";
    EXPECT_DOUBLE_EQ(rows[1].ratio, std::sqrt(3)) << "of 1 and 3";
}

TEST(BenchErrorParts, TheLineOfTheFrontFalls) {
    const std::vector<SceneRow> rows =
        sumUp({row(0, 5, 2), row(1, 9, 4), row(2, 1, 3), row(3, 20, 1), row(4, 30, 2.5)});
    std::vector<std::size_t> line;
    for (const SceneRow* one : frontLine(rows, [](const SceneRow& r) { return r.error.max; }))
        line.push_back(one->method);
    EXPECT_EQ(line, (std::vector<std::size_t>{3, 0, 2}));
}

TEST(BenchErrorParts, ABrokenBoundIsNoticed) {
    EXPECT_FALSE(row(defaultMethod, 20, 1).boundBroken());
    EXPECT_TRUE(row(defaultMethod, 20.1, 1).boundBroken());
    EXPECT_TRUE(row(defaultMethod, std::numeric_limits<double>::quiet_NaN(), 1).boundBroken());
    EXPECT_FALSE(row(threeMethod, 1e9, 1).boundBroken()) << "nothing is promised of it";
}

TEST(BenchErrorParts, ErrorsAreWhatTheyAre) {
    Truth truth;
    truth.judged = {1, 0};
    truth.P = {Truth::Vec(0.5L), Truth::Vec(0)};
    truth.S = {Truth::Vec(1), Truth::Vec(0)};
    const float off = 0.5F + 8 * 0x1p-24F;
    const Error error = floatError(truth, {0.5F, off, 0.5F, 9, 9, 9});
    EXPECT_DOUBLE_EQ(error.max, 8);
    EXPECT_EQ(error.values, 3) << "a pixel that is not judged does not count";
    EXPECT_EQ(floatError(truth, {std::numeric_limits<float>::quiet_NaN(), 0.5F, 0.5F, 0, 0, 0}).max, 1e30);
    const CodeError codes = codeError(truth, {128, 131, 128, 9, 9, 9});  // 127.5 goes to the even 128
    EXPECT_EQ(codes.max, 3);
    EXPECT_DOUBLE_EQ(codes.mean, 1);
    EXPECT_DOUBLE_EQ(codes.wrong, 1.0 / 3);
}

}  // namespace
