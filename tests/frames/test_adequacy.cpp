// What the hidden scenes are worth: they reject every misconception of the catalogue that they can show, tell each from the
// others, and accept what is right in other words.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/hidden_scene.hpp"
#include "grader/catalogue/misconceptions.hpp"
#include "support/draw.hpp"
#include "three/object_loader.hpp"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace {

using grader::Apart;
using grader::apart;
using grader::Finish;
using grader::Misconception;
using grader::misconceptions;
using grader::WrongFrames;

constexpr int size = 96;
constexpr double oneHundredthCode = 0.01;
// Of the GPU's path. Measured on llvmpipe, which snaps corners to 1/256 of a pixel: 0.061 codes in 800 hidden scenes.
constexpr double oneTenthCode = 0.1;
constexpr int phongsLesson = 9;

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
        EXPECT_EQ(&grader::misconception(row.id), &row);
        EXPECT_EQ(row.right, row.id[0] == 'R') << row.id;
        EXPECT_GE(row.firstLesson, 2) << "lessons 00 and 01 have no equation that could be wrong";
        right += row.right ? 1 : 0;
    }
    EXPECT_EQ(right, 12);
    for (const grader::MisconceptionClass& c : grader::misconceptionClasses())
        for (const std::string& id : c.ids)
            EXPECT_FALSE(grader::misconception(id).right) << id;
    EXPECT_THROW(grader::misconception("A0"), std::out_of_range);
}

// A seed, and what the meshes are made of.
class Hidden : public testing::TestWithParam<std::tuple<std::uint64_t, Finish>> {
  protected:
    bool shiny() const { return std::get<Finish>(GetParam()) == Finish::shiny; }
    THREE::LoadedScene scene() const {
        return grader::hiddenScene(std::get<0>(GetParam()), std::get<1>(GetParam()));
    }
    /// Whether a row is about something that this scene has.
    bool concerns(const Misconception& row) const { return shiny() || row.firstLesson < phongsLesson; }
};

INSTANTIATE_TEST_SUITE_P(Scene, Hidden,
                         testing::Combine(testing::Range<std::uint64_t>(0, 4),
                                          testing::Values(Finish::matte, Finish::shiny)),
                         [](const auto& test) {
                             const bool shiny = std::get<1>(test.param) == Finish::shiny;
                             return "seed" + std::to_string(std::get<0>(test.param)) +
                                    (shiny ? "shiny" : "matte");
                         });

// How a point of the hidden scene is lit.
struct Lit {
    int lamps = 0;  ///< how many reach it
    double nearest = 1e9;  ///< distance to the nearest point light
};
Lit litAt(const grader::WrongInput& p) {
    Lit lit;
    for (const grader::Lamp& lamp : p.lamps) {
        const glm::dvec3 v = lamp.point ? lamp.position - p.Q : lamp.towards;
        lit.lamps += glm::dot(p.n, v) > 0 ? 1 : 0;
        if (lamp.point)
            lit.nearest = std::min(lit.nearest, glm::length(v));
    }
    return lit;
}

TEST_P(Hidden, IsWhatTheRecipeAsks) {
    const THREE::LoadedScene hidden = scene();
    const WrongFrames frames = framesOf(hidden);
    std::map<int, std::size_t> byLamps;
    std::size_t near = 0, bright = 0;
    for (const grader::WrongInput& p : frames.points()) {
        const Lit lit = litAt(p);
        ++byLamps[lit.lamps];
        near += lit.nearest < 1 ? 1U : 0U;
        const glm::dvec3 P = grader::misconception("R5").evaluate(p);
        bright += std::max({P.r, P.g, P.b}) > 1 ? 1U : 0U;
        const glm::dvec3 K_S = p.specular;
        ASSERT_EQ(shiny(), K_S.r != K_S.g && K_S.g != K_S.b && K_S.b != K_S.r);
        ASSERT_NE(p.shininess, THREE::MeshPhongMaterial().shininess);
    }
    const std::size_t some = size * size / 500;  // what Apart::clearly asks of a whole picture
    EXPECT_GT(frames.points().size(), static_cast<std::size_t>(size * size / 4)) << "of the picture is mesh";
    for (int lamps = 0; lamps <= 2; ++lamps)
        EXPECT_GT(byLamps[lamps], some) << "points are lit by " << lamps << " lamps";
    EXPECT_GT(near, some) << "points are nearer than 1 to a lamp";
    EXPECT_GT(bright, some) << "points are brighter than a screen can show";
    std::printf("  points %zu; lit by none %zu, one %zu, two %zu, three %zu; d < 1: %zu; above 1: %zu\n",
                frames.points().size(), byLamps[0], byLamps[1], byLamps[2], byLamps[3], near, bright);
}

TEST_P(Hidden, RejectsEveryMisconception) {
    const WrongFrames frames = framesOf(scene());
    for (const Misconception& row : misconceptions()) {
        const Apart a = apart(frames.truth(), frames.frame(row), frames.counted());
        printRow(row, a);
        const bool wrong = !row.right && concerns(row);
        EXPECT_EQ(a.clearly(), wrong) << row.id << ": " << row.name;
        EXPECT_TRUE(wrong || a.codes < oneHundredthCode) << row.id << " must never be punished";
    }
}

TEST_P(Hidden, TellsMisconceptionsApartUnlessNoPictureCan) {
    const WrongFrames frames = framesOf(scene());
    const auto all = allFrames(frames);
    int pairs = 0;
    double smallest = 1;
    std::string which;
    for (const Misconception& a : misconceptions())
        for (const Misconception& b : misconceptions()) {
            if (a.right || b.right || !concerns(a) || !concerns(b) || std::string(a.id) >= b.id)
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

// A hidden scene, changed so that the condition of every class holds if nothing shines.
THREE::LoadedScene arranged(Finish finish) {
    THREE::LoadedScene hidden = grader::hiddenScene(0, finish);
    hidden.scene->traverse([&](THREE::Object3D& object) {
        if (auto* bulb = dynamic_cast<THREE::PointLight*>(&object))
            bulb->decay = 2;
        if (dynamic_cast<THREE::Group*>(&object) == nullptr)
            return;
        object.position.set(0, 0, 0);
        object.scale.set(1, 1, 1);
    });
    hidden.camera->lookAt(0, 0, 0);
    return hidden;
}

TEST(Classes, HoldWhereTheirConditionDoesAndNowhereElse) {
    const WrongFrames hidden = framesOf(grader::hiddenScene(0)), held = framesOf(arranged(Finish::matte));
    for (const grader::MisconceptionClass& c : grader::misconceptionClasses())
        for (std::size_t i = 1; i < c.ids.size(); ++i) {
            const Misconception& a = grader::misconception(c.ids[0]);
            const Misconception& b = grader::misconception(c.ids[i]);
            EXPECT_EQ(hidden.sameClass(a, b), c.when == std::string("always")) << a.id << ' ' << b.id;
            EXPECT_TRUE(held.sameClass(a, b)) << a.id << ' ' << b.id;
            EXPECT_LT(apart(held.frame(a), held.frame(b), held.counted()).codes, oneHundredthCode)
                << a.id << " and " << b.id << " differ where " << c.when;
            EXPECT_TRUE(apart(held.truth(), held.frame(a), held.counted()).clearly()) << a.id;
        }
    const Misconception& noClamp = grader::misconception("A1");
    EXPECT_FALSE(held.sameClass(noClamp, grader::misconception("B3")));
}

// R stays where it is when n is turned round, but not when w is; and a w that is too long makes R too long.
TEST(Classes, AHighlightSplitsTwoOfThem) {
    const WrongFrames shiny = framesOf(arranged(Finish::shiny));
    for (const auto& [one, other] : {std::pair("B3", "B5"), std::pair("B7", "D1")}) {
        const Misconception &a = grader::misconception(one), &b = grader::misconception(other);
        EXPECT_FALSE(shiny.sameClass(a, b)) << one << ' ' << other;
        EXPECT_TRUE(apart(shiny.frame(a), shiny.frame(b), shiny.counted()).clearly()) << one << ' ' << other;
    }
}

// What OpenGL draws is the truth, and so on the right side of every misconception.
TEST_P(Hidden, TheGpusFrameRejectsEveryMisconceptionToo) {
    const THREE::LoadedScene hidden = scene();
    const WrongFrames frames = framesOf(hidden);
    support::DrawOptions options;
    options.width = options.height = size;
    const support::Drawn drawn = support::draw(*hidden.scene, *hidden.camera, options);
    const Apart error = apart(frames.truth(), drawn.floats(), frames.counted());
    std::printf("  largest error of the GPU's path: %.4f codes\n", error.codes);
    EXPECT_LT(error.codes, oneTenthCode);
    for (const Misconception& row : misconceptions())
        EXPECT_EQ(apart(drawn.floats(), frames.frame(row), frames.counted()).clearly(),
                  !row.right && concerns(row))
            << row.id << ": " << row.name;
}

}  // namespace
