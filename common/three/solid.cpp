// Whether a geometry is a solid whose inside cannot be seen from outside.
// SPDX-License-Identifier: MIT
#include "three/buffer_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <unordered_map>

namespace THREE {

namespace {

constexpr std::size_t mostTriangles = 100'000;  // above it, finding out costs more than it spares

using Triangle = std::array<std::uint32_t, 3>;

struct Hash {
    std::size_t operator()(const std::tuple<double, double, double>& p) const {
        const std::hash<double> hash;
        return hash(std::get<0>(p)) * 31 * 31 + hash(std::get<1>(p)) * 31 + hash(std::get<2>(p));
    }
};

// Vertices at the same place count as one, as in the seam of a sphere; triangles without a surface not at all.
class Welded {
  public:
    explicit Welded(const BufferGeometry& geometry) {
        const BufferAttribute& position = *geometry.getAttribute("position");
        std::unordered_map<std::tuple<double, double, double>, std::uint32_t, Hash> known;
        std::vector<std::uint32_t> names;
        for (std::size_t i = 0; i < geometry.vertexCount(); ++i) {
            const Vector3 p = position.getXYZ(i);
            const auto fresh = static_cast<std::uint32_t>(points.size());
            // + 0.0: the two zeros are one place
            const auto [name, isNew] = known.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0}, fresh);
            if (isNew)
                points.emplace_back(p.x, p.y, p.z);
            names.push_back(name->second);
        }
        for (std::size_t t = 0; t < geometry.triangleCount(); ++t) {
            std::uint32_t v[3];
            geometry.triangle(t, v);
            const Triangle named{names[v[0]], names[v[1]], names[v[2]]};
            if (named[0] != named[1] && named[1] != named[2] && named[2] != named[0])
                triangles.push_back(named);
        }
    }

    std::vector<glm::dvec3> points;
    std::vector<Triangle> triangles;
};

// Across each edge lies one other triangle, turned the same way and, where `convex` is asked for, not above the plane of this
// one.
bool isClosed(const Welded& mesh, bool convex, double size) {
    std::unordered_map<std::uint64_t, std::uint32_t> opposite;  // of a directed edge: the third vertex
    const auto edge = [](std::uint32_t from, std::uint32_t to) {
        return static_cast<std::uint64_t>(from) << 32U | to;
    };
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (!opposite.try_emplace(edge(t[i], t[(i + 1) % 3]), t[(i + 2) % 3]).second)
                return false;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 a = mesh.points[t[0]];
        const glm::dvec3 normal = glm::cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a);
        const double tolerance = 1e-9 * glm::length(normal) * size;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto across = opposite.find(edge(t[(i + 1) % 3], t[i]));
            if (across == opposite.end() ||
                (convex && glm::dot(normal, mesh.points[across->second] - a) > tolerance))
                return false;
        }
    }
    return !mesh.triangles.empty();
}

// Six times the volume inside; negative where triangles face inwards.
double volume(const Welded& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        sum += glm::dot(mesh.points[t[0]], glm::cross(mesh.points[t[1]], mesh.points[t[2]]));
    return sum;
}

}  // namespace

bool BufferGeometry::hidesItsBacks() const {
    if (solidVersion_ != version_) {
        const BufferAttribute* const position = getAttribute("position");
        solid_ = position != nullptr && position->itemSize >= 3 && triangleCount() <= mostTriangles;
        if (solid_) {
            const Welded mesh(*this);
            const bool simple = simpleVersion_ == version_;
            solid_ = isClosed(mesh, !simple, boundingSphere().radius) && volume(mesh) > 0;
        }
        solidVersion_ = version_;
    }
    return solid_;
}

}  // namespace THREE
