// The probe against sums worked out by hand, and the cases that have no sum.
// SPDX-License-Identifier: MIT
#include "lab/live/numbered_lights.hpp"
#include "support/probed.hpp"

#include <ctime>
#include <gtest/gtest.h>
#include <random>

namespace {

using lab::ProbeReport;
using lab::SurfacePoint;
using lighting::Term;
using lighting::TermSet;
using lighting::reference::Sight;
using support::Floor;

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-12) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], expected[c], tolerance) << "channel " << c;
}

TEST(Probe, TheSumWorkedOutByHand) {
    Floor f;
    const ProbeReport r = f.middle();
    ASSERT_EQ(r.lights.size(), 2U);
    EXPECT_EQ(r.point->mesh, &f.floor);
    EXPECT_EQ(r.mesh, "Mesh 'floor'");
    EXPECT_EQ(r.pixel, (std::array<int, 2>{32, 32}));
    EXPECT_NEAR(r.place->x, 0.5, 1e-15);
    expectNear(r.probe.Q, {0, 0, 0});
    expectNear(r.probe.n, {0, 1, 0});
    expectNear(r.probe.v, {0, 2 / std::sqrt(13), 3 / std::sqrt(13)});
    const double g = 136.0 / 255, b = 85.0 / 255;
    // light 1: from (0, 3, -2)
    EXPECT_EQ(r.lights[0].number, 1);
    EXPECT_EQ(r.lights[0].name, "sun");
    EXPECT_TRUE(r.lights[0].directional);
    EXPECT_NEAR(r.lights[0].addend.cosine, 3 / std::sqrt(13), 1e-12);
    expectNear(r.lights[0].diffuse, glm::dvec3(1, g, b) * (3 / std::sqrt(13)));
    // light 2: d^2 = 4 + 2.25 + 25
    EXPECT_EQ(r.lights[1].number, 2);
    EXPECT_NEAR(r.lights[1].addend.d, std::sqrt(31.25), 1e-12);
    EXPECT_NEAR(r.lights[1].addend.cosine, 1.5 / std::sqrt(31.25), 1e-12);
    EXPECT_NEAR(r.lights[1].addend.f, 0.032, 1e-15);
    EXPECT_EQ(r.lights[1].decay, 2);
    const double factor = 1.5 / std::sqrt(31.25) * 0.032;
    expectNear(r.lights[1].diffuse, glm::dvec3(5, 10 * g, 2.5 * b) * factor);
    EXPECT_EQ(r.ambientLights, std::vector<int>{3});
    expectNear(r.probe.ambient, {0.1, 0.2 * g, 0.3 * b});
    expectNear(r.probe.P, r.lights[0].diffuse + r.lights[1].diffuse + r.probe.ambient);
    expectNear(r.probe.P, {0.974983, 0.596221, 0.384506}, 1e-6);
    EXPECT_EQ(r.code, (std::array<std::uint8_t, 3>{249, 152, 98}));
}

TEST(Probe, HighlightsAddUp) {
    Floor f;
    f.paint.specular = THREE::Color(0.5, 0.5, 0.25);
    f.paint.shininess = 4;
    const ProbeReport r = f.middle();
    // R of (0, 3, -2) is (0, 3, 2) / sqrt(13); v = (0, 2, 3) / sqrt(13): R . v = 12 / 13
    expectNear(r.lights[0].highlight, glm::dvec3(0.5, 0.5, 0.25) * std::pow(12.0 / 13, 4));
    glm::dvec3 sum = r.probe.ambient;
    for (const lab::ProbeLight& light : r.lights)
        sum += light.diffuse + light.highlight;
    expectNear(r.probe.P, sum);
    EXPECT_TRUE(r.shines());
}

TEST(Probe, LightsThatAreOffAreToldButNotCounted) {
    Floor f;
    const ProbeReport all = f.middle();
    const ProbeReport r = f.middle(TermSet::all().without(Term::directional));
    ASSERT_EQ(r.lights.size(), 2U);
    EXPECT_FALSE(r.lights[0].counted);
    EXPECT_TRUE(r.lights[1].counted);
    expectNear(r.lights[0].diffuse, all.lights[0].diffuse);
    expectNear(r.probe.P, all.probe.P - all.lights[0].diffuse);
}

TEST(Probe, NumbersAreThoseOfTheSceneAlsoOfInvisibleLights) {
    Floor f;
    f.sun.visible = false;
    const ProbeReport r = f.middle();
    ASSERT_EQ(r.lights.size(), 1U);
    EXPECT_EQ(r.lights[0].number, 2);
    const auto lights = lab::numberedLights(f.scene);
    ASSERT_EQ(lights.size(), 3U);
    EXPECT_FALSE(lights[0].visible);
    EXPECT_EQ(lights[2].number, 3);
    EXPECT_EQ(lights[2].light, &f.sky);
}

TEST(Probe, APinnedPointIsTheSameFromEverywhere) {
    Floor f;
    f.see();
    const SurfacePoint pin = *f.prober.point(20, 40);
    const ProbeReport before = *f.prober.at(20, 40);
    for (int i = 0; i < 12; ++i) {
        f.camera.position.setFromCylindricalCoords(3 + i, i, 1 + i);
        f.camera.lookAt(i == 5 ? 40 : 0, 0, 0);
        f.see();
        const ProbeReport now = *f.prober.at(pin);
        expectNear(now.probe.P, before.probe.P, 1e-11);
        expectNear(now.probe.n, before.probe.n);
        expectNear(now.probe.Q, before.probe.Q, 1e-11);
        ASSERT_EQ(now.pixel.has_value(), now.sight == Sight::visible);
        EXPECT_FALSE(now.centre);
        EXPECT_TRUE(before.centre);
        EXPECT_TRUE(i != 5 || now.sight == Sight::outside);
        if (!now.pixel)
            continue;
        // That pixel does show it: the point is less than a pixel from what the pixel's centre shows.
        const ProbeReport there = *f.prober.at((*now.pixel)[0], (*now.pixel)[1]);
        EXPECT_LT(std::abs(there.place->x - now.place->x), 0.6 / 65);
        EXPECT_LT(std::abs(there.place->y - now.place->y), 0.6 / 65);
    }
}

TEST(Probe, APinnedPointGoesWithItsMesh) {
    Floor f;
    f.see();
    const SurfacePoint pin = *f.prober.point(20, 40);
    const glm::dvec3 Q = f.prober.at(pin)->probe.Q;
    f.floor.position.set(0.25, -0.5, 0.125);
    f.see();
    expectNear(f.prober.at(pin)->probe.Q, Q + glm::dvec3(0.25, -0.5, 0.125));
    f.floor.visible = false;
    f.see();
    EXPECT_FALSE(f.prober.at(pin));
    EXPECT_EQ(f.prober.at(32, 32)->probe.mesh, nullptr);
}

TEST(Probe, SomethingInFrontHidesIt) {
    Floor f;
    f.see();
    const SurfacePoint pin = *f.prober.point(32, 32);
    THREE::BoxGeometry cube(0.2, 0.2, 0.2);
    THREE::Mesh box(cube, f.paint);
    box.position.set(0, 1, 1.5);
    f.scene.add(box);
    f.see();
    const ProbeReport hidden = *f.prober.at(pin);
    EXPECT_EQ(hidden.sight, Sight::hidden);
    EXPECT_FALSE(hidden.pixel);
    EXPECT_NEAR(hidden.place->x, 0.5, 1e-9);
    EXPECT_EQ(f.prober.at(32, 32)->point->mesh, &box);
}

TEST(Probe, TheBackgroundAndUnlitSurfaces) {
    Floor f;
    f.scene.background = THREE::Color(0.25, 0.5, 2);
    THREE::MeshBasicMaterial plain(THREE::Color(0.5, 0.25, 0.125));
    f.floor.material = plain;
    ProbeReport r = f.middle();
    EXPECT_TRUE(r.lights.empty());
    EXPECT_FALSE(r.probe.lit);
    expectNear(r.probe.P, {0.5, 0.25, 0.125});
    f.scene.remove(f.floor);
    r = f.middle();
    EXPECT_FALSE(r.point);
    expectNear(r.probe.P, {0.25, 0.5, 2});
    expectNear(r.clamped, {0.25, 0.5, 1});
    EXPECT_EQ(r.code, (std::array<std::uint8_t, 3>{64, 128, 255}));
}

TEST(Probe, ALightInTheVeryPointAddsNothing) {
    Floor f;
    f.see();
    const SurfacePoint pin{&f.floor, 0, {0.25, 0.25, 0.5}};
    f.bulb.position = f.prober.at(pin)->probe.Q;
    f.see();
    const ProbeReport r = *f.prober.at(pin);
    EXPECT_EQ(r.lights[1].addend.w, glm::dvec3(0));
    EXPECT_EQ(r.lights[1].diffuse, glm::dvec3(0));
    expectNear(r.probe.P, r.lights[0].diffuse + r.probe.ambient);
}

TEST(Probe, NoPixelNoAnswer) {
    Floor f;
    EXPECT_FALSE(f.prober.at(0, 0)) << "before see()";
    EXPECT_FALSE(f.prober.at(SurfacePoint{}));
    f.see();
    for (const auto& [x, y] : {std::pair(-1, 0), {0, -1}, {65, 0}, {0, 65}, {1 << 30, 1 << 30}}) {
        EXPECT_FALSE(f.prober.at(x, y));
        EXPECT_FALSE(f.prober.point(x, y));
    }
    EXPECT_TRUE(f.prober.at(64, 64));
    EXPECT_FALSE(f.prober.at(SurfacePoint{&f.floor, 1000000, {1, 0, 0}}));
    f.prober.see(f.scene, f.camera, {}, 0, 0);
    EXPECT_FALSE(f.prober.at(0, 0)) << "minimised";
}

// A lesson's knot: a move of the mouse must not be felt, whether the scene moves meanwhile or not.
TEST(Probe, IsQuick) {
    Floor f;
    THREE::TorusKnotGeometry shape(0.9, 0.34, 400, 64);
    THREE::Mesh knot(shape, f.paint);
    f.scene.add(knot);
    std::clock_t best = CLOCKS_PER_SEC;
    for (int i = 0; i < 5; ++i) {
        f.see({}, 1025);
        const std::clock_t start = std::clock();
        EXPECT_TRUE(f.prober.at(512, 512 + i)->point);
        best = std::min(best, std::clock() - start);
    }
    EXPECT_LT(best, CLOCKS_PER_SEC * 60 / 1000) << "about 4 ms where it is optimised";
}

}  // namespace
