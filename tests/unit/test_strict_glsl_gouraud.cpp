// The text of gouraud.vert and gouraud.frag on the CPU: the equation at a vertex, and what becomes of it on its way.
// SPDX-License-Identifier: MIT
#include "support/strict_glsl.hpp"
#include "support/strict_glsl_room.hpp"

#include <gtest/gtest.h>

namespace {

using support::infinite;
using support::NaN;
using support::Place;
using support::Room;
using support::StrictFragment;
using support::strictGouraudFragment;
using support::StrictGouraudVertex;
using support::strictGouraudVertex;
using support::u;

// Lights on both sides of a surface whose both sides are drawn.
struct TwoSidedRoom : Room {
    TwoSidedRoom() {
        material.side = THREE::DoubleSide;
        material.emissive.set(0.25, 0.5, 0.75);
        sun({1, 2, 3}, 0x8090A0);
        bulb({0.3, -0.4, 1.75}, 2);
        bulb({0.3, 0.4, -1.75}, 1.5);
        ambient(0x101820);
    }
};

// A vertex between its neighbours, when all are alike.
StrictGouraudVertex same(const glm::vec3& front, const glm::vec3& back, float metNonfinite = 0) {
    return {glm::vec4(0, 0, 0, 1), front, back, metNonfinite};
}

TEST(StrictGouraud, TheEquationIsAtTheVertexOnBothSides) {
    TwoSidedRoom room;
    lighting::FramePlan plan = room.plan();
    lighting::Draw& draw = plan.draws.at(0);
    for (const Place& place : support::places)
        for (const bool scaled : {false, true}) {
            draw.variant.scaled = scaled;
            const StrictGouraudVertex vertex = strictGouraudVertex(plan, draw, place.Q, place.normal);
            EXPECT_EQ(vertex.metNonfinite, 0);
            for (const bool front : {true, false}) {
                const StrictFragment found = strictGouraudFragment(draw, vertex, front);
                EXPECT_FALSE(found.nonfinite);
                glm::dvec3 strength;
                const glm::dvec3 expected =
                    support::byHand(room, place.Q, (front ? 1.0 : -1.0) * place.normal, strength);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(found.P[c], expected[c], 20 * u * strength[c])
                        << (scaled ? "scaled" : "plain") << " text, " << (front ? "front" : "back")
                        << ", Q.x " << place.Q.x << ", channel " << c;
            }
        }
}

TEST(StrictGouraud, AVertexIsWhereMeshVertPutsIt) {
    TwoSidedRoom room;
    room.plane.rotation.y = 0.6;
    const lighting::FramePlan plan = room.plan();
    for (const Place& place : support::places)
        EXPECT_EQ(strictGouraudVertex(plan, plan.draws.at(0), place.Q, place.normal).clip,
                  support::strictVertex(plan.draws[0], place.Q, place.normal).clip);
}

TEST(StrictGouraud, ASingleSidedSurfaceShowsItsFront) {
    Room room;
    room.sun({0, 0, 1}, 0xFFFFFF);
    const lighting::FramePlan plan = room.plan();
    EXPECT_EQ(strictGouraudFragment(plan.draws.at(0), same({1, 2, 3}, {4, 5, 6}), false).P,
              glm::vec3(1, 2, 3));
}

// In the scaled text colours travel 2^-32 times as large: no product with a depth leaves the range, and no digit is lost.
TEST(StrictGouraud, TheBrightestColorSurvivesItsWay) {
    TwoSidedRoom room;
    for (const auto& light : room.suns)
        light->intensity = 1e36;
    room.material.color.set(1, 1e4, 1e-30);
    lighting::FramePlan plan = room.plan();
    lighting::Draw& draw = plan.draws.at(0);
    ASSERT_TRUE(draw.variant.scaled);
    const StrictGouraudVertex vertex = strictGouraudVertex(plan, draw, {0, 0, 0}, {1, 2, 3});
    EXPECT_LT(vertex.frontColor.g, 1e30F);
    const StrictFragment found = strictGouraudFragment(draw, vertex);
    EXPECT_FALSE(found.nonfinite);
    EXPECT_NEAR(found.P.r, 1e36 * 0x80 / 255, 1e30);
    EXPECT_EQ(found.P.g, std::numeric_limits<float>::max());
    EXPECT_NEAR(found.P.b, 1e6 * 0xA0 / 255, 1);
}

TEST(StrictGouraud, ReportsNaNAndInfinity) {
    TwoSidedRoom room;
    lighting::FramePlan plan = room.plan();
    lighting::Draw& draw = plan.draws.at(0);
    for (const bool scaled : {false, true}) {
        SCOPED_TRACE(scaled ? "scaled text" : "plain text");
        draw.variant.scaled = scaled;
        const auto met = [&](const glm::dvec3& Q, const glm::dvec3& normal) {
            return strictGouraudVertex(plan, draw, Q, normal).metNonfinite > 0;
        };
        EXPECT_FALSE(met({0, 0, 0}, {0, 0, 1}));
        EXPECT_FALSE(met({0, 0, 0}, {0, 0, 0})) << "no normal";
        EXPECT_FALSE(met({0.3, -0.4, 1.75}, {0, 0, 1})) << "a light's own place";
        EXPECT_FALSE(met({0, 0, 2}, {0, 0, 1})) << "the eye's own place";
        EXPECT_TRUE(met({NaN, 0, 0}, {0, 0, 1}));
        EXPECT_TRUE(met({0, infinite, 0}, {0, 0, 1}));
        const auto between = [&](const StrictGouraudVertex& vertex) {
            return strictGouraudFragment(draw, vertex).nonfinite;
        };
        EXPECT_FALSE(between(same({1, 1, 1}, {1, 1, 1})));
        EXPECT_TRUE(between(same({1, 1, 1}, {1, 1, 1}, 0.01F))) << "near a vertex that met one";
        // In the scaled text, a colour that is no number belongs to no surface.
        EXPECT_EQ(between(same({1, NaN, 1}, {1, 1, 1})), !scaled);
    }
}

TEST(StrictGouraud, AVertexInTheEyeHasAFiniteHighlight) {
    for (const auto model : {THREE::SpecularModel::phong, THREE::SpecularModel::blinn}) {
        Room room;
        THREE::MeshPhongMaterial material(THREE::Color(0xFF8855));
        material.specularModel = model;
        room.sun({0.1, 0.2, 1}, 0xFFFFFF);
        room.plane.material = material;
        const lighting::FramePlan plan = room.plan();
        const StrictGouraudVertex vertex = strictGouraudVertex(plan, plan.draws.at(0), {0, 0, 2}, {0, 0, 1});
        EXPECT_EQ(vertex.metNonfinite, 0);
        EXPECT_GT(vertex.frontColor.r, 0.9F);
        EXPECT_LT(vertex.frontColor.r, 10) << "three.js has a factor of (s + 2) / 8 there";
    }
}

// Halfway between the opposite corners of the plane, which an edge of its triangles connects. At most 1 float apart on llvmpipe.
TEST(StrictGouraud, IsWhatTheDriverDraws) {
    for (const bool shiny : {false, true})
        for (const double intensity : {1.0, 1e36}) {  // the second in the scaled text
            Room room;
            THREE::MeshPhongMaterial material(THREE::Color(30, 20, 10));
            material.specular.set(shiny ? 0xC08040 : 0x000000);
            material.shininess = 2;
            room.plane.material = material;
            room.sun({1, 2, 3}, 0x8090A0, intensity);
            room.bulb({0.3, -0.4, 0.75}, 2);
            support::DrawOptions options{17, 17, true, {}};
            options.settings.shading = lighting::Shading::vertex;
            const support::Drawn drawn = support::draw(room.scene, room.camera, options);
            const lighting::Draw& draw = drawn.plan.draws.at(0);
            EXPECT_TRUE(draw.variant.perVertex);
            EXPECT_EQ(draw.variant.scaled, intensity > 1);
            const StrictGouraudVertex a = strictGouraudVertex(drawn.plan, draw, {3, 3, 0}, {0, 0, 1}),
                                      b = strictGouraudVertex(drawn.plan, draw, {-3, -3, 0}, {0, 0, 1});
            const glm::vec3 strict =
                strictGouraudFragment(draw, same(0.5F * (a.frontColor + b.frontColor), glm::vec3(0))).P;
            for (int c = 0; c < 3; ++c)
                EXPECT_LE(support::ulps(strict[c], drawn.at(8, 8)[c]), 4) << "channel " << c;
        }
}

}  // namespace
