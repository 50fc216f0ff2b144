// The table of scenes; S0 and S1, the lecture's.
// SPDX-License-Identifier: MIT
#include "bench/error/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace bench::error {

namespace {

// lesson_04_ambient's scene; with an exponent k, the bulb's light is what it was without one at a distance of 5.
std::unique_ptr<World> lecture(double k) {
    auto world = std::make_unique<World>();
    THREE::Mesh& knot =
        world->mesh(std::make_shared<THREE::TorusKnotGeometry>(0.9, 0.34, 400, 64), THREE::Color(0xFF8855));
    knot.position.set(0, 1.55, 0);
    knot.rotation.set(0.5, 0.3, 0.2);
    THREE::Mesh& floor = world->mesh(std::make_shared<THREE::PlaneGeometry>(9, 9), THREE::Color(0x7788AA));
    floor.rotation.x = -std::numbers::pi / 2;
    world->sun({0, 3, -2}, THREE::Color(0xFFFFFF), 1);
    world->bulb({2, 1.5, 5}, THREE::Color(0xDD6666), std::pow(5, k), k);
    world->ambient(THREE::Color(0x101010));
    world->look({2.2, 2.7, 6.4}, {0, 1.2, 0});
    return world;
}

}  // namespace

const std::vector<SceneInfo>& sceneTable() {
    static const std::vector<SceneInfo> table = {
        {"S0", "the lecture's scene"},
        {"S1", "the lecture's scene with k = 0, 0.5, 1, 1.5 and 2"},
        {"S2", "8 to 1,024 point lights round a ball"},
        {"S3", "a light at 1.05 radii of a sphere"},
        {"S4", "tessellation, against the exact surface"},
        {"S5", "far from the origin, against the scene in long double"},
        {"S6", "sizes 1e-20 to 1e20, flattened up to 1e7 times, against the scene in long double"},
        {"S7", "a plane in grazing light"},
        {"S8", "every pixel shaded four times"},
        {"S9", "nothing to light: dead lights, black albedo, ambient only"},
    };
    return table;
}

void addLectureScenes(std::vector<Case>& cases) {
    cases.push_back({"S0", "lecture", 512, Reference::shading, [] { return lecture(0); }});
    for (const double k : {0.0, 0.5, 1.0, 1.5, 2.0}) {
        std::ostringstream name;
        name << "k = " << k;
        cases.push_back({"S1", name.str(), 512, Reference::shading, [k] { return lecture(k); }});
    }
}

std::vector<Case> allCases(bool quick) {
    std::vector<Case> cases;
    addLectureScenes(cases);
    addLightScenes(cases, quick);
    addShapeScenes(cases, quick);
    addPlaceScenes(cases);
    std::stable_sort(cases.begin(), cases.end(),
                     [](const Case& a, const Case& b) { return a.scene < b.scene; });
    return cases;
}

}  // namespace bench::error
