// When the shader scales its numbers, in what unit a frame is drawn, and that ordinary scenes pay for none of it.
// SPDX-License-Identifier: MIT
#include "lighting/float_range.hpp"
#include "three/three.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <random>

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

// A light's share of the sum by the plain formula of shaders/terms/point.glsl, in T; both points are floats already.
template <class T>
T plainShare(const glm::vec3& light, const glm::vec3& Q, const glm::vec3& n, double k) {
    const T x = T(light.x) - T(Q.x), y = T(light.y) - T(Q.y), z = T(light.z) - T(Q.z);
    const T d2 = x * x + y * y + z * z;
    const T power = k == 0 ? T(1) : k == 1 ? std::sqrt(d2) : k == 2 ? d2 : std::pow(d2, T(0.5 * k));
    const T cosine = x * T(n.x) + y * T(n.y) + z * T(n.z);
    return d2 > 0 ? cosine / std::max(std::sqrt(d2) * power, T(1e-30)) : T(0);
}

// Where the plain formula is said to do, floats are as good as the lab promises, at the points nearest to the light above all.
TEST_F(Range, WhereNothingIsScaledFloatsAreAccurate) {
    std::mt19937 random{11};
    const auto any = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int plain = 0, scaledOnes = 0;
    for (int round = 0; round < 4000; ++round) {
        constexpr double exponents[] = {0, 1, 2, 0.5, 3, 6};
        bulb.decay = exponents[round % 6];
        const double gap = std::exp2(any(-50, 60)), a = any(-0.6, 0.6), b = any(-0.6, 0.6);
        bulb.position.set(a, b, 0.5 + gap);
        if (scaled()) {
            ++scaledOnes;
            continue;
        }
        ++plain;
        const glm::vec3 light(glm::dvec3(bulb.position));
        for (const double beside : {0.0, 1e-6, 0.1}) {
            const glm::vec3 Q(glm::dvec3(a + beside, b, 0.5)), n(0, 0, 1);
            const double d = glm::length(glm::dvec3(light) - glm::dvec3(Q));
            if (d == 0 || std::abs(Q.x) > 0.5 || std::abs(Q.y) > 0.5)
                continue;  // in floats the light is in the very point; or beside the box
            const double expected = plainShare<double>(light, Q, n, bulb.decay);
            const double found = static_cast<double>(plainShare<float>(light, Q, n, bulb.decay));
            ASSERT_NEAR(found, expected, 63 * 0x1p-24 * std::pow(d, -bulb.decay))
                << "k " << bulb.decay << ", " << d << " away";
        }
    }
    EXPECT_GT(plain, 1000);
    EXPECT_GT(scaledOnes, 200);
}

// Among thousands of lights each mesh looks at those near it only: 50 million pairs would take half a minute.
TEST_F(Range, ThousandsOfMeshesUnderThousandsOfLights) {
    std::vector<std::unique_ptr<THREE::PointLight>> lights;
    std::vector<std::unique_ptr<THREE::Mesh>> meshes;
    for (int i = 0; i < 5000; ++i) {
        lights.push_back(std::make_unique<THREE::PointLight>(THREE::Color(1, 1, 1), 1, 0, i % 3));
        lights.back()->position.set(i % 71, i / 71 % 71, -i % 13);
        scene.add(*lights.back());
    }
    for (int i = 0; i < 10'000; ++i) {
        meshes.push_back(std::make_unique<THREE::Mesh>(geometry, material));
        meshes.back()->position.set(i % 100 * 0.7 + 0.05, i / 100 * 0.7 + 0.05, -5);
        scene.add(*meshes.back());
    }
    camera.position.set(35, 35, 100);
    int scaledOnes = 0;
    const lighting::FramePlan p = plan();
    for (const lighting::Draw& draw : p.draws)
        scaledOnes += draw.variant.scaled ? 1 : 0;
    EXPECT_EQ(p.draws.size(), 10'001U);
    EXPECT_EQ(scaledOnes, 0);
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
