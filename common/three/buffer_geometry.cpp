// BufferGeometry: normals, faces and bounds from the vertices and triangles.
// SPDX-License-Identifier: MIT
#include "three/buffer_geometry.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

namespace THREE {

namespace {

// Products of three edges, where a double would overflow or underflow: the normal of a triangle of any finite
// size, and sums of triangles that differ by any factor, with no scaling that one small triangle among large
// ones would not survive.
using Wide = glm::vec<3, long double>;

/// Sine of a triangle's widest angle up to which its corners count as collinear: what rounding three points
/// of a line to doubles leaves.
constexpr long double collinearSine = 1e-15L;

Wide wide(const Vector3& v) { return {v.x, v.y, v.z}; }

/// Perpendicular to the triangle, counter-clockwise front, twice its area long; zero if its corners are
/// collinear. The cross product is taken where the two shorter edges meet: there it cancels least.
Wide areaVector(const Wide& a, const Wide& b, const Wide& c) {
    const std::array<Wide, 3> edges{b - a, c - b, a - c};
    std::array<long double, 3> lengths{};
    std::size_t longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        lengths[i] = glm::length(edges[i]);
        if (lengths[i] > lengths[longest])
            longest = i;
    }
    const std::size_t next = (longest + 1) % 3;
    const std::size_t last = (longest + 2) % 3;
    const Wide area = glm::cross(edges[next], edges[last]);
    const long double size = glm::length(area);
    // False for NaN, too: a bad coordinate then counts nothing.
    const bool isTriangle = size > collinearSine * lengths[next] * lengths[last] && std::isfinite(size);
    return isTriangle ? area : Wide(0);
}

Vector3 unit(const Wide& v) {
    const long double length = glm::length(v);
    if (!(length > 0) || !std::isfinite(length))
        return {};
    return {static_cast<double>(v.x / length), static_cast<double>(v.y / length),
            static_cast<double>(v.z / length)};
}

std::string describe(const BufferGeometry& geometry) {
    std::string text = geometry.type();
    if (!geometry.name.empty())
        text += " '" + geometry.name + "'";
    return text;
}

/// "position", or null; checked so that getXYZ stays inside the array.
const BufferAttribute* findPositions(const BufferGeometry& geometry) {
    const BufferAttribute* positions = geometry.getAttribute("position");
    if (positions != nullptr && positions->itemSize < 3)
        throw std::invalid_argument(describe(geometry) +
                                    ": attribute 'position': expected itemSize 3, found " +
                                    std::to_string(positions->itemSize));
    return positions;
}

void requireIndicesInside(const BufferGeometry& geometry) {
    const std::size_t vertices = geometry.vertexCount();
    for (std::size_t i = 0; i < geometry.index.size(); ++i)
        if (geometry.index[i] >= vertices)
            throw std::out_of_range(describe(geometry) + ": index[" + std::to_string(i) +
                                    "]: expected less than " + std::to_string(vertices) +
                                    ", the number of vertices, found " + std::to_string(geometry.index[i]));
}

/// The vertex of a corner; triangle t has the corners 3 t to 3 t + 2.
std::uint32_t vertexOf(const BufferGeometry& geometry, std::size_t corner) {
    return geometry.index.empty() ? static_cast<std::uint32_t>(corner) : geometry.index[corner];
}

/// Of the triangle that begins at this corner; its indices were checked.
Wide areaVector(const BufferGeometry& geometry, const BufferAttribute& positions, std::size_t corner) {
    return areaVector(wide(positions.getXYZ(vertexOf(geometry, corner))),
                      wide(positions.getXYZ(vertexOf(geometry, corner + 1))),
                      wide(positions.getXYZ(vertexOf(geometry, corner + 2))));
}

void append(std::vector<double>& numbers, const Vector3& v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

/// The attribute's numbers at the three corners of every triangle, one after the other.
BufferAttribute expand(const BufferGeometry& geometry, const BufferAttribute& attribute) {
    BufferAttribute expanded{{}, attribute.itemSize};
    const auto size = static_cast<std::size_t>(attribute.itemSize);
    const std::size_t corners = geometry.triangleCount() * 3;
    expanded.array.reserve(corners * size);
    for (std::size_t corner = 0; corner < corners; ++corner)
        for (std::size_t i = 0; i < size; ++i)
            expanded.array.push_back(attribute.array[vertexOf(geometry, corner) * size + i]);
    return expanded;
}

void grow(double coordinate, double& least, double& most) {
    if (coordinate < least)
        least = coordinate;
    if (coordinate > most)
        most = coordinate;
}

// Halved before they are added, so that the largest doubles do not overflow.
double middle(double least, double most) { return least * 0.5 + most * 0.5; }

}  // namespace

BufferGeometry& BufferGeometry::setAttribute(const std::string& attribute, std::vector<double> array,
                                             int itemSize) {
    if (itemSize < 1 || array.size() % static_cast<std::size_t>(itemSize) != 0)
        throw std::invalid_argument(
            describe(*this) + ": attribute '" + attribute +
            "': expected an itemSize of at least 1 that divides the number of values, found "
            "itemSize " +
            std::to_string(itemSize) + " and " + std::to_string(array.size()) + " values");
    attributes[attribute] = {std::move(array), itemSize};
    ++version_;
    return *this;
}

BufferGeometry& BufferGeometry::setIndex(std::vector<std::uint32_t> indices) {
    index = std::move(indices);
    ++version_;
    return *this;
}

const BufferAttribute* BufferGeometry::getAttribute(const std::string& attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? nullptr : &found->second;
}

std::size_t BufferGeometry::vertexCount() const {
    const BufferAttribute* positions = getAttribute("position");
    return positions == nullptr ? 0 : positions->count();
}

std::size_t BufferGeometry::triangleCount() const {
    return (index.empty() ? vertexCount() : index.size()) / 3;
}

void BufferGeometry::triangle(std::size_t number, std::uint32_t (&vertices)[3]) const {
    if (number >= triangleCount())
        throw std::out_of_range(describe(*this) + ": triangle: expected a number less than " +
                                std::to_string(triangleCount()) + ", found " + std::to_string(number));
    for (std::size_t i = 0; i < 3; ++i)
        vertices[i] = vertexOf(*this, 3 * number + i);
}

void BufferGeometry::computeVertexNormals() {
    const BufferAttribute* positions = findPositions(*this);
    if (positions == nullptr)
        return;
    requireIndicesInside(*this);
    std::vector<Wide> sums(positions->count(), Wide(0));
    const std::size_t corners = triangleCount() * 3;
    for (std::size_t first = 0; first < corners; first += 3) {
        const Wide area = areaVector(*this, *positions, first);
        for (std::size_t corner = first; corner < first + 3; ++corner)
            sums[vertexOf(*this, corner)] += area;
    }
    std::vector<double> normals;
    normals.reserve(3 * sums.size());
    for (const Wide& sum : sums)
        append(normals, unit(sum));
    setAttribute("normal", std::move(normals), 3);
}

void BufferGeometry::toFaces(BufferGeometry& faces) const {
    const BufferAttribute* positions = findPositions(*this);
    requireIndicesInside(*this);
    std::map<std::string, BufferAttribute> expanded;
    for (const auto& [key, attribute] : attributes) {
        if (key == "normal")
            continue;
        if (attribute.count() < vertexCount())
            throw std::invalid_argument(
                describe(*this) + ": attribute '" + key + "': expected " + std::to_string(vertexCount()) +
                " vertices, as many as 'position' has, found " + std::to_string(attribute.count()));
        expanded[key] = expand(*this, attribute);
    }
    BufferAttribute& normals = expanded["normal"];
    const std::size_t corners = triangleCount() * 3;
    normals.array.reserve(corners * 3);
    for (std::size_t first = 0; first < corners; first += 3) {
        const Vector3 normal = unit(areaVector(*this, *positions, first));
        for (int corner = 0; corner < 3; ++corner)
            append(normals.array, normal);
    }
    faces.attributes = std::move(expanded);
    faces.index.clear();
    faces.needsUpdate();
}

Box3 BufferGeometry::computeBoundingBox() const {
    const BufferAttribute* positions = findPositions(*this);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector3 least{infinity, infinity, infinity};
    Vector3 most{-infinity, -infinity, -infinity};
    for (std::size_t i = 0; positions != nullptr && i < positions->count(); ++i) {
        grow(positions->getX(i), least.x, most.x);
        grow(positions->getY(i), least.y, most.y);
        grow(positions->getZ(i), least.z, most.z);
    }
    const bool hasPoints = least.x <= most.x && least.y <= most.y && least.z <= most.z;
    return hasPoints ? Box3{least, most} : Box3{};
}

Sphere BufferGeometry::computeBoundingSphere() const {
    const Box3 box = computeBoundingBox();
    if (box.isEmpty())
        return {};
    Sphere sphere{{middle(box.min.x, box.max.x), middle(box.min.y, box.max.y), middle(box.min.z, box.max.z)},
                  0};
    const BufferAttribute& positions = *getAttribute("position");
    for (std::size_t i = 0; i < positions.count(); ++i) {
        const double distance = positions.getXYZ(i).distanceTo(sphere.center);
        if (distance > sphere.radius)
            sphere.radius = distance;
    }
    return sphere;
}

}  // namespace THREE
