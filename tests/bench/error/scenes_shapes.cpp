// S4, S8: round shapes of more and more triangles, and layers behind one another.
// SPDX-License-Identifier: MIT
#include "bench/error/scenes.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace bench::error {

namespace {

using Lit = lighting::reference::Lit<long double>;
using Vec = lighting::reference::Vec3<long double>;

// The lights of S4: enough that they are not lost among the triangles.
void addLights(World& world) {
    world.sun({0, 3, -2}, THREE::Color(0xFFFFFF), 0.5);
    for (int i = 0; i < 7; ++i)
        world.bulb({4 * std::cos(i * 2.4), 3 * std::sin(i * 0.7), 4 * std::sin(i * 2.4)},
                   THREE::Color(0xDD6666), 4, 2);
    world.ambient(THREE::Color(0x101010));
}

std::unique_ptr<World> shape(std::shared_ptr<THREE::BufferGeometry> geometry) {
    auto world = std::make_unique<World>();
    world->mesh(std::move(geometry), THREE::Color(0xFF8855));
    addLights(*world);
    world->look({0, 0.6, 3.8}, {0, 0, 0});
    return world;
}

Vec toVec(const THREE::Vector3& v) { return {v.x, v.y, v.z}; }

// `at` moved to the point Q of the surface whose normal is n.
Lit onSurface(const Lit& at, const Vec& eye, const Vec& Q, const Vec& n) {
    Lit exact = at;
    exact.Q = Q - eye;
    exact.n = n;
    return exact;
}

// Radius 1 about the origin.
Lit sphere(const Lit& at, const THREE::Vector3& eye) {
    const Vec n = glm::normalize(at.Q + toVec(eye));
    return onSurface(at, toVec(eye), n, n);
}

// Radius 0.9 to the middle of the tube, which is 0.35 wide; about the z axis.
Lit torus(const Lit& at, const THREE::Vector3& eye) {
    const Vec P = at.Q + toVec(eye);
    const Vec middle = glm::normalize(Vec(P.x, P.y, 0)) * 0.9L;
    const Vec n = glm::normalize(P - middle);
    return onSurface(at, toVec(eye), middle + n * 0.35L, n);
}

// z = 0.
Lit plane(const Lit& at, const THREE::Vector3& eye) {
    const Vec P = at.Q + toVec(eye);
    return onSurface(at, toVec(eye), Vec(P.x, P.y, 0), Vec(0, 0, 1));
}

// Four squares in one mesh, the farthest first, so that no order of meshes spares a fragment.
std::shared_ptr<THREE::BufferGeometry> layers() {
    std::vector<double> positions, normals;
    std::vector<std::uint32_t> index;
    for (int layer = 0; layer < 4; ++layer) {
        const auto first = static_cast<std::uint32_t>(positions.size() / 3);
        for (const double y : {-2.0, 2.0})
            for (const double x : {-2.0, 2.0}) {
                positions.insert(positions.end(), {x, y, 0.3 * layer});
                normals.insert(normals.end(), {0, 0, 1});
            }
        for (const std::uint32_t corner : {0U, 1U, 3U, 0U, 3U, 2U})
            index.push_back(first + corner);
    }
    auto geometry = std::make_shared<THREE::BufferGeometry>();
    geometry->setAttribute("position", std::move(positions), 3);
    geometry->setAttribute("normal", std::move(normals), 3);
    geometry->setIndex(std::move(index));
    return geometry;
}

}  // namespace

void addShapeScenes(std::vector<Case>& cases, bool quick) {
    const int finest = quick ? 128 : 512;
    for (int n = 8; n <= finest; n *= 2)
        cases.push_back({"S4", "sphere, " + std::to_string(n) + " segments", 512, Reference::surface,
                         [n] { return shape(std::make_shared<THREE::SphereGeometry>(1, n, n / 2)); },
                         sphere});
    for (int n = 32; n <= 128; n *= 4)
        cases.push_back({"S4", "torus, " + std::to_string(n) + " segments", 512, Reference::surface,
                         [n] { return shape(std::make_shared<THREE::TorusGeometry>(0.9, 0.35, n / 2, n)); },
                         torus});
    cases.push_back({"S4", "plane", 512, Reference::surface,
                     [] { return shape(std::make_shared<THREE::PlaneGeometry>(2, 2)); }, plane});
    cases.push_back({"S8", "four layers", 512, Reference::shading, [] { return shape(layers()); }});
}

}  // namespace bench::error
