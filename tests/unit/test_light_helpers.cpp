// Signs of lights and the mouse that drags them.
// SPDX-License-Identifier: MIT
#include "lab/live/light_drag.hpp"
#include "lab/live/light_helpers.hpp"
#include "three/three.hpp"
#include "three/validate.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace {

using lab::LightDrag;
using lab::LightHelper;
using lab::PanelPoint;
using lab::Projection;
using THREE::Vector3;

struct Lamps {
    THREE::Scene scene;
    THREE::PerspectiveCamera camera{45, 1.5, 0.1, 100};
    THREE::AmbientLight sky;
    THREE::DirectionalLight sun;
    THREE::PointLight bulb;
    THREE::Group arm;
    Vector3 focus{0.25, 0.5, 0};

    Lamps() {
        sun.position.set(0, 3, -2);
        bulb.position.set(2, 1.5, 1);
        arm.add(bulb);
        scene.add(sky, sun, arm);
        camera.position.set(1, 2, 6);
        camera.lookAt(focus);
        update();
    }
    void update() {
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
    }
    std::vector<LightHelper> helpers() {
        update();
        return lab::lightHelpers(scene, camera, focus);
    }
    lab::LightMarks marks() { return lab::lightMarks(helpers(), camera, {}, lab::Language::en); }
    // Where the handle of a light is; far away if it has none.
    PanelPoint handle(const std::string& name) {
        for (const lab::PanelHandle& h : marks().handles)
            if (h.name == name)
                return h.at;
        return {1e9, 1e9};
    }
};

void expectAt(const PanelPoint& found, const PanelPoint& expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-9);
    EXPECT_NEAR(found.y, expected.y, 1e-9);
}

TEST(LightHelpers, AnOctahedronWhereAPointLightIs) {
    Lamps l;
    const LightHelper bulb = l.helpers().at(1);
    EXPECT_EQ(bulb.number, 3);
    EXPECT_EQ(bulb.light, &l.bulb);
    EXPECT_EQ(bulb.place, Vector3(2, 1.5, 1));
    ASSERT_EQ(bulb.segments.size(), 12U) << "the edges of three.js's sphere of 4 x 2";
    const double radius = Vector3(bulb.segments[0].from).sub(bulb.place).length();
    Vector3 sum;
    for (const lab::Segment& s : bulb.segments) {
        EXPECT_NEAR(Vector3(s.from).sub(bulb.place).length(), radius, 1e-12);
        EXPECT_NEAR(Vector3(s.from).sub(s.to).length(), radius * std::sqrt(2), 1e-12);
        sum.add(Vector3(s.from).add(s.to));
    }
    EXPECT_NEAR(sum.multiplyScalar(1.0 / 24).sub(bulb.place).length(), 0, 1e-12);
}

TEST(LightHelpers, ASquareThatFacesTheFocusForDirectionalLight) {
    Lamps l;
    const LightHelper sun = l.helpers().at(0);
    EXPECT_EQ(sun.number, 2);
    const Vector3 w = Vector3(0, 3, -2).normalize();
    const Vector3 offset = Vector3(sun.place).sub(l.focus);
    EXPECT_NEAR(offset.length(), lab::helperRadius(l.camera, l.focus), 1e-12);
    EXPECT_NEAR(Vector3(offset).normalize().dot(w), 1, 1e-12);
    ASSERT_EQ(sun.segments.size(), 5U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(Vector3(sun.segments[i].from).sub(sun.place).dot(w), 0, 1e-12) << "at right angles";
        EXPECT_EQ(sun.segments[i].to, sun.segments[(i + 1) % 4].from);
    }
    EXPECT_EQ(sun.segments[4].from, sun.place);
    EXPECT_EQ(sun.segments[4].to, l.focus);
    // From straight above lookAt has no side to choose, and still finds one.
    l.sun.position.set(0, 1, 0);
    const LightHelper above = l.helpers().at(0);
    for (const lab::Segment& s : above.segments)
        EXPECT_TRUE(std::isfinite(s.from.x + s.from.y + s.from.z));
}

TEST(LightHelpers, TheyShowTheLightsAsTheyAre) {
    Lamps l;
    const PanelPoint before = l.handle("light 3");
    l.arm.position.x = -1;
    EXPECT_LT(l.handle("light 3").x, before.x);
    l.sun.visible = false;
    EXPECT_EQ(l.helpers().size(), 1U);
    EXPECT_EQ(l.marks().handles.size(), 1U);
    EXPECT_EQ(l.marks().handles[0].name, "light 3") << "numbers stay";
    EXPECT_EQ(l.handle("light 1").x, 1e9) << "ambient light is nowhere";
    l.arm.position.z = 20;
    EXPECT_TRUE(l.helpers().empty()) << "behind the camera";
}

TEST(LightHelpers, SignsHaveTheSameSizeAtAnyDistance) {
    Lamps l;
    const auto size = [&l] {
        const LightHelper bulb = l.helpers().at(1);
        const Projection projection(l.camera);
        const auto top = projection.point(Vector3(bulb.segments[1].from)),
                   middle = projection.point(bulb.place);
        return std::abs(top->y - middle->y);
    };
    l.camera.position.set(2, 1.5, 6);
    l.camera.lookAt(2, 1.5, 1);
    const double near = size();
    l.camera.position.set(2, 1.5, 90);
    EXPECT_NEAR(near, 0.025, 1e-9);
    EXPECT_NEAR(size(), near, 1e-9);
}

TEST(LightDrag, APointLightStaysUnderTheMouseAtItsDepth) {
    Lamps l;
    l.arm.rotation.set(0.3, 0.5, -0.2);
    l.arm.scale.set(1, -2, 0.5);
    l.arm.position.set(0.5, -0.25, 0.125);
    l.bulb.position.set(0.1, -0.2, 0.3);
    l.update();
    const double depth = Projection(l.camera).view(l.bulb.matrixWorld.position()).z;
    LightDrag drag(l.bulb, l.camera, l.focus);
    for (const PanelPoint at : {PanelPoint{0.1, 0.2}, {0.9, 0.7}, {0.5, 0.5}, {0.01, 0.99}}) {
        ASSERT_TRUE(drag.to(at));
        expectAt(l.handle("light 3"), at);
        EXPECT_NEAR(Projection(l.camera).view(l.bulb.matrixWorld.position()).z, depth, 1e-9);
    }
}

TEST(LightDrag, ADirectionalLightTurnsWithItsLengthKept) {
    Lamps l;
    const double length = l.sun.position.length();
    LightDrag drag(l.sun, l.camera, l.focus);
    for (const PanelPoint at : {PanelPoint{0.5, 0.5}, {0.55, 0.3}, {0.4, 0.6}, {0.6, 0.65}}) {
        ASSERT_TRUE(drag.to(at));
        expectAt(l.handle("light 2"), at);
        EXPECT_NEAR(l.sun.position.length(), length, 1e-12);
        const Vector3 away = Vector3(l.focus).sub(l.camera.position).normalize();
        EXPECT_GT(l.sun.directionTowardsLight().dot(away), 0) << "it was behind the scene and stays there";
    }
}

TEST(LightDrag, BeyondTheRimItSlidesAndComesBackOnTheOtherHalf) {
    Lamps l;
    const Vector3 away = Vector3(l.focus).sub(l.camera.position).normalize();
    LightDrag drag(l.sun, l.camera, l.focus);
    ASSERT_TRUE(drag.to({0.5, 0.5}));
    EXPECT_NEAR(l.sun.directionTowardsLight().dot(away), 1, 1e-9);
    ASSERT_TRUE(drag.to({0.5, -3}));
    const PanelPoint rim = l.handle("light 2");
    EXPECT_NEAR(rim.x, 0.5, 1e-9);
    EXPECT_LT(rim.y, 0.2);
    EXPECT_GT(rim.y, 0);
    ASSERT_TRUE(drag.to({2, 0.5}));
    EXPECT_NEAR(l.handle("light 2").y, 0.5, 1e-9);
    EXPECT_GT(l.handle("light 2").x, 0.65);
    ASSERT_TRUE(drag.to({0.5, 0.5}));
    EXPECT_NEAR(l.sun.directionTowardsLight().dot(away), -1, 1e-9) << "now in front";
    ASSERT_TRUE(drag.to({0.45, 0.5}));
    expectAt(l.handle("light 2"), {0.45, 0.5});
    EXPECT_LT(l.sun.directionTowardsLight().dot(away), 0);
}

TEST(LightDrag, PressingOnAHandleMovesNothing) {
    Lamps l;
    for (const Vector3& from :
         {Vector3(0, 3, -2), Vector3(1, 2, 3), Vector3(-1, 0.1, 0), Vector3(2, -1, 1)}) {
        l.sun.position = from;
        l.update();
        ASSERT_TRUE(lab::dragLight(l.sun, l.camera, l.focus, l.handle("light 2")));
        EXPECT_NEAR(Vector3(l.sun.position).sub(from).length(), 0, 1e-8);
    }
}

TEST(LightDrag, TargetsAndParentsAreMinded) {
    Lamps l;
    l.sun.target.position.set(1, -1, 0.5);
    l.arm.add(l.sun);
    l.arm.rotation.y = 1;
    l.arm.scale.set(2, 2, 2);
    l.update();
    const double length = l.sun.position.length();
    ASSERT_TRUE(lab::dragLight(l.sun, l.camera, l.focus, {0.45, 0.4}));
    EXPECT_NEAR(l.sun.position.length(), length, 1e-9);
    for (const lab::PanelHandle& h : l.marks().handles)
        if (h.help.find("directional") != std::string::npos)
            expectAt(h.at, {0.45, 0.4});
    // So far from its parent that no place has that length: the distance to the target stays instead.
    l.sun.target.position.set(100, 0, 0);
    l.update();
    const double distance = l.sun.matrixWorld.position().distanceTo(l.sun.target.position);
    ASSERT_TRUE(lab::dragLight(l.sun, l.camera, l.focus, {0.55, 0.4}));
    EXPECT_NEAR(l.sun.matrixWorld.position().distanceTo(l.sun.target.position), distance, 1e-9 * distance);
    for (const lab::PanelHandle& h : l.marks().handles)
        if (h.help.find("directional") != std::string::npos)
            expectAt(h.at, {0.55, 0.4});
}

TEST(LightDrag, WhatCannotBeMovedStays) {
    Lamps l;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(lab::dragLight(l.sky, l.camera, l.focus, {0.5, 0.5}));
    for (THREE::Light* const light : std::vector<THREE::Light*>{&l.sun, &l.bulb}) {
        const Vector3 before = light->position;
        EXPECT_FALSE(lab::dragLight(*light, l.camera, l.focus, {nan, 0.5}));
        EXPECT_FALSE(lab::dragLight(*light, l.camera, l.focus, {0.5, infinity}));
        EXPECT_EQ(light->position, before);
    }
    EXPECT_FALSE(lab::dragLight(l.bulb, l.camera, l.focus, {1e300, 0.5}));
    l.arm.scale.x = 0;
    l.update();
    EXPECT_FALSE(lab::dragLight(l.bulb, l.camera, l.focus, {0.5, 0.5})) << "its parent is flat";
    l.arm.scale.x = 1;
    l.arm.position.z = 30;
    l.update();
    EXPECT_FALSE(lab::dragLight(l.bulb, l.camera, l.focus, {0.5, 0.5})) << "behind the camera";
}

TEST(LightDrag, WhateverTheMouseDoesTheSceneStaysValid) {
    Lamps l;
    std::mt19937 random(5);
    const double odd[] = {0, 1, -1, 0.5, 1e-12, -1e6, 1e9, 1e30, -1e300, 0.25};
    const auto any = [&] { return odd[random() % 10]; };
    LightDrag turning(l.sun, l.camera, l.focus), moving(l.bulb, l.camera, l.focus);
    int moved = 0;
    for (int i = 0; i < 3000; ++i) {
        l.camera.fov = i % 5 == 0 ? 170 : 45;
        moved += turning.to({any(), any()}) ? 1 : 0;
        if (moving.to({any(), any()}))
            l.bulb.position.set(2, 1.5, 1);
        l.update();
        ASSERT_NO_THROW(THREE::validate(l.scene, l.camera));
        ASSERT_NEAR(l.sun.position.length(), std::sqrt(13), 1e-6);
    }
    EXPECT_GT(moved, 2000);
}

}  // namespace
