// Copies of small solids, each with a place of its own, joined into one geometry.
// SPDX-License-Identifier: MIT
#include "lab/strokes.hpp"

#include "three/geometries.hpp"

#include <algorithm>
#include <cmath>

namespace lab {

using THREE::BufferAttribute;
using THREE::Vector3;

namespace {

// Unit solids: a stick along y and a cone with its point at y = 1, both from y = 0 on and of radius 1; a ball; a cube.
const THREE::CylinderGeometry& stickPart() {
    static const THREE::CylinderGeometry part(1, 1, 1, 12);
    return part;
}
const THREE::CylinderGeometry& conePart() {
    static const THREE::CylinderGeometry part(0, 1, 1, 20);
    return part;
}
const THREE::SphereGeometry& ballPart() {
    static const THREE::SphereGeometry part(1, 12, 8);
    return part;
}
const THREE::BoxGeometry& cubePart() {
    static const THREE::BoxGeometry part;
    return part;
}

// Two unit vectors at right angles to y and to each other, so that (first, y, second) is right-handed.
void across(const Vector3& y, Vector3& first, Vector3& second) {
    first = Vector3(y).cross(std::abs(y.z) < 0.9 ? Vector3(0, 0, 1) : Vector3(1, 0, 0)).normalize();
    second = Vector3(first).cross(y);
}

}  // namespace

Vector3 direction(double theta, double phi) {
    const double sine = std::sin(theta * degree);
    return {sine * std::cos(phi * degree), std::cos(theta * degree), -sine * std::sin(phi * degree)};
}

Vector3 along(const Vector3& direction, double distance) {
    return Vector3(direction).multiplyScalar(distance);
}

std::vector<Vector3> along(std::span<const Vector3> directions, double distance) {
    std::vector<Vector3> points;
    for (const Vector3& w : directions)
        points.push_back(along(w, distance));
    return points;
}

Strokes& Strokes::clear() {
    setIndex({});
    for (const char* attribute : {"position", "normal"})
        setAttribute(attribute, {}, 3);
    return *this;
}

// `axes` are at right angles; normals go with each axis divided by its squared length.
void Strokes::append(const THREE::BufferGeometry& part, const Vector3& origin, const Vector3 (&axes)[3]) {
    const auto placed = [&axes](const Vector3& v) {
        return Vector3(axes[0])
            .multiplyScalar(v.x)
            .add(Vector3(axes[1]).multiplyScalar(v.y))
            .add(Vector3(axes[2]).multiplyScalar(v.z));
    };
    BufferAttribute &positions = attributes["position"], &normals = attributes["normal"];
    const BufferAttribute &from = *part.getAttribute("position"), &with = *part.getAttribute("normal");
    const auto first = static_cast<std::uint32_t>(positions.count());
    for (std::size_t i = 0; i < from.count(); ++i) {
        const Vector3 p = Vector3(origin).add(placed(from.getXYZ(i)));
        Vector3 n = with.getXYZ(i);
        n = placed({n.x / axes[0].lengthSq(), n.y / axes[1].lengthSq(), n.z / axes[2].lengthSq()})
                .normalize();
        positions.array.insert(positions.array.end(), {p.x, p.y, p.z});
        normals.array.insert(normals.array.end(), {n.x, n.y, n.z});
    }
    for (const std::uint32_t vertex : part.index)
        index.push_back(first + vertex);
    needsUpdate();
}

Strokes& Strokes::stick(const Vector3& from, const Vector3& to, double thickness) {
    const Vector3 axis = Vector3(to).sub(from);
    const double length = axis.length();
    if (!(length > 0))
        return ball(from, thickness);
    Vector3 first, second;
    across(Vector3(axis).normalize(), first, second);
    append(stickPart(), Vector3(axis).multiplyScalar(0.5).add(from),
           {first.multiplyScalar(thickness), axis, second.multiplyScalar(thickness)});
    return *this;
}

Strokes& Strokes::sticks(std::span<const Segment> segments, double thickness) {
    for (const Segment& segment : segments)
        stick(segment.from, segment.to, thickness);
    return *this;
}

Strokes& Strokes::arrow(const Vector3& from, const Vector3& to, double thickness) {
    const Vector3 axis = Vector3(to).sub(from);
    const double length = axis.length();
    const double head = std::min(12 * thickness, length / 2);
    if (!(length > 0))
        return ball(from, thickness);
    const Vector3 unit = Vector3(axis).normalize();
    const Vector3 neck = Vector3(unit).multiplyScalar(length - head).add(from);
    Vector3 first, second;
    across(unit, first, second);
    stick(from, neck, thickness);
    append(conePart(), Vector3(unit).multiplyScalar(head / 2).add(neck),
           {first.multiplyScalar(head / 3), Vector3(unit).multiplyScalar(head),
            second.multiplyScalar(head / 3)});
    return *this;
}

Strokes& Strokes::ball(const Vector3& center, double radius) {
    append(ballPart(), center, {{radius, 0, 0}, {0, radius, 0}, {0, 0, radius}});
    return *this;
}

Strokes& Strokes::balls(std::span<const Vector3> centers, double radius) {
    for (const Vector3& center : centers)
        ball(center, radius);
    return *this;
}

Strokes& Strokes::box(const Vector3& corner, const Vector3& opposite) {
    const Vector3 size = Vector3(opposite).sub(corner);
    append(cubePart(), Vector3(size).multiplyScalar(0.5).add(corner),
           {{std::abs(size.x), 0, 0}, {0, std::abs(size.y), 0}, {0, 0, std::abs(size.z)}});
    return *this;
}

Strokes& Strokes::circle(const Vector3& center, const Vector3& axis, double radius, double thickness) {
    constexpr int corners = 48;
    Vector3 first, second;
    across(Vector3(axis).normalize(), first, second);
    std::vector<Vector3> points;
    for (int i = 0; i <= corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i % corners) / corners;
        points.push_back(Vector3(first)
                             .multiplyScalar(radius * std::cos(angle))
                             .add(Vector3(second).multiplyScalar(radius * std::sin(angle)))
                             .add(center));
    }
    return line(points, thickness);
}

Strokes& Strokes::line(std::span<const Vector3> points, double thickness) {
    for (std::size_t i = 1; i < points.size(); ++i)
        stick(points[i - 1], points[i], thickness).ball(points[i], thickness);
    return *this;
}

Vector3 Chart::at(double number, double y, double nearer) const {
    return Vector3((number - first) / (last - first) * width, y / top * height, nearer).add(corner);
}

void Chart::bars(Strokes& into, int count, double thickness, const Function& function) const {
    for (int i = 0; i < count; ++i)
        if (const double y = function(x(i, count)); y != 0)
            into.box(at(x(i, count), 0, -thickness).add({-thickness, 0, 0}),
                     at(x(i, count), y, thickness).add({thickness, 0, 0}));
}

void Chart::curve(Strokes& into, int count, double thickness, const Function& function) const {
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(at(x(i, count), function(x(i, count))));
    into.line(points, thickness);
}

}  // namespace lab
