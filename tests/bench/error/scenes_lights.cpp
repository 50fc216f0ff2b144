// S2, S3, S7, S9: the same simple shapes under many, close, grazing and dead lights.
// SPDX-License-Identifier: MIT
#include "bench/error/scenes.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

namespace bench::error {

namespace {

std::shared_ptr<THREE::BufferGeometry> ball() { return std::make_shared<THREE::SphereGeometry>(1, 64, 32); }

// Point i of `count` spread evenly over a sphere.
THREE::Vector3 spread(int i, int count, double radius) {
    const double y = 1 - (2 * i + 1.0) / count, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - y * y) * radius;
    return {r * std::cos(angle), y * radius, r * std::sin(angle)};
}

// Lamps of several colours, and from close by to so far away that a range cut leaves them out, all round a ball that fills the
// picture.
std::unique_ptr<World> manyLights(int count) {
    auto world = std::make_unique<World>();
    world->mesh(ball(), THREE::Color(0xFF8855));
    const THREE::Color colors[] = {THREE::Color(0xFFFFFF), THREE::Color(0xDD6666), THREE::Color(0x66AADD)};
    const double radii[] = {1.5, 2.5, 5, 20, 100};
    for (int i = 0; i < count; ++i)
        world->bulb(spread(i, count, radii[i % 5]), colors[i % 3], 12.0 / count, 2);
    world->ambient(THREE::Color(0x101010));
    world->look({0, 0.6, 3.6}, {0, 0, 0});
    return world;
}

std::unique_ptr<World> closeLight() {
    auto world = std::make_unique<World>();
    world->mesh(ball(), THREE::Color(0xFF8855));
    const THREE::Vector3 towards = THREE::Vector3(0, 3, 2).normalize();
    world->bulb(THREE::Vector3(towards).multiplyScalar(1.05), THREE::Color(0xFFFFFF), 0.05 * 0.05, 2);
    world->ambient(THREE::Color(0x101010));
    world->camera.fov = 24;
    world->look(THREE::Vector3(towards).multiplyScalar(2.2), {0, 0, 0});
    return world;
}

// The cosines of both lights are about `height` all over the plane.
std::unique_ptr<World> grazing(double height) {
    auto world = std::make_unique<World>();
    world->mesh(std::make_shared<THREE::PlaneGeometry>(8, 8), THREE::Color(0xFF8855)).rotation.x =
        -std::numbers::pi / 2;
    world->sun({1, height, 0.3}, THREE::Color(0xFFEEDD), 1);
    world->bulb({-8, 8 * height, 1}, THREE::Color(0xDD6666), 64, 2);
    world->ambient(THREE::Color(0x101010));
    world->look({0, 7, 7}, {0, 0, 0});
    return world;
}

// Two lamps that shine among 62 that do not; without those 62, the floor that the cost must fall to.
std::unique_ptr<World> deadLights(bool dead) {
    auto world = std::make_unique<World>();
    world->mesh(ball(), THREE::Color(0xFF8855));
    for (int i = 0; i < 64; ++i) {
        const bool shines = i % 32 == 0;
        if (shines || dead)
            world->bulb(spread(i, 64, 3), THREE::Color(shines || i % 2 == 0 ? 0xDD6666 : 0x000000),
                        shines || i % 2 == 1 ? 5 : 0, 2);
    }
    world->ambient(THREE::Color(0x101010));
    world->look({0, 0.6, 3.6}, {0, 0, 0});
    return world;
}

std::unique_ptr<World> blackAlbedo() {
    auto world = std::make_unique<World>();
    world->mesh(ball(), THREE::Color(0x000000));
    for (int i = 0; i < 16; ++i)
        world->bulb(spread(i, 16, 3), THREE::Color(0xDD6666), 1, 2);
    world->ambient(THREE::Color(0x101010));
    world->look({0, 0.6, 3.6}, {0, 0, 0});
    return world;
}

std::unique_ptr<World> ambientOnly() {
    auto world = std::make_unique<World>();
    world->mesh(ball(), THREE::Color(0xFF8855));
    world->ambient(THREE::Color(0x808080));
    world->look({0, 0.6, 3.6}, {0, 0, 0});
    return world;
}

}  // namespace

void addLightScenes(std::vector<Case>& cases, bool quick) {
    for (const int count : {8, 32, 256, 1024})
        if (!quick || count < 256)
            cases.push_back({"S2", std::to_string(count) + " lights", 256, Reference::shading,
                             [count] { return manyLights(count); }});
    cases.push_back({"S3", "1.05 radii", 512, Reference::shading, closeLight});
    for (const double height : {0.0, 1e-6, 1e-4, 1e-2}) {
        std::ostringstream name;
        name << "cosine " << height;
        cases.push_back({"S7", name.str(), 512, Reference::shading, [height] { return grazing(height); }});
    }
    cases.push_back({"S9",
                     "62 of 64 lights dead",
                     512,
                     Reference::shading,
                     [] { return deadLights(true); },
                     {},
                     [] { return deadLights(false); }});
    cases.push_back({"S9", "black albedo", 512, Reference::shading, blackAlbedo});
    cases.push_back({"S9", "ambient only", 512, Reference::shading, ambientOnly});
}

}  // namespace bench::error
