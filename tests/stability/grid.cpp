// Small unlit planes, one a pixel.
// SPDX-License-Identifier: MIT
#include "stability/grid.hpp"

#include "support/draw.hpp"

#include <deque>

namespace stability {

Grid drawGrid(const std::vector<glm::vec3>& values) {
    constexpr int side = 16;
    THREE::Scene scene;
    THREE::PlaneGeometry square(0.1, 0.1);
    std::deque<THREE::MeshBasicMaterial> materials;
    std::deque<THREE::Mesh> meshes;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const THREE::Color color(values[i].r, values[i].g, values[i].b);
        THREE::Mesh& mesh = meshes.emplace_back(square, materials.emplace_back(color));
        mesh.position.set((static_cast<double>(i % side) + 0.5) / side * 2 - 1,
                          1 - (static_cast<double>(i / side) + 0.5) / side * 2, 0);
        scene.add(mesh);
    }
    THREE::PerspectiveCamera camera(53.13010235415598, 1, 0.1, 10);
    camera.position.set(0, 0, 2);
    support::DrawOptions options{side, side, true, {}};
    Grid grid;
    grid.floats = support::draw(scene, camera, options).frame;
    options.floats = false;
    grid.codes = std::get<image::Bytes>(support::draw(scene, camera, options).frame.pixels);
    return grid;
}

}  // namespace stability
