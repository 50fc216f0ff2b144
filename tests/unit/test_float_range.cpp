// When the shader scales its numbers, in what unit a frame is drawn, and that ordinary scenes pay for none of it.
// SPDX-License-Identifier: MIT
#include "lighting/float_range.hpp"
#include "three/three.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace {

struct Range : testing::Test {
    THREE::Scene scene;
    THREE::BoxGeometry geometry;
    THREE::MeshLambertMaterial material;
    THREE::Mesh box{geometry, material};
    THREE::PointLight bulb;
    THREE::PerspectiveCamera camera;
    lighting::Settings settings;

    Range() {
        scene.add(box, bulb);
        bulb.position.set(0, 0, 3);
        camera.position.z = 5;
        settings.focusDistance = 5;
    }
    lighting::FramePlan plan() {
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
        return lighting::planFrame(scene, camera, settings);
    }
    bool scaled() { return plan().draws.at(0).variant.scaled; }
};

TEST_F(Range, OrdinaryScenesAreNotScaled) {
    for (const double k : {0.0, 1.0, 2.0, 1.5, 3.0})
        for (const double z : {0.51, 1.0, 3.0, 1000.0, 1e6}) {
            bulb.decay = k;
            bulb.position.z = z;
            EXPECT_FALSE(scaled()) << "k " << k << ", z " << z;
        }
    bulb.position.set(0.1, 0.2, 0.3);  // inside the box
    EXPECT_FALSE(scaled());
    EXPECT_EQ(plan().unit, 1);
}

TEST_F(Range, EachExponentHasItsOwnRange) {
    const struct {
        double k, z;
        bool scaled;
    } table[] = {{0, 1e17, false}, {0, 1e19, true}, {1, 1e17, false}, {1, 1e19, true},
                 {2, 1e11, false}, {2, 1e13, true}, {8, 100, false},  {8, 1e6, true}};
    for (const auto& row : table) {
        bulb.decay = row.k;
        bulb.position.z = row.z;
        EXPECT_EQ(scaled(), row.scaled) << "k " << row.k << ", z " << row.z;
    }
}

TEST_F(Range, ALightThatAlmostTouchesAFace) {
    THREE::PlaneGeometry plane;
    box.geometry = THREE::Handle<THREE::BufferGeometry>(plane);
    bulb.decay = 2;
    bulb.position.z = 1e-9;
    EXPECT_FALSE(scaled());
    bulb.position.z = 1e-11;
    EXPECT_TRUE(scaled());
    bulb.position.set(3, 0, 1e-11);
    EXPECT_FALSE(scaled()) << "beside the plane it is far away";
}

TEST_F(Range, StrengthsThatCouldOverflow) {
    bulb.intensity = 1e30;
    EXPECT_FALSE(scaled());
    material.color = THREE::Color(1e10, 1, 1);
    EXPECT_TRUE(scaled());
    bulb.intensity = 1;
    EXPECT_FALSE(scaled());
    material.emissive = THREE::Color(1e36, 1e36, 1e36);
    material.emissiveIntensity = 1;
    EXPECT_FALSE(scaled());
    std::vector<std::unique_ptr<THREE::DirectionalLight>> suns;
    for (int i = 0; i < 40; ++i) {
        suns.push_back(std::make_unique<THREE::DirectionalLight>(THREE::Color(1, 1, 1), 1e36));
        scene.add(*suns.back());
    }
    material.color = THREE::Color(1, 1, 1);
    EXPECT_TRUE(scaled()) << "40 of 1e36";
}

TEST_F(Range, TheUnitFollowsTheView) {
    for (const double distance : {1e-3, 1.0, 1e4})
        EXPECT_EQ((settings.focusDistance = distance, plan().unit), 1);
    camera.position.z = 5e-20;
    camera.near = 1e-21;
    camera.far = 1e-18;
    box.scale.setScalar(1e-20);
    bulb.position.z = 3e-20;
    settings.focusDistance = 5e-20;
    const lighting::FramePlan small = plan();
    EXPECT_LE(small.unit, 5e-20);
    EXPECT_GT(small.unit, 2.4e-20);
    EXPECT_EQ(std::exp2(std::log2(small.unit)), small.unit);
    EXPECT_NEAR(small.point.at(0).position.z, 3e-20 / small.unit, 1e-15);
    EXPECT_FALSE(small.draws.at(0).variant.scaled) << "brought near 1, it is an ordinary frame";
    // Something a world away still fits in floats.
    THREE::Mesh far(geometry, material);
    far.position.z = -1e30;
    scene.add(far);
    EXPECT_GT(plan().unit, 1e30 * 0x1p-101);
}

TEST(FitToFloats, KeepsTheLightWhatItIs) {
    const auto effect = [](const lighting::PointAddend& light) {
        // log2 of L d^-k at the origin, in frame units
        const double d = glm::length(light.position);
        return std::log2(light.color.x) + light.exponent - light.decay * std::log2(d);
    };
    for (const double k : {0.0, 1.0, 2.0, 1.5, 30.0})
        for (const double unit : {1.0, 0x1p-60, 0x1p60, 0x1p-110})
            for (const double z : {1e-30, 1.0, 1e20, 1e36}) {
                lighting::PointAddend light{{0, 0, z}, glm::dvec3(0.5), 0.5, k, 0};
                const double expected = std::log2(0.5) - k * std::log2(z);
                lighting::fitToFloats(light, unit, true);
                EXPECT_NEAR(effect(light), expected, 1e-9 * (1 + std::abs(expected)))
                    << k << ' ' << unit << ' ' << z;
                EXPECT_LE(light.position.z, 0x1p121);
                EXPECT_EQ(light.color.x, light.intensity);
            }
}

TEST(FitToFloats, WithoutAttenuationTheColourStays) {
    lighting::PointAddend light{{0, 0, 1e-20}, glm::dvec3(0.5), 0.5, 2, 0};
    lighting::fitToFloats(light, 0x1p-60, false);
    EXPECT_EQ(light.color.x, 0.5);
    EXPECT_EQ(light.exponent, 0);
}

}  // namespace
