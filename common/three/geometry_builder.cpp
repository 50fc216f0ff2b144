// What the parametric geometries share: refusing bad parameters, collecting vertices and triangles.
// SPDX-License-Identifier: MIT
#include "three/geometry_builder.hpp"

#include "three/geometries.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace THREE {

namespace {

/// Parameters are added, and multiplied by small numbers, at most: below this no coordinate overflows.
constexpr double largestParameter = 1e300;

}  // namespace

std::string numberText(double number) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

void requireUsable(const std::string& type, const Parameters& parameters) {
    for (const auto& [key, value] : parameters)
        if (!(std::fabs(value) <= largestParameter))
            throw std::invalid_argument(type + ": " + key +
                                        ": expected a finite number from -1e300 to 1e300, found " +
                                        numberText(value));
}

void requireFewVertices(const std::string& type, const Parameters& parameters, double vertices) {
    if (vertices <= maxParametricVertices)
        return;
    std::string segments;
    for (const auto& [key, value] : parameters)
        if (key.ends_with("Segments"))
            segments.append(segments.empty() ? "" : ", ").append(key).append(" ").append(numberText(value));
    throw std::invalid_argument(type + ": " + segments + ": expected at most " +
                                std::to_string(static_cast<long>(maxParametricVertices)) +
                                " vertices in all, found " + numberText(vertices) + "; use fewer segments");
}

double wholeSegments(double given, double minimum) { return std::max(minimum, std::floor(given)); }

std::vector<Direction> arcDirections(double start, double length, std::size_t n) {
    std::vector<Direction> directions(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
        const double angle = start + share(i, n) * length;
        directions[i] = {std::cos(angle), std::sin(angle)};
    }
    if (std::fabs(length) == 2 * std::numbers::pi)
        directions[n] = directions[0];
    return directions;
}

void GeometryBuilder::reserve(std::size_t vertices) {
    positions_.reserve(3 * vertices);
    normals_.reserve(3 * vertices);
    uvs_.reserve(2 * vertices);
    // In a grid there are about as many quads as vertices.
    indices_.reserve(6 * vertices);
}

void GeometryBuilder::addVertex(const Vector3& position, const Vector3& normal, double u, double v) {
    positions_.insert(positions_.end(), {position.x, position.y, position.z});
    normals_.insert(normals_.end(), {normal.x, normal.y, normal.z});
    uvs_.insert(uvs_.end(), {u, v});
}

void GeometryBuilder::addTriangle(std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t vertex : {a, b, c})
        indices_.push_back(static_cast<std::uint32_t>(vertex));
}

void GeometryBuilder::addQuad(std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    addTriangle(a, b, d);
    addTriangle(b, c, d);
}

void GeometryBuilder::addGrid(std::size_t first, std::size_t rows, std::size_t columns) {
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t a = first + row * (columns + 1) + column;
            const std::size_t b = a + columns + 1;
            addQuad(a, b, b + 1, a + 1);
        }
}

void GeometryBuilder::store(BufferGeometry& geometry) {
    geometry.setAttribute("position", std::move(positions_), 3);
    geometry.setAttribute("normal", std::move(normals_), 3);
    geometry.setAttribute("uv", std::move(uvs_), 2);
    geometry.setIndex(std::move(indices_));
}

}  // namespace THREE
