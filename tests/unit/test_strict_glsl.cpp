// The shaders' own text on the CPU, against the equation by hand and against what the driver draws.
// SPDX-License-Identifier: MIT
#include "support/strict_glsl.hpp"

#include "support/strict_glsl_room.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace {

using support::byHand;
using support::infinite;
using support::NaN;
using support::Place;
using support::places;
using support::Room;
using support::StrictFragment;
using support::strictFragment;
using support::StrictVertex;
using support::strictVertex;
using support::u;
using support::ulps;

// Every place of the room in both texts, plain and scaled. Q is exact in float, the normal is taken as rounded.
void expectAsByHand(Room& room, bool front = true) {
    lighting::FramePlan plan = room.plan();
    ASSERT_EQ(plan.draws.size(), 1U);
    lighting::Draw& draw = plan.draws[0];
    EXPECT_FALSE(draw.variant.scaled) << "the planner calls this scene extreme";
    for (const Place& place : places) {
        const glm::vec3 normal(place.normal), Q((place.Q - plan.anchor) / plan.unit);
        ASSERT_EQ(glm::dvec3(Q) * plan.unit + plan.anchor, place.Q);
        glm::dvec3 strength;
        const glm::dvec3 expected =
            byHand(room, place.Q, (front ? 1.0 : -1.0) * glm::dvec3(normal), strength);
        for (const bool scaled : {false, true}) {
            draw.variant.scaled = scaled;
            const StrictFragment found = strictFragment(plan, draw, Q, normal, front);
            EXPECT_FALSE(found.nonfinite);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(found.P[c], expected[c], 20 * u * strength[c])
                    << (scaled ? "scaled" : "plain") << " text, Q.x " << place.Q.x << ", channel " << c;
        }
    }
}

TEST(StrictFragment, DirectionalLights) {
    Room room;
    room.sun({1, 2, 3}, 0x8090A0);
    room.sun({-3, 0.1, 1}, 0xFFEEDD, 0.7);
    room.sun({0, 0, -1}, 0xFFFFFF);
    expectAsByHand(room);
}

TEST(StrictFragment, PointLightsOfEveryExponent) {
    for (const double k : {0.0, 1.0, 2.0, 1.5, 0.3, 3.0}) {
        SCOPED_TRACE(k);
        Room room;
        room.bulb({0.3, -0.4, 1.75}, k);
        expectAsByHand(room);
    }
}

TEST(StrictFragment, PointLightsBesideEachOther) {
    Room room;
    room.sun({1, 2, 3}, 0x404040);
    for (const double k : {2.0, 1.5, 0.0, 1.0, 2.0})
        room.bulb({k - 1, -0.4, 2 + k}, k);
    expectAsByHand(room);
}

TEST(StrictFragment, AWindowEndsTheLight) {
    for (const double k : {0.0, 2.0}) {
        Room room;
        room.bulb({0.3, -0.4, 1.75}, k, 3);
        expectAsByHand(room);
        const lighting::FramePlan plan = room.plan();
        EXPECT_EQ(strictFragment(plan, plan.draws[0], {9, 0, 0}, {0, 0, 1}).P, glm::vec3(0));
    }
}

TEST(StrictFragment, AmbientAndEmissive) {
    Room room;
    room.ambient(0x101820);
    room.material.emissive.set(0.25, 0.5, 0.75);
    room.sun({1, 1, 1}, 0xFFFFFF);
    expectAsByHand(room);
}

TEST(StrictFragment, TheBackOfADoubleSidedSurfaceTurnsTheNormal) {
    Room room;
    room.material.side = THREE::DoubleSide;
    room.sun({1, 2, 3}, 0x8090A0);
    room.bulb({0.3, -0.4, -1.75}, 2);
    expectAsByHand(room, true);
    expectAsByHand(room, false);
}

TEST(StrictFragment, ASingleSidedSurfaceHasOneNormal) {
    Room room;
    room.sun({0, 0, 1}, 0xFFFFFF);
    const lighting::FramePlan plan = room.plan();
    EXPECT_GT(strictFragment(plan, plan.draws[0], {0, 0, 0}, {0, 0, 1}, false).P.r, 0);
}

TEST(StrictFragment, ReportsNaNAndInfinity) {
    Room room;
    room.sun({0, 0, 1}, 0xFFFFFF);
    room.bulb({0, 0, 1}, 2);
    lighting::FramePlan plan = room.plan();
    for (const bool scaled : {false, true}) {
        SCOPED_TRACE(scaled ? "scaled text" : "plain text");
        plan.draws[0].variant.scaled = scaled;
        const auto met = [&plan](const glm::vec3& Q, const glm::vec3& normal) {
            return strictFragment(plan, plan.draws[0], Q, normal).nonfinite;
        };
        EXPECT_FALSE(met({0, 0, 0}, {0, 0, 1}));
        EXPECT_FALSE(met({0, 0, 0}, {0, 0, 0})) << "a normal that vanishes";
        EXPECT_FALSE(met({0, 0, 1}, {0, 0, 1})) << "the light's own place";
        EXPECT_TRUE(met({0, 0, 0}, {0, NaN, 1}));
        EXPECT_TRUE(met({0, 0, 0}, {0, infinite, 1}));
        // In the scaled text, a position that is no number belongs to no surface.
        EXPECT_EQ(met({NaN, 0, 0}, {0, 0, 1}), !scaled);
        EXPECT_EQ(met({0, 0, -infinite}, {0, 0, 1}), !scaled);
    }
}

TEST(StrictFragment, ReportsNaNFromThePlan) {
    Room room;
    room.sun({0, 0, 1}, 0xFFFFFF);
    room.bulb({0, 0, 1}, 2);
    room.ambient(0x101010);
    lighting::FramePlan plan = room.plan();
    lighting::Draw& draw = plan.draws.at(0);
    const auto met = [&] { return strictFragment(plan, draw, {0, 0, 0}, {0, 0, 1}).nonfinite; };
    for (double* const number : {&plan.directional.at(0).w.y, &plan.point.at(0).color.g, &plan.ambient.b,
                                 &draw.albedo.r, &draw.emitted.r}) {
        EXPECT_FALSE(met());
        const double good = std::exchange(*number, NaN);
        EXPECT_TRUE(met()) << "instead of " << good;
        *number = good;
    }
}

// d2 > 0.0 is false for it, in both texts; watch() need not have seen it.
TEST(StrictFragment, ALightThatStandsNowhereAddsNothing) {
    Room room;
    room.bulb({0, 0, 1}, 2);
    room.ambient(0x101010);
    lighting::FramePlan plan = room.plan();
    plan.point.at(0).position.x = NaN;
    for (const bool scaled : {false, true}) {
        plan.draws.at(0).variant.scaled = scaled;
        const glm::vec3 ambient = glm::vec3(plan.draws[0].albedo) * glm::vec3(plan.ambient);
        EXPECT_EQ(strictFragment(plan, plan.draws[0], {0, 0, 0}, {0, 0, 1}).P, ambient);
    }
}

TEST(StrictFragment, TheScaledTextHoldsWhereThePlainOneLeavesTheRange) {
    for (const auto& [away, reach] : {std::pair(1e-25, 0.0), {1e25, 0.0}, {1e25, 2e25}}) {
        SCOPED_TRACE(testing::Message() << "light " << away << " away, distance " << reach);
        Room room;
        room.bulb({0.3 * away, -0.4 * away, away}, 0, reach);
        lighting::FramePlan plan = room.plan();
        glm::dvec3 strength;
        const glm::dvec3 expected = byHand(room, {0, 0, 0}, {0, 0, 1}, strength);
        plan.draws.at(0).variant.scaled = false;
        EXPECT_LT(strictFragment(plan, plan.draws[0], {0, 0, 0}, {0, 0, 1}).P.r, 0.5 * expected.r);
        plan.draws[0].variant.scaled = true;
        const StrictFragment found = strictFragment(plan, plan.draws[0], {0, 0, 0}, {0, 0, 1});
        EXPECT_FALSE(found.nonfinite);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found.P[c], expected[c], 20 * u * strength[c]);
    }
}

// The most that the two texts differ by, from very near to very far. The window ends at `reach` times that far.
int scaledAgainstPlain(double decay, double reach) {
    int most = 0;
    for (double away = 1e-4; away < 1e4; away *= 1.7) {
        Room room;
        room.bulb({0.3 * away, -0.4 * away, away}, decay, reach * away);
        lighting::FramePlan plan = room.plan();
        plan.draws.at(0).variant.scaled = false;
        const glm::vec3 plain = strictFragment(plan, plan.draws[0], {0, 0, 0}, {0.1F, 0, 1}).P;
        plan.draws[0].variant.scaled = true;
        const glm::vec3 scaled = strictFragment(plan, plan.draws[0], {0, 0, 0}, {0.1F, 0, 1}).P;
        for (int c = 0; c < 3; ++c)
            most = std::max(most, ulps(plain[c], scaled[c]));
    }
    return most;
}

TEST(StrictFragment, TheScaledTextIsThePlainOneWhereBothAreInRange) {
    for (const double k : {0.0, 1.0, 2.0}) {
        EXPECT_EQ(scaledAgainstPlain(k, 0), 0) << "only powers of two differ, k " << k;
        EXPECT_LE(scaledAgainstPlain(k, 1.5), 12) << "6 measured; with a window, k " << k;
    }
    for (const double k : {0.3, 1.5, 3.0})
        EXPECT_LE(scaledAgainstPlain(k, 0), 30)
            << "14 measured; through log2 and exp2 instead of pow, k " << k;
}

TEST(StrictVertex, NormalsHaveLengthOneWhateverTheMatrix) {
    Room room;
    room.ambient(0xFFFFFF);
    lighting::FramePlan plan = room.plan();
    lighting::Draw& draw = plan.draws.at(0);
    for (const double factor : {1e-37, 1e-20, 1.0, 1e20, 1e37}) {
        draw.normalMatrix = glm::dmat3(factor);
        EXPECT_EQ(strictVertex(draw, {0, 0, 0}, {0, 0, 3}).worldNormal, glm::vec3(0, 0, 1)) << factor;
    }
}

TEST(StrictVertex, GoesWhereTheMatricesSay) {
    Room room;
    room.plane.position.set(1000, -3, 0.5);
    room.plane.rotation.y = 0.6;
    room.plane.scale.set(2, 1, 0.5);
    room.camera.position.set(1000, -3, 4);
    lighting::Settings settings;
    settings.focus = {1000, -3, 0.5};
    const lighting::FramePlan plan = room.plan(settings);
    const lighting::Draw& draw = plan.draws.at(0);
    const glm::dvec3 position(0.7, -1.1, 0.3), normal(3, 1, 2);
    const StrictVertex found = strictVertex(draw, position, normal);
    const glm::dvec4 local(position - draw.origin, 1);
    const glm::dvec4 clip = draw.clip * local, world = draw.model * local;
    const glm::dvec3 n = glm::normalize(draw.normalMatrix * normal);
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(found.clip[i], clip[i], 50 * u) << i;
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(found.worldPosition[i], world[i], 50 * u) << i;
        EXPECT_NEAR(found.worldNormal[i], n[i], 10 * u) << i;
    }
    EXPECT_EQ(strictVertex(draw, position, {0, 0, 0}).worldNormal, glm::vec3(0));
}

// The middle pixel of an odd-sized frame sees the plane's own origin.
void expectAsDrawn(Room& room, int bound) {
    const support::Drawn drawn = support::draw(room.scene, room.camera, {17, 17, true, {}});
    const lighting::Draw& draw = drawn.plan.draws.at(0);
    const StrictVertex middle = strictVertex(draw, {0, 0, 0}, {0, 0, 1});
    const glm::vec3 strict = strictFragment(drawn.plan, draw, middle.worldPosition, middle.worldNormal).P;
    const glm::vec3 pixel = drawn.at(8, 8);
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(strict[c], 0);
        EXPECT_LE(ulps(strict[c], pixel[c]), bound) << strict[c] << " and " << pixel[c] << ", channel " << c;
    }
}

// On llvmpipe: the same bits, but for exponents that go through pow, 2 floats apart.
TEST(StrictFragment, IsWhatTheDriverDraws) {
    for (const double k : {0.0, 1.0, 2.0, 1.5})
        for (const double distance : {0.0, 3.0}) {
            SCOPED_TRACE(testing::Message() << "point light, k " << k << ", distance " << distance);
            Room room;
            room.bulb({0.3, -0.4, 0.75}, k, distance);
            expectAsDrawn(room, k == 1.5 ? 8 : 2);
        }
    Room sunny;
    sunny.sun({1, 2, 3}, 0x8090A0);
    expectAsDrawn(sunny, 2);
    Room dim;
    dim.ambient(0x123456);
    expectAsDrawn(dim, 0);
}

}  // namespace
