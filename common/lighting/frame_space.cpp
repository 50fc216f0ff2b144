// Anchors, units, and what matrices do to triangles.
// SPDX-License-Identifier: MIT
#include "lighting/frame_space.hpp"

#include "lighting/float_range.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace lighting {

// The point nearest to `p` on a grid of spacing 2^n, the smallest that is not finer than `scale`. A grid this coarse
// puts the anchor of a scene near the origin at the origin itself, so that nothing changes there.
glm::dvec3 snapToGrid(const glm::dvec3& p, double scale) {
    const double spacing = std::exp2(std::ceil(std::log2(scale)) + 1);
    glm::dvec3 snapped;
    for (int i = 0; i < 3; ++i) {
        const double steps = p[i] / spacing;
        snapped[i] = std::abs(steps) < 0x1p52 ? std::nearbyint(steps) * spacing : p[i];
    }
    return snapped;
}

// World units in a frame unit. Where the view is about as large as a room, a town or a hand, that is 1; where it is so small or
// large that squared distances would leave the range of floats, the power of two that brings it to about 1, as far as
// everything in the scene, some of it perhaps a world away, still fits.
double frameUnit(const THREE::Scene& scene, const Settings& settings, const glm::dvec3& anchor) {
    if (settings.focusDistance >= 0x1p-16 && settings.focusDistance <= 0x1p16)
        return 1;
    double farthest = settings.focusDistance;
    scene.traverseVisible([&](const THREE::Object3D& object) {
        if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object))
            farthest = std::max(farthest, THREE::reach(*mesh, anchor));
    });
    return powerOfTwoBelow(std::max(settings.focusDistance, farthest * 0x1p-100));
}

// What takes frame space to the space that the equation is evaluated in. View space is the camera's own place and turning,
// without a scale that it may have: distances must stay distances.
glm::dmat4 lightingSpace(Space space, const glm::dmat4& cameraPlace) {
    if (space == Space::world)
        return glm::dmat4(1.0);
    const glm::dvec3 z = glm::normalize(glm::dvec3(cameraPlace[2]));
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(cameraPlace[1]), z));
    const glm::dmat4 rigid(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0),
                           cameraPlace[3]);
    return glm::inverse(rigid);
}

// Whether the matrix turns right-handed triangles into left-handed ones. Columns at length 1, so that their product does not
// leave the range of doubles.
bool mirrors(const glm::dmat3& m) {
    const auto unit = [](const glm::dvec3& v) {
        const double length = std::hypot(v.x, v.y, v.z);
        return length > 0 ? v / length : v;
    };
    return glm::dot(glm::cross(unit(m[0]), unit(m[1])), unit(m[2])) < 0;
}

// The least distance between opposite faces of the draw's box; 0 where it is squashed flat.
double thickness(const Draw& draw) {
    const glm::dmat3 linear(draw.model);
    const double determinant = glm::determinant(linear);
    if (determinant == 0 || !std::isfinite(1 / determinant))
        return 0;
    const THREE::Box3& box = draw.mesh->geometry->boundingBox();
    const glm::dvec3 extent = glm::dvec3(box.max) - glm::dvec3(box.min);
    const glm::dmat3 across = glm::transpose(glm::inverse(linear));
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        least = std::min(least, extent[axis] / glm::length(across[axis]));
    return least;
}

// Normals by the model matrix alone, as slide 33 words it. Their length does not matter.
glm::dmat3 withoutInverseTranspose(const glm::dmat3& model) {
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            largest = std::max(largest, std::abs(model[column][row]));
    return largest > 0 ? model / largest : model;
}

}  // namespace lighting
