// Every light that reaches a point is in the list of the point's cluster, as the shader finds it.
// SPDX-License-Identifier: MIT
#include "lighting/light_clusters.hpp"
#include "three/three.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <random>

namespace {

using lighting::FramePlan;
using lighting::LightClusters;

struct Clusters : testing::Test {
    THREE::Scene scene;
    THREE::BoxGeometry geometry;
    THREE::MeshLambertMaterial material;
    THREE::Mesh box{geometry, material};
    THREE::PerspectiveCamera camera{50, 1.5, 0.1, 1e5};
    std::vector<std::unique_ptr<THREE::PointLight>> lights;
    lighting::Settings settings;
    std::mt19937 random{3};

    Clusters() {
        scene.add(box);
        camera.position.z = 10;
        settings.focusDistance = 10;
        settings.uniformLights = 0;
    }
    double any(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    double anyOctave(double low, double high) { return std::exp2(any(std::log2(low), std::log2(high))); }
    void light(const THREE::Vector3& place, double distance, double k = 2) {
        lights.push_back(std::make_unique<THREE::PointLight>(THREE::Color(1, 1, 1), 1, distance, k));
        lights.back()->position = place;
        scene.add(*lights.back());
    }
    FramePlan plan() {
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
        return lighting::planFrame(scene, camera, settings);
    }
};

// The cluster that shaders/clusters.glsl finds for a point of view space, in floats; the driver's log2 is `ulps` off, of
// which GLSL ES allows 3.
std::size_t clusterOf(const LightClusters& c, const FramePlan& plan, const glm::dvec3& p, int ulps) {
    const glm::dvec4 clip = plan.projection * glm::dvec4(p, 1);
    const auto cell = [](double at, int count) {
        return std::clamp(static_cast<int>(std::clamp(at, -1e9, 1e9)), 0, count - 1);
    };
    const auto fragment = [](double ndc, int count) {
        return static_cast<float>((ndc + 1) / 2) * static_cast<float>(count);
    };
    const float inverse = static_cast<float>(1 / -p.z);
    float octaves = std::log2(1 / inverse);
    for (int i = 0; i < std::abs(ulps); ++i)
        octaves = std::nextafter(octaves, ulps < 0 ? -1e9F : 1e9F);
    const float slice = octaves * static_cast<float>(c.slicesPerOctave) + static_cast<float>(c.firstSlice);
    const int x = cell(static_cast<double>(fragment(clip.x / clip.w, c.columns)), c.columns);
    const int y = cell(static_cast<double>(fragment(clip.y / clip.w, c.rows)), c.rows);
    const int z = cell(static_cast<double>(slice), c.slices);
    return static_cast<std::size_t>((z * c.rows + y) * c.columns + x);
}

bool isListed(const LightClusters& c, std::size_t cluster, unsigned group, std::uint32_t light) {
    const auto begin = c.lights.begin() + c.begins[cluster * 4 + group];
    const auto end = c.lights.begin() + c.begins[cluster * 4 + group + 1];
    return std::find(begin, end, light) != end;
}

// Points within reach of each light, many of them near its border, that a fragment could be at.
template <class Random>
int expectEveryLightListed(const FramePlan& plan, const LightClusters& c, int pointsPerLight,
                           const Random& any) {
    double nearest = 1e300, farthest = 0;
    for (const lighting::Draw& draw : plan.draws) {
        nearest = std::min(nearest, draw.nearestDepth);
        farthest = std::max(farthest, draw.farthestDepth);
    }
    int checked = 0;
    for (std::uint32_t i = 0; i < plan.point.size(); ++i)
        for (int n = 0; n < pointsPerLight && std::isfinite(plan.point[i].reach); ++n) {
            // every fourth point is the one that is nearest to the eye, or farthest from it
            const double aside = n % 4 == 0 ? 1e-3 : 1;
            const glm::dvec3 toPoint = glm::transpose(glm::dmat3(plan.lightingToView)) *
                                       glm::dvec3(any(-aside, aside), any(-aside, aside), any(-1, 1));
            const double away = plan.point[i].reach * (n % 2 == 0 ? 0.99999 : any(0, 1));
            const glm::dvec3 p =
                plan.lightingToView * glm::dvec4(plan.point[i].position + glm::normalize(toPoint) * away, 1);
            const glm::dvec4 clip = plan.projection * glm::dvec4(p, 1);
            if (-p.z < std::max(plan.near, nearest) || -p.z > farthest || std::abs(clip.x) > clip.w ||
                std::abs(clip.y) > clip.w)
                continue;
            ++checked;
            if (isListed(c, clusterOf(c, plan, p, n % 7 - 3), lighting::decayGroup(plan.point[i]), i))
                continue;
            ADD_FAILURE() << "light " << i << " is not in the list of a point at depth " << -p.z << ", "
                          << away << " away";
            return checked;
        }
    return checked;
}

TEST_F(Clusters, ListEveryLightThatReachesAPoint) {
    const auto random_ = [this](double low, double high) { return any(low, high); };
    int checked = 0;
    for (int round = 0; round < 30; ++round) {
        SCOPED_TRACE(round);
        lights.clear();
        const double size = round % 3 == 0 ? 1 : anyOctave(1e-6, 1e6), shape = anyOctave(0.3, 3);
        box.scale.setScalar(size * anyOctave(3, 30));
        for (int i = 0; i < 150; ++i)
            light({any(-9, 9) * size, any(-9, 9) * size, any(-15, 12) * size}, anyOctave(0.01, 40) * size,
                  i % 4);
        camera.fov = anyOctave(1, 150);
        camera.aspect = shape;
        camera.near = size * anyOctave(1e-3, 1);
        camera.far = 1e5 * size;
        camera.position.set(any(-3, 3) * size, any(-3, 3) * size, any(2, 12) * size);
        camera.lookAt(0, 0, 0);
        settings.focusDistance = camera.position.length();
        settings.space = round % 2 == 0 ? lighting::Space::world : lighting::Space::view;
        const FramePlan p = plan();
        if (p.draws.empty())
            continue;
        checked += expectEveryLightListed(p, lighting::clusterLights(p, true), 40, random_);
    }
    EXPECT_GT(checked, 10'000);
}

// A wall far away, hardly deeper than it is flat: slices thinner than floats tell depths apart would lose lights.
TEST_F(Clusters, WhereAllIsAtOneDepth) {
    const auto random_ = [this](double low, double high) { return any(low, high); };
    for (const double depth : {100.0, 66'000.0, 1e9}) {
        SCOPED_TRACE(depth);
        lights.clear();
        const double thin = depth * 1e-3;
        box.scale.set(thin, thin, thin);
        box.position.z = 10 - depth;
        camera.fov = 0.1;
        camera.far = 2 * depth;
        for (int i = 0; i < 1000; ++i)
            light({any(-0.4, 0.4) * thin, any(-0.4, 0.4) * thin, 10 - depth + any(-0.5, 0.5) * thin},
                  anyOctave(0.01, 0.1) * thin, i % 4);
        const FramePlan p = plan();
        EXPECT_GT(expectEveryLightListed(p, lighting::clusterLights(p, true), 40, random_), 1000);
    }
}

TEST_F(Clusters, ListsAreInOrderAndHaveOnlyLightsThatEnd) {
    for (int i = 0; i < 100; ++i)
        light({any(-3, 3), any(-3, 3), any(-3, 3)}, i % 5 == 0 ? 0 : 2, i % 4);
    const FramePlan p = plan();
    const LightClusters c = lighting::clusterLights(p, true);
    ASSERT_EQ(c.begins.size(), c.count() * 4 + 1);
    EXPECT_EQ(c.begins.front(), 0U);
    EXPECT_EQ(c.begins.back(), c.lights.size());
    for (std::size_t list = 0; list + 1 < c.begins.size(); ++list) {
        ASSERT_LE(c.begins[list], c.begins[list + 1]);
        for (std::uint32_t i = c.begins[list]; i < c.begins[list + 1]; ++i) {
            const std::uint32_t number = c.lights[i];
            ASSERT_TRUE(i == c.begins[list] || c.lights[i - 1] < number) << "ascending: the order of the sum";
            ASSERT_TRUE(std::isfinite(p.point[number].reach));
            ASSERT_EQ(lighting::decayGroup(p.point[number]), list % 4);
        }
    }
}

TEST_F(Clusters, WithoutCullingOneHasAll) {
    for (int i = 0; i < 40; ++i)
        light({0, 0, 1000.0 * i}, i % 5 == 0 ? 0 : 2, i % 4);
    const FramePlan p = plan();
    const LightClusters c = lighting::clusterLights(p, false);
    EXPECT_EQ(c.count(), 1U);
    EXPECT_EQ(c.lights.size(), 32U);
    EXPECT_EQ(c.begins, (std::vector<std::uint32_t>{0, 8, 16, 24, 32}));
    EXPECT_TRUE(std::is_sorted(c.lights.begin(), c.lights.end()));
}

TEST_F(Clusters, LightsOutOfViewAreInNoList) {
    light({0, 0, 20}, 5);  // behind the camera
    light({100, 0, 0}, 5);  // beside the picture
    light({0, 0, -90'000}, 5);  // behind every mesh
    const LightClusters c = lighting::clusterLights(plan(), true);
    EXPECT_TRUE(c.lights.empty());
    EXPECT_EQ(c.begins, std::vector<std::uint32_t>(c.count() * 4 + 1, 0));
}

// So many that reach everything that the lists would be too long: the grid is made coarser, and none is lost.
TEST_F(Clusters, CoarserGridsForManyLongLists) {
    for (int i = 0; i < 3000; ++i)
        light({any(-3, 3), any(-3, 3), any(-3, 3)}, 100, i % 4);
    const FramePlan p = plan();
    const LightClusters c = lighting::clusterLights(p, true);
    EXPECT_LE(c.lights.size(), 1U << 23U);
    EXPECT_LT(c.count(), 32U * 32U * 24U);
    EXPECT_GE(c.lights.size(), 3000U * c.count() / 2);
    EXPECT_GT(expectEveryLightListed(p, c, 30, [this](double low, double high) { return any(low, high); }),
              100);
}

}  // namespace
