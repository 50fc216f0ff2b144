// The geometries with flat sides, vertex for vertex and triangle for triangle as three.js r146 builds them.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"

#include "three/geometry_builder.hpp"

#include <array>

namespace THREE {

namespace {

/// Step i of n from -size / 2 to size / 2. Mirrored steps give mirrored numbers to the bit, so that the faces
/// of a box meet in the same points whichever way each of them counts.
double centred(double size, std::size_t i, std::size_t n) {
    const double twice = 2 * static_cast<double>(i) - static_cast<double>(n);
    return size / 2 * (twice / static_cast<double>(n));
}

/// One side of a box, or a plane. Axes are 0 for x, 1 for y, 2 for z.
struct Rectangle {
    std::size_t across, down, out;  ///< the axes along columns, along rows, and of the normal
    double acrossSign, downSign;  ///< which way columns and rows run on their axes
    double width, height;  ///< size along columns and rows
    double offset;  ///< coordinate on the axis `out`
    double normal;  ///< 1 or -1, on the axis `out`
    double columns, rows;
};

void addRectangle(GeometryBuilder& builder, const Rectangle& side) {
    const std::size_t first = builder.vertexCount();
    const auto columns = static_cast<std::size_t>(side.columns);
    const auto rows = static_cast<std::size_t>(side.rows);
    std::array<double, 3> normal{};
    normal[side.out] = side.normal;
    std::array<double, 3> position{};
    position[side.out] = side.offset;
    for (std::size_t row = 0; row <= rows; ++row)
        for (std::size_t column = 0; column <= columns; ++column) {
            position[side.across] = side.acrossSign * centred(side.width, column, columns);
            position[side.down] = side.downSign * centred(side.height, row, rows);
            builder.addVertex({position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]},
                              share(column, columns), 1 - share(row, rows));
        }
    builder.addGrid(first, rows, columns);
}

}  // namespace

BoxGeometry::BoxGeometry(double width, double height, double depth, double widthSegments,
                         double heightSegments, double depthSegments)
    : parameters_{{"width", width},
                  {"height", height},
                  {"depth", depth},
                  {"widthSegments", widthSegments},
                  {"heightSegments", heightSegments},
                  {"depthSegments", depthSegments}} {
    requireUsable("BoxGeometry", parameters_);
    const double w = wholeSegments(widthSegments, 1);
    const double h = wholeSegments(heightSegments, 1);
    const double d = wholeSegments(depthSegments, 1);
    const double vertices = 2 * (gridVertices(h, d) + gridVertices(d, w) + gridVertices(h, w));
    requireFewVertices("BoxGeometry", parameters_, vertices);
    GeometryBuilder builder(vertices);
    constexpr std::size_t x = 0, y = 1, z = 2;
    // three.js takes the normal's sign from the size: a box of a negative size is inside out, one of size 0
    // looks back.
    const auto front = [](double size) { return size > 0 ? 1.0 : -1.0; };
    const auto back = [](double size) { return size < 0 ? 1.0 : -1.0; };
    addRectangle(builder, {z, y, x, -1, -1, depth, height, width / 2, front(width), d, h});
    addRectangle(builder, {z, y, x, 1, -1, depth, height, -width / 2, back(width), d, h});
    addRectangle(builder, {x, z, y, 1, 1, width, depth, height / 2, front(height), w, d});
    addRectangle(builder, {x, z, y, 1, -1, width, depth, -height / 2, back(height), w, d});
    addRectangle(builder, {x, y, z, 1, -1, width, height, depth / 2, front(depth), w, h});
    addRectangle(builder, {x, y, z, -1, -1, width, height, -depth / 2, back(depth), w, h});
    builder.store(*this);
}

PlaneGeometry::PlaneGeometry(double width, double height, double widthSegments, double heightSegments)
    : parameters_{{"width", width},
                  {"height", height},
                  {"widthSegments", widthSegments},
                  {"heightSegments", heightSegments}} {
    requireUsable("PlaneGeometry", parameters_);
    const double columns = wholeSegments(widthSegments, 1);
    const double rows = wholeSegments(heightSegments, 1);
    requireFewVertices("PlaneGeometry", parameters_, gridVertices(rows, columns));
    GeometryBuilder builder(gridVertices(rows, columns));
    addRectangle(builder, {0, 1, 2, 1, -1, width, height, 0, 1, columns, rows});
    builder.store(*this);
}

}  // namespace THREE
