// Single points of a Reference<T>: of a pixel, of a ray, of a surface that the camera may not even see. Comes
// with raster.hpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/raster.hpp"

namespace lighting::reference {

// The nearest hit of a ray that meets the picture in this pixel, among the triangles with a pixel so near.
template <class T>
typename Reference<T>::Hit Reference<T>::nearest(const Vec3<T>& r, int x, int y, int margin) const {
    Hit hit;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        const Body<T>& b = bodies_[body];
        for (std::size_t triangle = 0; triangle < b.triangles(); ++triangle) {
            const Pixels& seen = b.seen[triangle];
            if (x < seen.firstColumn - margin || x > seen.lastColumn + margin || y < seen.firstRow - margin ||
                y > seen.lastRow + margin)
                continue;
            const Edges edges(b, triangle);
            Vec3<T> inside;
            if (!edges.drawn(b.side) || !edges.contains(r, inside))
                continue;
            const T depth = edges.volume / (inside.x + inside.y + inside.z);
            if (depth >= near_ && depth <= far_ && (hit.body == none || depth < hit.depth))
                hit = {static_cast<std::uint32_t>(body), static_cast<std::uint32_t>(triangle), depth};
        }
    }
    return hit;
}

template <class T>
std::optional<Surface<T>> Reference<T>::surface(int x, int y) const {
    const Hit hit = nearest(ray(x, y), x, y, 0);
    return hit.body == none ? std::nullopt : extended(hit.body, hit.triangle, x, y);
}

template <class T>
std::optional<Surface<T>> Reference<T>::surfaceAt(const THREE::Mesh* mesh, std::size_t triangle,
                                                  const Vec3<T>& weights) const {
    const auto body = std::find_if(bodies_.begin(), bodies_.end(),
                                   [mesh](const Body<T>& candidate) { return candidate.mesh == mesh; });
    if (body == bodies_.end() || triangle >= body->triangles())
        return std::nullopt;
    const bool front =
        body->side == THREE::DoubleSide ? Edges(*body, triangle).front : body->side == THREE::FrontSide;
    const T depth =
        -(body->corner(triangle, 0).view.z * weights.x + body->corner(triangle, 1).view.z * weights.y +
          body->corner(triangle, 2).view.z * weights.z);
    return interpolated(static_cast<std::size_t>(body - bodies_.begin()), triangle, front, weights, depth);
}

template <class T>
std::optional<Vec3<T>> Reference<T>::picture(const Surface<T>& s) const {
    const Body<T>& b = bodies_[s.body];
    const Vec3<T> view = b.corner(s.triangle, 0).view * s.weights.x +
                         b.corner(s.triangle, 1).view * s.weights.y +
                         b.corner(s.triangle, 2).view * s.weights.z;
    if (!(view.z < T(0)))
        return std::nullopt;
    const T half(0.5);
    return Vec3<T>((half - half * view.x / (view.z * halfWidth_)) * T(width_),
                   (half + half * view.y / (view.z * halfHeight_)) * T(height_), -view.z);
}

template <class T>
Sight Reference<T>::sight(const Surface<T>& s) const {
    const std::optional<Vec3<T>> at = picture(s);
    if (!at || at->z < near_ || at->z > far_ || !(at->x >= T(0)) || !(at->x < T(width_)) ||
        !(at->y >= T(0)) || !(at->y < T(height_)))
        return Sight::outside;
    if (!Edges(bodies_[s.body], s.triangle).drawn(bodies_[s.body].side))
        return Sight::turnedAway;
    const T one(1), two(2);
    const Vec3<T> r((two * at->x / T(width_) - one) * halfWidth_,
                    (one - two * at->y / T(height_)) * halfHeight_, -one);
    // A triangle between two centres has no pixel of its own: its neighbours'.
    const Hit hit = nearest(r, static_cast<int>(at->x), static_cast<int>(at->y), 1);
    const bool itself = hit.body == s.body && hit.triangle == s.triangle;
    // Triangles that meet in the point, and surfaces that lie in one another, do not hide it.
    return hit.body == none || itself || !(hit.depth < at->z * T(1 - 1e-7)) ? Sight::visible : Sight::hidden;
}

template <class T>
Probe<T> Reference<T>::probe(int x, int y) const {
    if (const std::optional<Surface<T>> s = surface(x, y))
        return probe(*s);
    Probe<T> background;
    background.P = background_;
    return background;
}

template <class T>
Probe<T> Reference<T>::probe(const Surface<T>& s) const {
    const Body<T>& b = bodies_[s.body];
    Probe<T> probe;
    probe.mesh = b.mesh;
    probe.triangle = s.triangle;
    probe.weights = s.weights;
    probe.Q = s.Q + camera_.origin;
    probe.n = s.n;
    probe.v = unit<T>(-s.Q);
    probe.depth = s.depth;
    probe.front = s.front;
    probe.flat = b.flat;
    probe.lit = b.lit;
    probe.D = b.D;
    if (!b.lit) {
        probe.P = b.D;
        return probe;
    }
    probe.gloss = b.gloss;
    probe.emitted = b.emitted;
    probe.ambient = equation_.ambient(equation_.albedo(b.D));
    const auto keep = [&probe](const Addend<T>& addend) { probe.addends.push_back(addend); };
    probe.P = equation_.lighting(lit(s), keep) + b.emitted;
    if (switches_.shading == Shading::vertex) {
        probe.P = shade(s);
        probe.corners = shadedCorners(s);
    }
    return probe;
}

// The equation at the three corners of a surface's triangle.
template <class T>
std::array<Vec3<T>, 3> Reference<T>::shadedCorners(const Surface<T>& s) const {
    const Body<T>& b = bodies_[s.body];
    std::array<Vec3<T>, 3> P;
    for (int i = 0; i < 3; ++i) {
        const Vertex<T>& corner = b.corner(s.triangle, i);
        Lit<T> at{b.flat ? faceNormal(b, s.triangle) : corner.n, corner.Q, b.D, b.gloss};
        if (b.turnsNormals && !s.front)
            at.n = -at.n;
        P[static_cast<std::size_t>(i)] = equation_.lighting(at);
    }
    return P;
}

}  // namespace lighting::reference
