// What the frames are worth that this lab is tested and graded by: they reject every misconception of the catalogue that they
// can show, tell each from the others, and accept what is right in other words.
// SPDX-License-Identifier: MIT
#include "support/draw.hpp"
#include "support/hidden_scene.hpp"
#include "support/misconceptions.hpp"
#include "support/program.hpp"
#include "three/object_loader.hpp"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace {

using support::Apart;
using support::apart;
using support::Misconception;
using support::misconceptions;
using support::WrongFrames;

constexpr int size = 96;
constexpr double oneHundredthCode = 0.01;

WrongFrames framesOf(const THREE::LoadedScene& loaded) { return {*loaded.scene, *loaded.camera, size, size}; }

// The frame of every row, by its id.
std::map<std::string, std::vector<float>> allFrames(const WrongFrames& frames) {
    std::map<std::string, std::vector<float>> all;
    for (const Misconception& row : misconceptions())
        all[row.id] = frames.frame(row);
    return all;
}

void printRow(const Misconception& row, const Apart& a) {
    std::printf("  %-4s %5.1f codes %6.2f %%  %s\n", row.id, a.codes, 100 * a.share, row.name);
}

TEST(Catalogue, EveryIdOnceAndFound) {
    std::set<std::string> ids, names;
    int right = 0;
    for (const Misconception& row : misconceptions()) {
        EXPECT_TRUE(ids.insert(row.id).second) << row.id;
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(&support::misconception(row.id), &row);
        EXPECT_EQ(row.right, row.id[0] == 'R') << row.id;
        EXPECT_GE(row.firstLesson, 2) << "lessons 00 and 01 have no equation that could be wrong";
        right += row.right ? 1 : 0;
    }
    EXPECT_EQ(right, 8);
    for (const support::MisconceptionClass& c : support::misconceptionClasses())
        for (const std::string& id : c.ids)
            EXPECT_FALSE(support::misconception(id).right) << id;
    EXPECT_THROW(support::misconception("A0"), std::out_of_range);
}

class Hidden : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Scene, Hidden, testing::Range<std::uint64_t>(0, 400),
                         [](const auto& test) { return "seed" + std::to_string(test.param); });

// How a point of the hidden scene is lit.
struct Lit {
    int lamps = 0;  ///< how many reach it
    double nearest = 1e9;  ///< distance to the nearest point light
};
Lit litAt(const support::WrongInput& p) {
    Lit lit;
    for (const support::Lamp& lamp : p.lamps) {
        const glm::dvec3 v = lamp.point ? lamp.position - p.Q : lamp.towards;
        lit.lamps += glm::dot(p.n, v) > 0 ? 1 : 0;
        if (lamp.point)
            lit.nearest = std::min(lit.nearest, glm::length(v));
    }
    return lit;
}

TEST_P(Hidden, IsWhatTheRecipeAsks) {
    const THREE::LoadedScene hidden = support::hiddenScene(GetParam());
    const WrongFrames frames = framesOf(hidden);
    std::map<int, std::size_t> byLamps;
    std::size_t near = 0, bright = 0;
    for (const support::WrongInput& p : frames.points()) {
        const Lit lit = litAt(p);
        ++byLamps[lit.lamps];
        near += lit.nearest < 1 ? 1U : 0U;
        const glm::dvec3 P = support::misconception("R5").evaluate(p);
        bright += std::max({P.r, P.g, P.b}) > 1 ? 1U : 0U;
    }
    const std::size_t some = frames.points().size() / 100;
    EXPECT_GT(frames.points().size(), static_cast<std::size_t>(size * size / 4)) << "of the picture is mesh";
    for (int lamps = 0; lamps <= 2; ++lamps)
        EXPECT_GT(byLamps[lamps], some) << "points are lit by " << lamps << " lamps";
    EXPECT_GT(near, some) << "points are nearer than 1 to a lamp";
    EXPECT_GT(bright, some) << "points are brighter than a screen can show";
    std::printf("  points %zu; lit by none %zu, one %zu, two %zu, three %zu; d < 1: %zu; above 1: %zu\n",
                frames.points().size(), byLamps[0], byLamps[1], byLamps[2], byLamps[3], near, bright);
}

TEST_P(Hidden, RejectsEveryMisconception) {
    const WrongFrames frames = framesOf(support::hiddenScene(GetParam()));
    for (const Misconception& row : misconceptions()) {
        const Apart a = apart(frames.truth(), frames.frame(row), frames.counted());
        printRow(row, a);
        if (row.right)
            EXPECT_LT(a.codes, oneHundredthCode) << row.id << ": " << row.name << " must never be punished";
        else
            EXPECT_TRUE(a.clearly()) << row.id << ": " << row.name << " looks right on " << 1 - a.share;
    }
}

TEST_P(Hidden, TellsMisconceptionsApartUnlessNoPictureCan) {
    const WrongFrames frames = framesOf(support::hiddenScene(GetParam()));
    const auto all = allFrames(frames);
    int pairs = 0;
    double smallest = 1;
    std::string which;
    for (const Misconception& a : misconceptions())
        for (const Misconception& b : misconceptions()) {
            if (a.right || b.right || std::string(a.id) >= b.id)
                continue;
            const Apart difference = apart(all.at(a.id), all.at(b.id), frames.counted());
            ++pairs;
            if (frames.sameClass(a, b)) {
                EXPECT_LT(difference.codes, oneHundredthCode) << a.id << " and " << b.id << " are no class";
                continue;
            }
            EXPECT_TRUE(difference.clearly()) << a.id << " (" << a.name << ") and " << b.id << " (" << b.name
                                              << ") differ on only " << difference.share;
            if (difference.share < smallest) {
                smallest = difference.share;
                which = std::string(a.id) + " and " + b.id;
            }
        }
    std::printf("  %d pairs; the closest are %s, apart on %.2f %%\n", pairs, which.c_str(), 100 * smallest);
}

}  // namespace
