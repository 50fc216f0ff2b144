// A plane under whatever lights a test adds, and the equation by hand, for the tests of the shaders' text.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <vector>

namespace support {

inline constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinite = std::numeric_limits<float>::infinity();

/// A plane under whatever lights a test adds, seen from above its middle.
struct Room {
    THREE::Scene scene;
    THREE::PlaneGeometry geometry{6, 6};
    THREE::MeshLambertMaterial material{THREE::Color(0xFF8855)};
    THREE::Mesh plane{geometry, material};
    THREE::PerspectiveCamera camera{50, 1, 0.1, 100};
    std::vector<std::unique_ptr<THREE::DirectionalLight>> suns;
    std::vector<std::unique_ptr<THREE::PointLight>> bulbs;
    std::vector<std::unique_ptr<THREE::AmbientLight>> ambients;

    Room() {
        scene.add(plane);
        camera.position.set(0, 0, 2);
    }
    void sun(const THREE::Vector3& towards, unsigned color, double intensity = 1) {
        suns.push_back(std::make_unique<THREE::DirectionalLight>(THREE::Color(color), intensity));
        suns.back()->position = towards;
        scene.add(*suns.back());
    }
    void bulb(const THREE::Vector3& place, double decay, double distance = 0, double intensity = 2) {
        bulbs.push_back(
            std::make_unique<THREE::PointLight>(THREE::Color(0xDD6644), intensity, distance, decay));
        bulbs.back()->position = place;
        scene.add(*bulbs.back());
    }
    void ambient(unsigned color) {
        ambients.push_back(std::make_unique<THREE::AmbientLight>(THREE::Color(color)));
        scene.add(*ambients.back());
    }
    lighting::FramePlan plan(const lighting::Settings& settings = {}) {
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
        return lighting::planFrame(scene, camera, settings);
    }
};

inline glm::dvec3 channels(const THREE::Color& c) { return {c.r, c.g, c.b}; }

/// P at Q, world space, by slide 42 in double, and in `strength` what it would be if every cosine were 1.
inline glm::dvec3 byHand(const Room& room, const glm::dvec3& Q, const glm::dvec3& normal,
                         glm::dvec3& strength) {
    const glm::dvec3 n = glm::normalize(normal);
    glm::dvec3 sum(0), all(0);
    for (const auto& light : room.suns) {
        const glm::dvec3 w = glm::normalize(glm::dvec3(light->position));
        sum += std::max(0.0, glm::dot(n, w)) * channels(light->radiance());
        all += channels(light->radiance());
    }
    for (const auto& light : room.bulbs) {
        const glm::dvec3 v = glm::dvec3(light->position) - Q;
        const double d = glm::length(v);
        const double rest = light->distance > 0 ? std::max(0.0, 1 - std::pow(d / light->distance, 4)) : 1;
        const glm::dvec3 L = std::pow(d, -light->decay) * rest * rest * channels(light->radiance());
        sum += std::max(0.0, glm::dot(n, v) / d) * L;
        all += L;
    }
    for (const auto& light : room.ambients) {
        sum += channels(light->radiance());
        all += channels(light->radiance());
    }
    const glm::dvec3 D = channels(room.material.color), own = channels(room.material.emitted());
    strength = D * all + own;
    return D * sum + own;
}

/// Points whose coordinates are exact in float, and normals of any length.
struct Place {
    glm::dvec3 Q, normal;
};
inline const std::vector<Place> places = {{{0, 0, 0}, {0, 0, 1}},
                                          {{0.75, -0.5, 0.25}, {0.3, 0.2, 0.8}},
                                          {{-1.375, 0.0625, -0.5}, {-0.6, 0.1, 0.7}},
                                          {{2.5, 1.5, 0.125}, {0, 0.9, 0.1}}};

/// How many floats apart.
inline int ulps(float a, float b) { return std::abs(std::bit_cast<int>(a) - std::bit_cast<int>(b)); }

}  // namespace support
