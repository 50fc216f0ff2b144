// What the parametric geometries share: refusing bad parameters, collecting vertices and triangles.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace THREE {

/// A constructor's numbers by three.js's names, in its order.
using Parameters = std::vector<std::pair<std::string, double>>;

/// The shortest digits that read back as the same double, whatever the locale: for messages.
std::string numberText(double number);

/// Throws std::invalid_argument for a parameter that is not finite or so large that a sum of two could
/// overflow.
void requireUsable(const std::string& type, const Parameters& parameters);

/// Throws std::invalid_argument, naming the parameters that end in "Segments", above maxParametricVertices.
void requireFewVertices(const std::string& type, const Parameters& parameters, double vertices);

/// A number of segments as three.js takes it: the fraction dropped, at least `minimum`. It may be too large
/// for an integer: requireFewVertices comes before any cast.
double wholeSegments(double given, double minimum);

/// Vertices of a grid of so many quads.
inline double gridVertices(double rows, double columns) { return (rows + 1) * (columns + 1); }

/// i / n, from 0 to exactly 1.
inline double share(std::size_t i, std::size_t n) { return static_cast<double>(i) / static_cast<double>(n); }

/// Where an angle points: its cosine and sine.
struct Direction {
    double cosine;
    double sine;
};

/// The n + 1 directions that divide an arc into n steps. The last of a full turn is the first one again, to
/// the bit: sin(2 pi) is not 0 in doubles, and the surface would not close.
std::vector<Direction> arcDirections(double start, double length, std::size_t n);

/// 1 or -1: normals point the other way where a radius is negative.
inline double signOf(double number) { return number < 0 ? -1 : 1; }

/// Collects vertices and triangles, then hands them to a geometry.
class GeometryBuilder {
  public:
    explicit GeometryBuilder(double vertices) { reserve(static_cast<std::size_t>(vertices)); }

    /// The number that the next vertex gets.
    std::size_t vertexCount() const { return positions_.size() / 3; }
    void addVertex(const Vector3& position, const Vector3& normal, double u, double v);
    void addTriangle(std::size_t a, std::size_t b, std::size_t c);
    /// Two triangles, divided from b to d as three.js divides them; a, b, c, d counter-clockwise.
    void addQuad(std::size_t a, std::size_t b, std::size_t c, std::size_t d);
    /// The quads between (rows + 1) x (columns + 1) vertices from `first` on, row after row; seen from the
    /// front, rows go down and columns to the right.
    void addGrid(std::size_t first, std::size_t rows, std::size_t columns);
    /// Moves everything out, as the attributes "position", "normal", "uv" and the index.
    void store(BufferGeometry& geometry);

  private:
    void reserve(std::size_t vertices);

    std::vector<double> positions_;
    std::vector<double> normals_;
    std::vector<double> uvs_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace THREE
