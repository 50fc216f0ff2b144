// The geometries with round sides, vertex for vertex and triangle for triangle as three.js r146 builds them.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"

#include "three/geometry_builder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace THREE {

namespace {

constexpr double fullTurn = 2 * std::numbers::pi;

/// Sine of a polar angle. In doubles sin(pi) is 1.2e-16: the pole would be a ring, and the sphere open there.
double polarSine(double theta) { return theta == std::numbers::pi ? 0 : std::sin(theta); }

Vector3 unit(const Vector3& v) {
    const double length = v.length();
    return length > 0 ? Vector3(v.x / length, v.y / length, v.z / length) : Vector3();
}

/// a * first + b * second
Vector3 combine(double a, const Vector3& first, double b, const Vector3& second) {
    return Vector3(first).multiplyScalar(a).add(Vector3(second).multiplyScalar(b));
}

/// The middle line of the knot at `angle` round its axis of symmetry; `ratio` is q / p.
Vector3 knotCurve(double angle, double ratio, double radius) {
    const double within = ratio * angle;
    const double distance = radius * (2 + std::cos(within)) * 0.5;
    return {distance * std::cos(angle), distance * std::sin(angle), radius * std::sin(within) * 0.5};
}

/// A point of the knot's middle line and two unit vectors across the tube.
struct KnotFrame {
    Vector3 point, normal, binormal;
};

KnotFrame knotFrame(double angle, double ratio, double radius) {
    // three.js's step to the next point, not a derivative: a finer one would turn every ring of vertices a
    // little.
    const Vector3 point = knotCurve(angle, ratio, radius);
    const Vector3 next = knotCurve(angle + 0.01, ratio, radius);
    const Vector3 tangent = unit(Vector3(next).sub(point));
    const Vector3 outwards = unit(Vector3(next).add(point));
    const Vector3 binormal = unit(Vector3(tangent).cross(outwards));
    return {point, unit(Vector3(binormal).cross(tangent)), binormal};
}

/// Whether a tube around the closed knot through `points` stays clear of itself, with a twentieth to spare: it must bend less
/// sharply than it is thick, and stretches that are not neighbours must be two radii apart.
bool staysClear(const std::vector<Vector3>& points, double tube) {
    const double spare = 1.05 * std::fabs(tube);
    const std::size_t count = points.size();
    if (count < 32 || !(spare > 0))
        return false;
    std::vector<double> along{0};  // length of the curve up to each point
    for (std::size_t i = 0; i < count; ++i) {
        const Vector3 &here = points[i], &next = points[(i + 1) % count],
                      &afterNext = points[(i + 2) % count];
        const Vector3 first = Vector3(next).sub(here), second = Vector3(afterNext).sub(next);
        along.push_back(along.back() + first.length());
        const double halfTurn = std::atan2(Vector3(first).cross(second).length(), first.dot(second)) / 2;
        if (std::min(first.length(), second.length()) < 2 * spare * std::tan(halfTurn))
            return false;
    }
    const double whole = along.back();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const double between = std::min(along[j] - along[i], whole - (along[j] - along[i]));
            if (between > std::numbers::pi * spare && Vector3(points[i]).sub(points[j]).length() < 2 * spare)
                return false;
        }
    return true;
}

bool isWhole(double number) { return number == std::floor(number); }

/// A cylinder's constructor call, with whole segments.
struct Cylinder {
    double radiusTop, radiusBottom, height;
    std::size_t columns, rows;
    double thetaStart, thetaLength;
};

void addSide(GeometryBuilder& builder, const Cylinder& c) {
    // Proportional to (sin, (bottom - top) / height, cos) without the division: a height of 0 makes a disc.
    const double widening = c.radiusBottom - c.radiusTop;
    const double slant = std::hypot(c.height, widening);
    const double level = slant > 0 ? std::fabs(c.height) / slant : 1;
    const double upwards = slant > 0 ? signOf(c.height) * widening / slant : 0;
    const std::vector<Direction> round = arcDirections(c.thetaStart, c.thetaLength, c.columns);
    for (std::size_t row = 0; row <= c.rows; ++row) {
        const double v = share(row, c.rows);
        const double y = std::lerp(c.height / 2, -c.height / 2, v);
        // Exact at both ends, so that the side meets its caps.
        const double radius = std::lerp(c.radiusTop, c.radiusBottom, v);
        for (std::size_t column = 0; column <= c.columns; ++column) {
            const Direction theta = round[column];
            builder.addVertex({radius * theta.sine, y, radius * theta.cosine},
                              {level * theta.sine, upwards, level * theta.cosine}, share(column, c.columns),
                              1 - v);
        }
    }
    for (std::size_t column = 0; column < c.columns; ++column)
        for (std::size_t row = 0; row < c.rows; ++row) {
            const std::size_t a = row * (c.columns + 1) + column;
            const std::size_t b = a + c.columns + 1;
            builder.addQuad(a, b, b + 1, a + 1);
        }
}

/// `up` is 1 for the cap at the top, -1 for the one at the bottom. As in three.js every triangle has a centre
/// of its own.
void addCap(GeometryBuilder& builder, const Cylinder& c, double radius, double up) {
    const std::size_t centre = builder.vertexCount();
    const std::size_t rim = centre + c.columns;
    const Vector3 normal{0, up, 0};
    const double y = up * c.height / 2;
    for (std::size_t column = 0; column < c.columns; ++column)
        builder.addVertex({0, y, 0}, normal, 0.5, 0.5);
    for (const Direction& theta : arcDirections(c.thetaStart, c.thetaLength, c.columns))
        builder.addVertex({radius * theta.sine, y, radius * theta.cosine}, normal, theta.cosine * 0.5 + 0.5,
                          theta.sine * 0.5 * up + 0.5);
    for (std::size_t column = 0; column < c.columns; ++column)
        if (up > 0)
            builder.addTriangle(rim + column, rim + column + 1, centre + column);
        else
            builder.addTriangle(rim + column + 1, rim + column, centre + column);
}

}  // namespace

SphereGeometry::SphereGeometry(double radius, double widthSegments, double heightSegments, double phiStart,
                               double phiLength, double thetaStart, double thetaLength)
    : parameters_{
          {"radius", radius},          {"widthSegments", widthSegments}, {"heightSegments", heightSegments},
          {"phiStart", phiStart},      {"phiLength", phiLength},         {"thetaStart", thetaStart},
          {"thetaLength", thetaLength}} {
    requireUsable("SphereGeometry", parameters_);
    const double w = wholeSegments(widthSegments, 3);
    const double h = wholeSegments(heightSegments, 2);
    requireFewVertices("SphereGeometry", parameters_, gridVertices(h, w));
    GeometryBuilder builder(gridVertices(h, w));
    const auto columns = static_cast<std::size_t>(w);
    const auto rows = static_cast<std::size_t>(h);
    const std::vector<Direction> meridians = arcDirections(phiStart, phiLength, columns);
    const double thetaEnd = std::min(thetaStart + thetaLength, std::numbers::pi);
    for (std::size_t row = 0; row <= rows; ++row) {
        const double v = share(row, rows);
        const double theta = thetaStart + v * thetaLength;
        // At a pole each triangle has a vertex of its own, in the middle of its strip of the texture.
        const bool isTop = row == 0 && thetaStart == 0;
        const bool isBottom = row == rows && thetaEnd == std::numbers::pi;
        const double shift = (isTop ? 0.5 : isBottom ? -0.5 : 0) / w;
        for (std::size_t column = 0; column <= columns; ++column) {
            const Direction phi = meridians[column];
            const Vector3 out{-phi.cosine * polarSine(theta), std::cos(theta), phi.sine * polarSine(theta)};
            builder.addVertex(Vector3(out).multiplyScalar(radius),
                              Vector3(out).multiplyScalar(signOf(radius)), share(column, columns) + shift,
                              1 - v);
        }
    }
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t upper = row * (columns + 1) + column;
            const std::size_t lower = upper + columns + 1;
            // Next to a pole one half of the quad has no area.
            if (row != 0 || thetaStart > 0)
                builder.addTriangle(upper + 1, upper, lower + 1);
            if (row != rows - 1 || thetaEnd < std::numbers::pi)
                builder.addTriangle(upper, lower, lower + 1);
        }
    builder.store(*this);
}

TorusGeometry::TorusGeometry(double radius, double tube, double radialSegments, double tubularSegments,
                             double arc)
    : parameters_{{"radius", radius},
                  {"tube", tube},
                  {"radialSegments", radialSegments},
                  {"tubularSegments", tubularSegments},
                  {"arc", arc}} {
    requireUsable("TorusGeometry", parameters_);
    const double rowSegments = wholeSegments(radialSegments, 1);
    const double columnSegments = wholeSegments(tubularSegments, 1);
    requireFewVertices("TorusGeometry", parameters_, gridVertices(rowSegments, columnSegments));
    GeometryBuilder builder(gridVertices(rowSegments, columnSegments));
    const auto rows = static_cast<std::size_t>(rowSegments);
    const auto columns = static_cast<std::size_t>(columnSegments);
    const std::vector<Direction> rounds = arcDirections(0, arc, columns);
    const std::vector<Direction> tilts = arcDirections(0, fullTurn, rows);
    for (std::size_t row = 0; row <= rows; ++row)
        for (std::size_t column = 0; column <= columns; ++column) {
            const Direction round = rounds[column];
            const Direction tilt = tilts[row];
            const double distance = radius + tube * tilt.cosine;
            const Vector3 out{tilt.cosine * round.cosine, tilt.cosine * round.sine, tilt.sine};
            builder.addVertex({distance * round.cosine, distance * round.sine, tube * tilt.sine},
                              Vector3(out).multiplyScalar(signOf(tube)), share(column, columns),
                              share(row, rows));
        }
    for (std::size_t row = 1; row <= rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t a = row * (columns + 1) + column;
            const std::size_t b = a - columns - 1;
            builder.addQuad(a, b, b + 1, a + 1);
        }
    builder.store(*this);
    if (arc == fullTurn && std::fabs(tube) < std::fabs(radius))
        meetsItselfNowhere();
}

TorusKnotGeometry::TorusKnotGeometry(double radius, double tube, double tubularSegments,
                                     double radialSegments, double p, double q)
    : parameters_{{"radius", radius},
                  {"tube", tube},
                  {"tubularSegments", tubularSegments},
                  {"radialSegments", radialSegments},
                  {"p", p},
                  {"q", q}} {
    requireUsable("TorusKnotGeometry", parameters_);
    const double ratio = q / p;
    if (!std::isfinite(ratio))
        throw std::invalid_argument(
            "TorusKnotGeometry: p: expected a number other than 0 that q can be divided by, "
            "found " +
            numberText(p));
    const double rowSegments = wholeSegments(tubularSegments, 1);
    const double columnSegments = wholeSegments(radialSegments, 1);
    requireFewVertices("TorusKnotGeometry", parameters_, gridVertices(rowSegments, columnSegments));
    GeometryBuilder builder(gridVertices(rowSegments, columnSegments));
    const auto rows = static_cast<std::size_t>(rowSegments);
    const auto columns = static_cast<std::size_t>(columnSegments);
    const std::vector<Direction> rounds = arcDirections(0, fullTurn, columns);
    // Only then does the curve end where it began, and the last ring must be the first to the bit.
    const bool closes = isWhole(p) && isWhole(q);
    std::vector<Vector3> middle;
    for (std::size_t row = 0; row <= rows; ++row) {
        const double turns = closes && row == rows ? 0 : share(row, rows) * p;
        const KnotFrame frame = knotFrame(turns * fullTurn, ratio, radius);
        if (row < rows)
            middle.push_back(frame.point);
        for (std::size_t column = 0; column <= columns; ++column) {
            const Direction round = rounds[column];
            const Vector3 out = combine(-round.cosine, frame.normal, round.sine, frame.binormal);
            builder.addVertex(combine(1, frame.point, tube, out), Vector3(out).multiplyScalar(signOf(tube)),
                              share(row, rows), share(column, columns));
        }
    }
    builder.addGrid(0, rows, columns);
    builder.store(*this);
    if (closes && rows <= 4096 && staysClear(middle, tube))
        meetsItselfNowhere();
}

CylinderGeometry::CylinderGeometry(double radiusTop, double radiusBottom, double height,
                                   double radialSegments, double heightSegments, bool openEnded,
                                   double thetaStart, double thetaLength)
    : parameters_{{"radiusTop", radiusTop},
                  {"radiusBottom", radiusBottom},
                  {"height", height},
                  {"radialSegments", radialSegments},
                  {"heightSegments", heightSegments},
                  {"openEnded", openEnded ? 1 : 0},
                  {"thetaStart", thetaStart},
                  {"thetaLength", thetaLength}} {
    requireUsable("CylinderGeometry", parameters_);
    const double columns = wholeSegments(radialSegments, 1);
    const double rows = wholeSegments(heightSegments, 1);
    const double vertices = gridVertices(rows, columns) + (openEnded ? 0 : 2 * (2 * columns + 1));
    requireFewVertices("CylinderGeometry", parameters_, vertices);
    GeometryBuilder builder(vertices);
    const Cylinder cylinder{
        radiusTop,  radiusBottom, height, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows),
        thetaStart, thetaLength};
    addSide(builder, cylinder);
    if (!openEnded && radiusTop > 0)
        addCap(builder, cylinder, radiusTop, 1);
    if (!openEnded && radiusBottom > 0)
        addCap(builder, cylinder, radiusBottom, -1);
    builder.store(*this);
}

}  // namespace THREE
