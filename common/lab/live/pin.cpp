// A point of a surface, to text and back.
// SPDX-License-Identifier: MIT
#include "lab/live/pin.hpp"

#include "lab/failure.hpp"
#include "lab/live/values.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lab {

namespace {

std::vector<const THREE::Mesh*> meshesOf(const THREE::Scene& scene) {
    std::vector<const THREE::Mesh*> meshes;
    scene.traverse([&meshes](const THREE::Object3D& object) {
        if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object))
            meshes.push_back(mesh);
    });
    return meshes;
}

}  // namespace

std::string pinText(const std::optional<SurfacePoint>& pin, const THREE::Scene& scene) {
    if (!pin)
        return "none";
    const std::vector<const THREE::Mesh*> meshes = meshesOf(scene);
    const auto place = std::find(meshes.begin(), meshes.end(), pin->mesh);
    if (place == meshes.end())
        return "none";
    return numbersText({static_cast<double>(place - meshes.begin()) + 1, static_cast<double>(pin->triangle),
                        pin->weights.x, pin->weights.y, pin->weights.z});
}

std::optional<SurfacePoint> readPin(const std::string& text, const THREE::Scene& scene) {
    if (text == "none")
        return std::nullopt;
    const std::vector<double> numbers = readNumbers(text, 5, 5);
    const std::vector<const THREE::Mesh*> meshes = meshesOf(scene);
    const auto whole = [&numbers](std::size_t i, std::size_t from, std::size_t end) {
        return numbers[i] == std::floor(numbers[i]) && numbers[i] >= static_cast<double>(from) &&
               numbers[i] < static_cast<double>(end);
    };
    const auto wrong = [&text](const std::string& expected) {
        return UsageError("expected " + expected + ", found '" + text + "'");
    };
    if (!whole(0, 1, meshes.size() + 1))
        throw wrong("a mesh from 1 to " + std::to_string(meshes.size()));
    const THREE::Mesh& mesh = *meshes[static_cast<std::size_t>(numbers[0]) - 1];
    const std::size_t corners = mesh.geometry ? mesh.geometry->index.empty() ? mesh.geometry->vertexCount()
                                                                             : mesh.geometry->index.size()
                                              : 0;
    if (!whole(1, 0, corners / 3))
        throw wrong("a triangle below " + std::to_string(corners / 3));
    if (!(std::abs(numbers[2] + numbers[3] + numbers[4] - 1) < 1e-6))
        throw wrong("three weights that add up to 1");
    return SurfacePoint{&mesh, static_cast<std::size_t>(numbers[1]), {numbers[2], numbers[3], numbers[4]}};
}

}  // namespace lab
