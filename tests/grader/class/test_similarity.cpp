// Who is named together with whom, and who is not.
// SPDX-License-Identifier: MIT
#include "grader/class/similarity.hpp"

#include <gtest/gtest.h>

namespace {

using grader::Result;

Result resultOf(const std::string& name, const std::string& file, const std::string& source,
                const std::string& frames = "") {
    Result result;
    result.folder = result.report.submission = name;
    if (!file.empty())
        result.files["lesson"] = file;
    if (!source.empty())
        result.sources["lesson"] = source;
    result.frames = frames;
    return result;
}

std::string similarTo(const Result& result) {
    std::string text;
    for (const grader::Similar& other : result.report.similar)
        text += other.submission + ": " + other.how + "; ";
    return text;
}

TEST(Similarity, TheStrongestReasonIsToldOnce) {
    std::vector<Result> results = {resultOf("a", "1", "9", "7"), resultOf("b", "1", "9", "7"),
                                   resultOf("c", "2", "9", "7"), resultOf("d", "3", "8", "7"),
                                   resultOf("e", "4", "", "")};
    findSimilar(results, grader::Language::en);
    EXPECT_EQ(similarTo(results[0]), "b: the program: the same file, byte for byte; "
                                     "c: the program: the same text but for comments and blanks; "
                                     "d: frames that are wrong and equal to the last bit; ");
    EXPECT_EQ(similarTo(results[4]), "");
    findSimilar(results, grader::Language::it);
    EXPECT_EQ(results[3].report.similar.size(), 3U);
}

TEST(Similarity, CommonMistakesAreNoReason) {
    std::vector<Result> many;
    for (const char* name : {"a", "b", "c", "d", "e"})
        many.push_back(resultOf(name, name, name, "7"));
    findSimilar(many, grader::Language::en);
    EXPECT_EQ(similarTo(many[0]), "");
    many.pop_back();
    findSimilar(many, grader::Language::en);
    EXPECT_EQ(many[0].report.similar.size(), 3U);
    many[0].report.checks.emplace_back().explanation.emplace();  // a misconception of the catalogue
    findSimilar(many, grader::Language::en);
    EXPECT_EQ(similarTo(many[0]), "");
    EXPECT_EQ(many[1].report.similar.size(), 2U);
}

TEST(Similarity, TheSamePartIsMeant) {
    std::vector<Result> results = {resultOf("a", "1", "9"), resultOf("b", "", "")};
    results[1].files["terms/clamp.glsl"] = "1";
    findSimilar(results, grader::Language::en);
    EXPECT_EQ(similarTo(results[0]), "");
}

}  // namespace
