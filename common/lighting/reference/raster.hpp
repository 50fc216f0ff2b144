// The rasteriser of Reference<T>. Included where a scalar of one's own is wanted; the usual three are in the library.
//
// A pixel is a ray r from the eye through its centre. A triangle with corners a, b, c in view space is hit where r lies on
// the inner side of the three planes through the eye and an edge: r . (b x c), r . (c x a), r . (a x b) of one sign. These
// three numbers are, divided by their sum, the weights of the corners at the hit itself, perspective and all; corners behind
// the eye need no clipping.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/reference.hpp"

#include <mutex>

namespace lighting::reference {

template <class T>
struct Reference<T>::Edges {
    Vec3<T> plane[3];  // normals of the planes through the eye and the edge opposite to corner i, inwards
    T volume;  // six times the volume between eye and triangle, > 0
    bool front;  // the front side is seen

    explicit Edges(const Body<T>& body, std::size_t triangle) {
        const Vec3<T>& a = body.corner(triangle, 0).view;
        const Vec3<T>& b = body.corner(triangle, 1).view;
        const Vec3<T>& c = body.corner(triangle, 2).view;
        plane[0] = glm::cross(b, c);
        plane[1] = glm::cross(c, a);
        plane[2] = glm::cross(a, b);
        volume = glm::dot(a, plane[0]);
        const bool counterClockwise = volume < T(0);
        front = counterClockwise != body.mirrored;
        if (counterClockwise) {
            volume = -volume;
            for (Vec3<T>& p : plane)
                p = -p;
        }
    }

    // Whether a material that draws `side` draws this triangle; edge-on none does.
    bool drawn(THREE::Side side) const {
        return volume > T(0) && (side == THREE::DoubleSide || front == (side == THREE::FrontSide));
    }

    // How far r is inside each edge. A ray exactly on an edge belongs to one of the two triangles that share it.
    bool contains(const Vec3<T>& r, Vec3<T>& inside) const {
        for (int i = 0; i < 3; ++i) {
            inside[i] = glm::dot(r, plane[i]);
            const bool mine = plane[i].x > T(0) || (plane[i].x == T(0) && plane[i].y > T(0));
            if (!(inside[i] > T(0) || (inside[i] == T(0) && mine)))
                return false;
        }
        return true;
    }
};

template <class T>
Reference<T>::Reference(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                        const Switches& switches, int width, int height, const Look& shown)
    : width_(width), height_(height), camera_(placeOf<T>(camera)), near_(T(camera.near)), far_(T(camera.far)),
      background_(scene.background ? toVec<T>(*scene.background) : Vec3<T>(T(0))), switches_(switches),
      painter_(shown.view), data_(isData(shown.view)),
      equation_(makeEquation<T>(scene, switches.terms, camera_.origin, lookAt(scene, shown))) {
    scene.traverseVisible([this](const THREE::Object3D& object) {
        const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object);
        if (mesh != nullptr && mesh->material->visible && mesh->geometry->triangleCount() > 0)
            bodies_.push_back(makeBody<T>(*mesh, camera_, switches_));
    });
    for (Body<T>& body : bodies_)
        if (body.lit && isAddend(shown.view)) {
            body.emitted = Vec3<T>(T(0));
            body.D = shown.view == ViewMode::specular ? Vec3<T>(T(0)) : body.D;
        }
    look(camera);
}

// The rays through the pixels, and where the corners of the triangles are seen.
template <class T>
void Reference<T>::look(const THREE::PerspectiveCamera& camera) {
    using std::atan;
    using std::tan;
    halfHeight_ = tan(T(camera.fov) * atan(T(1)) / T(90)) / T(camera.zoom);  // atan(1) / 90 is half a degree
    halfWidth_ = halfHeight_ * T(camera.aspect);
    for (int x = 0; x < width_; ++x)
        columns_.push_back((T(2 * x + 1) / T(width_) - T(1)) * halfWidth_);
    for (int y = 0; y < height_; ++y)
        rows_.push_back((T(1) - T(2 * y + 1) / T(height_)) * halfHeight_);
    for (Body<T>& body : bodies_)
        for (std::size_t triangle = 0; triangle < body.triangles(); ++triangle)
            body.seen.push_back(pixelsOf(body, triangle));
}

// The pixels whose centres lie between a triangle's corners; all of them where a corner is beside or behind the eye.
template <class T>
Pixels Reference<T>::pixelsOf(const Body<T>& body, std::size_t triangle) const {
    constexpr double margin = 0.01;  // more than rounding
    double left = width_, right = 0, top = height_, bottom = 0;
    for (int i = 0; i < 3; ++i) {
        const Vec3<T>& v = body.corner(triangle, i).view;
        if (!(v.z < T(0)))
            return {0, width_ - 1, 0, height_ - 1};
        const double column = (1 - static_cast<double>(v.x / (v.z * halfWidth_))) * 0.5 * width_;
        const double row = (1 + static_cast<double>(v.y / (v.z * halfHeight_))) * 0.5 * height_;
        left = std::min(left, column);
        right = std::max(right, column);
        top = std::min(top, row);
        bottom = std::max(bottom, row);
    }
    const auto first = [](double edge, int size) {
        return static_cast<int>(std::clamp(std::ceil(edge - 0.5 - margin), 0.0, size + 0.0));
    };
    const auto last = [](double edge, int size) {
        return static_cast<int>(std::clamp(std::floor(edge - 0.5 + margin), -1.0, size - 1.0));
    };
    return {first(left, width_), last(right, width_), first(top, height_), last(bottom, height_)};
}

// Puts one triangle into the rows from firstRow on, which `hits` has.
template <class T>
void Reference<T>::rasterise(std::uint32_t body, std::uint32_t triangle, const Pixels& pixels, int firstRow,
                             std::vector<Hit>& hits) const {
    const Body<T>& b = bodies_[body];
    const Edges edges(b, triangle);
    if (!edges.drawn(b.side))
        return;
    for (int row = pixels.firstRow; row <= pixels.lastRow; ++row)
        for (int column = pixels.firstColumn; column <= pixels.lastColumn; ++column) {
            Vec3<T> inside;
            if (!edges.contains(ray(column, row), inside))
                continue;
            const T depth = edges.volume / (inside.x + inside.y + inside.z);
            Hit& hit = hits[static_cast<std::size_t>((row - firstRow) * width_ + column)];
            if (depth >= near_ && depth <= far_ && (hit.body == none || depth < hit.depth))
                hit = {body, triangle, depth};
        }
}

template <class T>
std::vector<typename Reference<T>::Hit> Reference<T>::visible(int firstRow, int endRow) const {
    std::vector<Hit> hits(static_cast<std::size_t>(endRow - firstRow) * static_cast<std::size_t>(width_));
    for (std::size_t body = 0; body < bodies_.size(); ++body)
        for (std::size_t triangle = 0; triangle < bodies_[body].triangles(); ++triangle) {
            Pixels pixels = bodies_[body].seen[triangle];
            pixels.firstRow = std::max(pixels.firstRow, firstRow);
            pixels.lastRow = std::min(pixels.lastRow, endRow - 1);
            if (pixels.firstRow <= pixels.lastRow && pixels.firstColumn <= pixels.lastColumn)
                rasterise(static_cast<std::uint32_t>(body), static_cast<std::uint32_t>(triangle), pixels,
                          firstRow, hits);
        }
    return hits;
}

template <class T>
Surface<T> Reference<T>::interpolated(std::size_t body, std::size_t triangle, bool front,
                                      const Vec3<T>& weights, T depth) const {
    const Body<T>& b = bodies_[body];
    const Vertex<T>& v0 = b.corner(triangle, 0);
    const Vertex<T>& v1 = b.corner(triangle, 1);
    const Vertex<T>& v2 = b.corner(triangle, 2);
    Surface<T> s{body, triangle, front, weights, depth, {}, {}};
    s.Q = v0.Q * weights.x + v1.Q * weights.y + v2.Q * weights.z;
    s.n = b.flat ? faceNormal(b, triangle) : unit<T>(v0.n * weights.x + v1.n * weights.y + v2.n * weights.z);
    if (b.turnsNormals && !front)
        s.n = -s.n;
    return s;
}

template <class T>
std::optional<Surface<T>> Reference<T>::extended(std::size_t body, std::size_t triangle, int x, int y) const {
    const Edges edges(bodies_[body], triangle);
    const Vec3<T> r = ray(x, y);
    const Vec3<T> inside(glm::dot(r, edges.plane[0]), glm::dot(r, edges.plane[1]),
                         glm::dot(r, edges.plane[2]));
    if (!(edges.volume > T(0)) || !(inside.x + inside.y + inside.z > T(0)))
        return std::nullopt;
    const T perSum = T(1) / (inside.x + inside.y + inside.z);
    return interpolated(body, triangle, edges.front, inside * perSum, edges.volume * perSum);
}

template <class T>
Vec3<T> Reference<T>::faceNormal(const Body<T>& body, std::size_t triangle) const {
    const Vec3<T>& Q = body.corner(triangle, 0).Q;
    const Vec3<T> across = glm::cross(body.corner(triangle, 1).Q - Q, body.corner(triangle, 2).Q - Q);
    return body.asAsked(unit<T>(body.mirrored ? -across : across));
}

template <class T>
Vec3<T> Reference<T>::shade(const Surface<T>& s) const {
    const Body<T>& b = bodies_[s.body];
    if (!b.lit)
        return b.D;
    if (switches_.shading != Shading::vertex)
        return equation_.lighting(lit(s)) + b.emitted;
    // Gouraud's shading: what lies between the corners' P.
    const std::array<Vec3<T>, 3> P = shadedCorners(s);
    return P[0] * s.weights[0] + P[1] * s.weights[1] + P[2] * s.weights[2] + b.emitted;
}

// What draw() makes of a surface.
template <class T>
Vec3<T> Reference<T>::display(const Surface<T>& s, int x, int y) const {
    const int fromBottom = height_ - 1 - y;
    if (!data_)
        return painter_.present(shade(s), x, fromBottom);
    const Body<T>& b = bodies_[s.body];
    return b.lit ? painter_.factor(equation_, lit(s), x, fromBottom) : painter_.unlit(b.D);
}

template <class T>
void Reference<T>::draw(const Sink& sink, const Progress& progress) const {
    const auto shaded = [&](int x, int y, const std::optional<Surface<T>>& s) {
        sink(x, y, s ? display(*s, x, y) : painter_.background(background_));
    };
    surfaces(shaded, progress);
}

template <class T>
void Reference<T>::surfaces(const SurfaceSink& sink, const Progress& progress) const {
    const int rows = std::clamp(height_ / 16, 1, 64);
    const int bands = (height_ + rows - 1) / rows;
    std::mutex telling;
    int done = 0;
    onAllCores(bands, [&](int band) {
        const int first = band * rows, end = std::min(first + rows, height_);
        const std::vector<Hit> hits = visible(first, end);
        for (int y = first; y < end; ++y)
            for (int x = 0; x < width_; ++x) {
                const Hit& hit = hits[static_cast<std::size_t>((y - first) * width_ + x)];
                sink(x, y, hit.body == none ? std::nullopt : extended(hit.body, hit.triangle, x, y));
            }
        if (progress) {
            const std::lock_guard<std::mutex> lock(telling);
            progress(static_cast<double>(++done) / bands);
        }
    });
}

template <class T>
bool Reference<T>::isEdge(const std::vector<Hit>& hits, int x, int y, double normalJump) const {
    const auto at = [&](int column, int row) -> const Hit& {
        return hits[static_cast<std::size_t>(row * width_ + column)];
    };
    const Hit& here = at(x, y);
    std::optional<Surface<T>> mine;  // found when first needed
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, height_ - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, width_ - 1); ++column) {
            const Hit& there = at(column, row);
            if (there.body != here.body)
                return true;
            if (here.body == none || there.triangle == here.triangle)
                continue;
            if (!mine)
                mine = extended(here.body, here.triangle, x, y);
            const std::optional<Surface<T>> theirs = extended(there.body, there.triangle, x, y);
            if (!theirs || !(std::abs(static_cast<double>(theirs->depth / mine->depth) - 1) <= 0.01) ||
                !(static_cast<double>(glm::dot(theirs->n - mine->n, theirs->n - mine->n)) <=
                  normalJump * normalJump))
                return true;
        }
    return false;
}

template <class T>
std::vector<std::uint8_t> Reference<T>::edges(double normalJump) const {
    const std::vector<Hit> hits = visible(0, height_);
    std::vector<std::uint8_t> mask(hits.size());
    onAllCores(height_, [&](int y) {
        for (int x = 0; x < width_; ++x)
            mask[static_cast<std::size_t>(y * width_ + x)] = isEdge(hits, x, y, normalJump) ? 1 : 0;
    });
    return mask;
}

}  // namespace lighting::reference

#include "lighting/reference/point.hpp"
