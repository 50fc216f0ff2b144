// Lights that end: left out of the meshes that they do not reach, or, where there are many, of parts of the picture.
// SPDX-License-Identifier: MIT
#include "support/both_ways.hpp"
#include "support/judge.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <random>

namespace {

using lighting::LightStorage;
using support::BothWays;

// Boxes in a row, above a floor if a test wants one.
struct Row : testing::Test {
    THREE::Scene scene;
    THREE::Group all;
    THREE::BoxGeometry boxGeometry{1, 1, 1};
    THREE::MeshPhongMaterial shiny{THREE::Color(0xFF8855)};
    THREE::PlaneGeometry floorGeometry{60, 60, 2, 2};
    THREE::MeshLambertMaterial blue{THREE::Color(0x7788AA)};
    THREE::Mesh floor{floorGeometry, blue};
    std::vector<std::unique_ptr<THREE::Mesh>> boxes;
    std::vector<std::unique_ptr<THREE::PointLight>> lamps;
    THREE::AmbientLight ambient{THREE::Color(0x101010)};
    THREE::PerspectiveCamera camera{50, 1, 0.1, 500};
    support::DrawOptions options;

    Row() {
        scene.add(all);
        all.add(ambient);
        floor.rotation.x = -std::acos(0.0);
        floor.position.y = -0.5;
        options.width = 72;
        options.height = 40;
        look({0, 4, 14}, {0, 0, 0});
    }
    void look(const THREE::Vector3& from, const THREE::Vector3& at) {
        camera.position = from;
        support::lookAt(camera, at, options);
    }
    THREE::Mesh& box(double x, double z = 0) {
        boxes.push_back(std::make_unique<THREE::Mesh>(boxGeometry, shiny));
        boxes.back()->position.set(x, 0, z);
        all.add(*boxes.back());
        return *boxes.back();
    }
    THREE::PointLight& lamp(const THREE::Vector3& place, double distance, double k = 2,
                            double intensity = 1) {
        lamps.push_back(std::make_unique<THREE::PointLight>(THREE::Color(0xDDAA66), intensity, distance, k));
        lamps.back()->position = place;
        all.add(*lamps.back());
        return *lamps.back();
    }
    BothWays bothWays() { return support::drawBothWays(scene, camera, options); }
};

TEST_F(Row, TwoGroupsOfMeshesAndLamps) {
    for (int i = 0; i < 6; ++i) {
        box(i < 3 ? -6 + i : 4 + i - 3);
        lamp({i < 3 ? -6.0 + i : 4.0 + i - 3, 1.5, 0.5}, 3, i % 3);
    }
    lamp({0, 5, 5}, 0, 0, 0.2);
    const BothWays both = bothWays();
    EXPECT_EQ(both.skipped.stats.pairsSkipped, 6 * 3);
    EXPECT_EQ(both.whole.stats.pairsSkipped, 0);
    EXPECT_EQ(both.skipped.stats.lightsSkipped, 0);
    for (const lighting::Draw& draw : both.skipped.plan.draws) {
        EXPECT_EQ(draw.variant.point(), 4);
        EXPECT_TRUE(both.tells(*draw.mesh, "3/7 point lights end before it"));
    }
    for (const lighting::Draw& draw : both.whole.plan.draws)
        EXPECT_EQ(draw.variant.point(), 7);
    EXPECT_EQ(both.skipped.stats.clusters, 0U);
    options.settings.terms = options.settings.terms.without(lighting::Term::attenuation);
    EXPECT_EQ(bothWays().skipped.stats.pairsSkipped, 0) << "f = 1: nothing ends";
}

TEST_F(Row, LampsThatReachNothing) {
    box(0);
    lamp({0, 2, 0}, 4);
    THREE::PointLight& lost = lamp({30, 2, 0}, 4);
    const BothWays both = bothWays();
    EXPECT_TRUE(both.tells(lost, "it ends before every mesh"));
    EXPECT_EQ(both.skipped.stats.lightsSkipped, 1);
    EXPECT_EQ(both.skipped.stats.lightsUsed, 2);
    EXPECT_EQ(both.skipped.plan.draws.at(0).variant.point(), 1);
    lost.position.x = 0.5 + 4 + 1e-3;
    lost.position.y = 0;
    EXPECT_TRUE(bothWays().tells(lost, "it ends before every mesh"));
    lost.position.x = 0.5 + 4 - 1e-3;
    EXPECT_FALSE(bothWays().tells(lost, "it ends before every mesh"));
}

// Lamps that end just where a mesh begins: on whichever side of the border the roundings fall, the bytes are the same.
TEST_F(Row, LampsThatEndAtTheSurface) {
    box(0).scale.set(1000, 1, 1000);
    look({0, 300, 800}, {0, 0, 0});
    for (const double distance : {0.01, 1.0, 100.0})
        for (const double gap : {-1e-2, -1e-4, -1e-6, 0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
            SCOPED_TRACE(testing::Message() << "distance " << distance << ", gap " << gap);
            lamps.clear();
            for (int i = 0; i < 5; ++i)
                lamp({100.0 * i - 200, 0.5 + distance * (1 + gap), 10.0 * i}, distance, i % 3, 1e12);
            bothWays();
        }
}

TEST_F(Row, ManyDifferentSumsAreClusters) {
    for (int i = 0; i < 12; ++i) {
        box(1.5 * i - 8);
        lamp({1.5 * i - 8, 1.2, 0}, 1.1);
    }
    lamp({0, 6, 5}, 0, 1, 0.3);
    const BothWays both = bothWays();
    EXPECT_GT(both.skipped.stats.clusters, 1U);
    EXPECT_GT(both.skipped.stats.clusterEntries, 12U);
    EXPECT_EQ(both.whole.stats.clusters, 1U);
    EXPECT_EQ(both.whole.stats.clusterEntries, 12U) << "every fragment asks every lamp";
    const lighting::Variant& v = both.skipped.plan.draws.at(0).variant;
    EXPECT_EQ(v.storage, LightStorage::texture);
    EXPECT_EQ(v.clustered, 1U << 2U);
    EXPECT_EQ(v.point(), 1) << "the one that shines everywhere";
}

// A cloud of lamps in and around the scene, of all exponents, some without an end.
struct Cloud : Row {
    std::mt19937 random{7};
    double any(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    double anyOctave(double low, double high) { return std::exp2(any(std::log2(low), std::log2(high))); }
    THREE::DirectionalLight sun{THREE::Color(0x404030)};

    Cloud() {
        all.add(floor, sun);
        for (int i = 0; i < 7; ++i) {
            box(3 * i - 9, any(-8, 8)).rotation.set(any(-3, 3), any(-3, 3), 0);
            boxes.back()->position.y = any(0, 2);
        }
    }
    void fill(int count, double nearest, double farthest) {
        static constexpr double exponents[] = {0, 1, 2, 2, 2, 1.5, 4};
        for (int i = 0; i < count; ++i)
            lamp({any(-20, 20), any(-0.6, 4), any(-20, 20)}, i % 50 == 0 ? 0 : anyOctave(nearest, farthest),
                 exponents[i % 7], 40.0 / count);
    }
    // From many places: among the lamps, above them, far away and close to the floor.
    void fromEverywhere(const std::function<void()>& check) {
        const struct {
            double fov;
            THREE::Vector3 from, at;
            int width, height;
        } views[] = {{50, {0, 4, 14}, {0, 0, 0}, 72, 40},   {100, {1, 0.3, 2}, {-3, 0, -9}, 40, 70},
                     {3, {60, 40, 100}, {0, 0, 0}, 50, 50}, {140, {-5, 1, 3}, {5, 0.2, 0}, 64, 20},
                     {40, {0, 30, 0.1}, {0, 0, 0}, 48, 48}, {60, {-15, -0.49, 0}, {9, -0.3, 1}, 70, 30}};
        for (const auto& view : views) {
            SCOPED_TRACE(testing::Message() << "fov " << view.fov);
            camera.fov = view.fov;
            options.width = view.width;
            options.height = view.height;
            look(view.from, view.at);
            check();
        }
    }
};

TEST_F(Cloud, OfThreeHundredFromEverywhere) {
    fill(300, 0.05, 100);
    fromEverywhere([this] {
        const BothWays both = bothWays();
        EXPECT_GT(both.skipped.stats.clusters, 1U);
        EXPECT_EQ(both.skipped.plan.draws.at(0).variant.clustered, 15U) << "all four kinds of exponents";
        EXPECT_EQ(both.skipped.plan.draws.at(0).variant.point(), 6);
        EXPECT_EQ(both.whole.stats.clusterEntries, 294U);
    });
}

TEST_F(Cloud, OfTwoThousand) {
    fill(2000, 0.3, 2);
    const BothWays both = bothWays();
    EXPECT_LT(both.skipped.stats.clusterEntries,
              both.skipped.stats.clusters * both.whole.stats.clusterEntries / 10)
        << "a fragment asks few of them";
    look({0, 0.5, 3}, {4, 0, -3});
    bothWays();
}

TEST_F(Cloud, InViewSpaceAndWithoutSomeTerms) {
    fill(300, 0.1, 10);
    options.settings.space = lighting::Space::view;
    EXPECT_GT(bothWays().skipped.stats.clusters, 1U);
    for (int i = 0; i < lighting::termCount; ++i) {
        const auto term = static_cast<lighting::Term>(i);
        SCOPED_TRACE(lighting::info(term).name);
        options.settings.terms = lighting::TermSet::all().without(term);
        const bool ends = term != lighting::Term::attenuation && term != lighting::Term::point;
        EXPECT_EQ(bothWays().skipped.stats.clusters > 0, ends) << "without f(d) nothing ends";
    }
}

TEST_F(Cloud, SeenByACameraInAScaledGroup) {
    fill(300, 0.1, 10);
    THREE::Group rig;
    rig.add(camera);
    rig.scale.set(2, 2, 2);
    rig.rotation.y = 0.4;
    rig.position.set(1, 0.5, 0);
    scene.add(rig);
    look({0, 2, 7}, {0, 0, 0});
    for (const auto space : {lighting::Space::world, lighting::Space::view}) {
        options.settings.space = space;
        EXPECT_GT(bothWays().skipped.stats.clusters, 1U);
    }
    rig.scale.set(1, 3, 0.5);
    bothWays();
}

TEST_F(Cloud, InScenesOfAnySize) {
    for (const double size : {1e-6, 0x1p-30, 1e6, 0x1p40}) {
        SCOPED_TRACE(size);
        lamps.clear();
        fill(280, 0.2, 20);
        all.scale.setScalar(size);
        for (const auto& light : lamps) {
            light->distance *= size;
            light->decay = std::min(light->decay, 2.0);  // what else it would take is beyond 1e36
            light->intensity *= std::pow(size, light->decay);
        }
        camera.near = 0.1 * size;
        camera.far = 500 * size;
        look(THREE::Vector3(0, 4, 14).multiplyScalar(size), {0, 0, 0});
        EXPECT_GT(bothWays().skipped.stats.clusters, 1U);
    }
}

// Walls at one depth, far away: slices would be thinner than floats can tell depths apart.
TEST_F(Cloud, OnAWallThatFacesTheCamera) {
    for (const auto& mesh : boxes)
        all.remove(*mesh);
    for (const double depth : {10.0, 1000.0, 1e6})
        for (const double tilt : {0.0, 1e-6, 1e-4, 1e-2}) {
            SCOPED_TRACE(testing::Message() << "depth " << depth << ", tilt " << tilt);
            lamps.clear();
            floor.rotation.set(tilt, tilt / 2, 0);
            floor.position.set(0, 0, -depth);
            camera.fov = 50 / depth * 10;
            camera.near = depth / 1000;
            camera.far = 2 * depth;
            look({0, 0, 0}, {0, 0, -depth});
            for (int i = 0; i < 400; ++i) {
                const double distance = anyOctave(0.01, 3);
                lamp({any(-6, 6), any(-4, 4), -depth + any(-1, 1) * distance}, distance, i % 3, 1e6);
            }
            bothWays();
        }
}

// A floor from under the camera to the horizon: depths of 1e7 to 1 in one triangle.
TEST_F(Cloud, OnAFloorToTheHorizon) {
    for (const auto& mesh : boxes)
        all.remove(*mesh);
    for (const double size : {1e3, 1e5}) {
        SCOPED_TRACE(size);
        lamps.clear();
        floor.scale.set(size, size, 1);
        camera.near = 1e-3;
        camera.far = 1e7;
        floor.position.set(0, -3, 0);
        look({0, -2.9, 5}, {0.3, -2.95, 0});
        for (int i = 0; i < 600; ++i) {
            const double z = -anyOctave(0.1, 20 * size), distance = anyOctave(0.02, 1) * std::abs(z);
            lamp({any(-0.5, 0.5) * z, -3 + any(0, 1) * distance, z}, distance, i % 3, 1e6);
        }
        bothWays();
    }
}

}  // namespace
