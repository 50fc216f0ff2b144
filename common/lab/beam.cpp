// Rays against triangles.
// SPDX-License-Identifier: MIT
#include "lab/beam.hpp"

#include <algorithm>
#include <optional>

namespace lab {

using THREE::Vector3;

namespace {

// How deep below `start` a ray along -y meets the triangle, or nothing. Seen from above, the ray is a point: it must lie on the
// same side of all three edges, counter-clockwise for a triangle that shows its front.
std::optional<double> depth(const Vector3& start, const Vector3 (&corners)[3], THREE::Side side) {
    double weights[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
        weights[i] = (a.z - start.z) * (b.x - start.x) - (a.x - start.x) * (b.z - start.z);
    }
    const double area = weights[0] + weights[1] + weights[2];
    const auto inside = [&weights](double sign) {
        return std::all_of(weights, weights + 3, [sign](double w) { return sign * w >= 0; });
    };
    const bool front = area > 0 && inside(1) && side != THREE::BackSide;
    const bool back = area < 0 && inside(-1) && side != THREE::FrontSide;
    if (!front && !back)
        return std::nullopt;
    const double height =
        (weights[0] * corners[0].y + weights[1] * corners[1].y + weights[2] * corners[2].y) / area;
    return height < start.y ? std::optional(start.y - height) : std::nullopt;
}

std::optional<double> depth(const Vector3& start, const THREE::Mesh& mesh) {
    const THREE::BufferGeometry& geometry = *mesh.geometry;
    const THREE::BufferAttribute* const position = geometry.getAttribute("position");
    std::optional<double> nearest;
    for (std::size_t i = 0; i < geometry.triangleCount(); ++i) {
        std::uint32_t vertices[3];
        geometry.triangle(i, vertices);
        const Vector3 corners[3] = {mesh.matrixWorld.applyTo(position->getXYZ(vertices[0])),
                                    mesh.matrixWorld.applyTo(position->getXYZ(vertices[1])),
                                    mesh.matrixWorld.applyTo(position->getXYZ(vertices[2]))};
        const std::optional<double> found = depth(start, corners, mesh.material->side);
        if (found && (!nearest || *found < *nearest))
            nearest = found;
    }
    return nearest;
}

}  // namespace

Beam::Beam(int columns, int rows, double across, double along, double top) {
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            // Steps of 3 in a row of `rows` places: neighbouring rows stand clearly apart. All of it a quarter of a place off
            // the middle: over a patch in the middle, rays of a symmetric beam would be met in pairs only.
            const double shift = ((3 * row) % rows + 0.25) / rows - 0.5;
            const Vector3 start((column + 0.5 + shift - columns / 2.0) * across, top,
                                (row + 0.5 - rows / 2.0) * along);
            rays_.push_back({start, start, nullptr});
        }
}

void Beam::strike(const std::vector<THREE::Mesh*>& meshes) {
    for (THREE::Mesh* const mesh : meshes)
        mesh->updateWorldMatrix();
    for (Ray& ray : rays_) {
        ray.target = nullptr;
        for (const THREE::Mesh* const mesh : meshes) {
            const std::optional<double> found = depth(ray.start, *mesh);
            if (!found || (ray.target != nullptr && *found >= ray.start.y - ray.end.y))
                continue;
            ray.target = mesh;
            ray.end = Vector3(ray.start.x, ray.start.y - *found, ray.start.z);
        }
    }
}

int Beam::hits(const THREE::Mesh& mesh) const {
    return static_cast<int>(
        std::count_if(rays_.begin(), rays_.end(), [&mesh](const Ray& ray) { return ray.target == &mesh; }));
}

std::vector<Segment> Beam::raysTo(const THREE::Mesh& mesh) const {
    std::vector<Segment> segments;
    for (const Ray& ray : rays_)
        if (ray.target == &mesh)
            segments.push_back({ray.start, ray.end});
    return segments;
}

std::vector<Vector3> Beam::pointsOn(const THREE::Mesh& mesh) const {
    std::vector<Vector3> points;
    for (const Segment& segment : raysTo(mesh))
        points.push_back(segment.to);
    return points;
}

}  // namespace lab
