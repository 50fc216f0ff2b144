// S5, S6: the same things far away, very small, very large and very flat.
// SPDX-License-Identifier: MIT
#include "bench/error/scenes.hpp"

#include <cmath>
#include <sstream>

namespace bench::error {

namespace {

// A knot under eight lights, everything moved by `offset` and `size` times as large.
std::unique_ptr<World> knot(const THREE::Vector3& offset, double size) {
    auto world = std::make_unique<World>();
    const auto at = [&](double x, double y, double z) {
        return THREE::Vector3(x, y, z).multiplyScalar(size).add(offset);
    };
    THREE::Mesh& mesh =
        world->mesh(std::make_shared<THREE::TorusKnotGeometry>(0.9, 0.34, 160, 32), THREE::Color(0xFF8855));
    mesh.position = at(0, 0, 0);
    mesh.rotation.set(0.5, 0.3, 0.2);
    mesh.scale.setScalar(size);
    world->sun({0, 3, -2}, THREE::Color(0xFFFFFF), 0.5);
    for (int i = 0; i < 7; ++i)  // k = 1: the light of 1/d^2 would not fit in a float at 1e20
        world->bulb(at(4 * std::cos(i * 2.4), 3 * std::sin(i * 0.7), 4 * std::sin(i * 2.4)),
                    THREE::Color(0xDD6666), size, 1);
    world->ambient(THREE::Color(0x101010));
    world->camera.near *= size;
    world->camera.far *= size;
    world->look(at(0, 0.6, 4.4), at(0, 0, 0));
    return world;
}

// A turned ball in a group that is `condition` times flatter in one direction than in another, turned once more.
std::unique_ptr<World> flattened(double condition) {
    auto world = std::make_unique<World>();
    auto& outer = world->scene.add(std::make_unique<THREE::Group>());
    outer.rotation.set(0.3, 0.2, 0.1);
    auto& group = outer.add(std::make_unique<THREE::Group>());
    group.scale.set(1, 1, 1 / condition);
    world->mesh(std::make_shared<THREE::SphereGeometry>(1, 64, 32), THREE::Color(0xFF8855), group)
        .rotation.set(0.5, 0.3, 0.2);
    world->sun({0, 3, 2}, THREE::Color(0xFFFFFF), 0.5);
    for (int i = 0; i < 7; ++i)
        world->bulb({4 * std::cos(i * 2.4), 3 * std::sin(i * 0.7), 4 + std::sin(i * 2.4)},
                    THREE::Color(0xDD6666), 4, 2);
    world->ambient(THREE::Color(0x101010));
    world->look({0, 0.6, 3.8}, {0, 0, 0});
    return world;
}

std::string named(const std::string& what, double value) {
    std::ostringstream name;
    name << what << ' ' << value;
    return name.str();
}

}  // namespace

void addPlaceScenes(std::vector<Case>& cases) {
    for (const double offset : {1.0, 1e2, 1e4, 1e6, 1e8})
        cases.push_back({"S5", named("offset", offset), 256, Reference::scene, [offset] {
                             return knot({offset, -0.3 * offset, 0.7 * offset}, 1);
                         }});
    for (const double size : {1e-20, 1e-10, 1.0, 1e10, 1e20})
        cases.push_back({"S6", named("size", size), 256, Reference::scene, [size] {
                             return knot({0, 0, 0}, size);
                         }});
    for (const double condition : {1.0, 1e2, 1e4, 1e7})
        cases.push_back({"S6", named("condition", condition), 256, Reference::scene,
                         [condition] { return flattened(condition); }});
}

}  // namespace bench::error
