// Reference: a scene drawn by evaluating the slides' equation at the exact centre of every pixel, without GL, shaders or
// frame plan. Truth for tests and graders, numbers for the pixel probe, and a picture where there is no driver.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/geometry.hpp"

#include <functional>
#include <optional>

namespace lighting::reference {

/// A point of a surface as one pixel sees it.
template <class T>
struct Surface {
    std::size_t body;  ///< number of the mesh among those drawn
    std::size_t triangle;  ///< of its geometry
    bool front;  ///< its front side is seen
    Vec3<T> weights;  ///< of its three corners; they add up to 1
    T depth;  ///< along the view direction, world units of the camera
    Vec3<T> Q;  ///< the point, world space relative to the eye
    Vec3<T>
        n;  ///< unit normal there, turned towards the side that is seen where the material says so; zero: none
};

/// Everything about one pixel (the probe of windows and graders). World space.
template <class T>
struct Probe {
    const THREE::Mesh* mesh = nullptr;  ///< null: the background is seen, and only P counts
    std::size_t triangle = 0;
    Vec3<T> Q{T(0)};  ///< the point
    Vec3<T> n{T(0)};  ///< unit normal
    T depth{0};  ///< distance along the view direction
    bool lit = false;  ///< false: an unlit material, P is its colour
    std::vector<Addend<T>>
        addends;  ///< of every directional and point light that is on, directional ones first
    Vec3<T> ambient{T(0)};  ///< D (x) L_A
    Vec3<T> emitted{T(0)};  ///< the material's own light
    Vec3<T> P{T(0)};  ///< the pixel, not clamped
};

/// A scene, seen by a camera, in the scalar T: float, double, long double (built into the library), or a wider one.
/// Positions, quaternions and scales of the scene count, not its matrices. Geometries and lights must stay as they are while
/// this lives; the scene must be valid (THREE::validate).
template <class T>
class Reference {
  public:
    /// `width` and `height` in pixels; the camera's own aspect is used. Of the switches, `space` makes no difference: points
    /// and vectors are always in world space about the eye.
    /// draw() draws what `shown` asks for; all the rest is about its surfaces and lights, and about P.
    Reference(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera, const Switches& switches,
              int width, int height, const Look& shown = {});

    /// Receives pixels, top left first in each row; from several threads at once, each pixel once.
    using Sink = std::function<void(int x, int y, const Vec3<T>& P)>;
    /// Is told the share that is done, 0 to 1, from one thread at a time.
    using Progress = std::function<void(double share)>;
    /// Evaluates every pixel, on all cores.
    void draw(const Sink& sink, const Progress& progress = {}) const;

    /// The surface of one pixel, or none where the background is seen.
    using SurfaceSink = std::function<void(int x, int y, const std::optional<Surface<T>>& surface)>;
    /// What every pixel sees, not shaded: for equations other than this one. As draw otherwise.
    void surfaces(const SurfaceSink& sink, const Progress& progress = {}) const;

    /// What the pixel shows; 0,0 is the top left.
    Probe<T> probe(int x, int y) const;
    /// The nearest surface under the pixel's centre, if there is one.
    std::optional<Surface<T>> surface(int x, int y) const;
    /// What a triangle, taken as a whole plane, shows at a pixel; none where the plane is behind the eye or edge-on.
    std::optional<Surface<T>> extended(std::size_t body, std::size_t triangle, int x, int y) const;
    /// The equation at a surface, with the emitted light: P of one pixel.
    Vec3<T> shade(const Surface<T>& surface) const;
    /// The point of a surface as the equation wants it.
    Lit<T> lit(const Surface<T>& surface) const {
        const Body<T>& body = bodies_[surface.body];
        return {surface.n, surface.Q, body.D, body.gloss};
    }

    /// 1 for a pixel within one pixel of an edge, else 0; top row first. An edge is where neighbouring pixels show different
    /// meshes, or a triangle that, extended to this pixel, would be more than 1 % nearer or farther or have a normal that
    /// differs by more than `normalJump`: silhouettes and creases, not the triangles of a smooth surface.
    std::vector<std::uint8_t> edges(double normalJump = 0.1) const;

    const Equation<T>& equation() const { return equation_; }
    const std::vector<Body<T>>& bodies() const { return bodies_; }
    const Vec3<T>& eye() const { return camera_.origin; }  ///< world space
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    struct Hit {
        std::uint32_t body = none, triangle = 0;
        T depth{0};
    };
    struct Edges;  // of one triangle, as seen from the eye
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::vector<Hit> visible(int firstRow, int endRow) const;
    void rasterise(std::uint32_t body, std::uint32_t triangle, const Pixels& pixels, int firstRow,
                   std::vector<Hit>& hits) const;
    Surface<T> surfaceAt(std::size_t body, std::size_t triangle, const Edges& edges,
                         const Vec3<T>& inside) const;
    void look(const THREE::PerspectiveCamera& camera);
    Pixels pixelsOf(const Body<T>& body, std::size_t triangle) const;
    Vec3<T> ray(int x, int y) const {
        return {columns_[static_cast<std::size_t>(x)], rows_[static_cast<std::size_t>(y)], T(-1)};
    }
    Vec3<T> faceNormal(const Body<T>& body, std::size_t triangle) const;
    Vec3<T> shadeVertices(const Surface<T>& surface) const;
    Vec3<T> display(const Surface<T>& surface, int x, int y) const;
    bool isEdge(const std::vector<Hit>& hits, int x, int y, double normalJump) const;

    int width_, height_;
    Place<T> camera_;
    T halfWidth_, halfHeight_;  // of the picture at depth 1
    std::vector<T> columns_, rows_;  // x and y, at depth 1, of the rays through the pixels' centres
    T near_, far_;
    Vec3<T> background_;
    Switches switches_;
    Painter<T> painter_;
    bool data_;  // a factor is drawn, not P
    Equation<T> equation_;
    std::vector<Body<T>> bodies_;
};

/// Runs work(i) for i from 0 to count - 1 on all cores; the first exception is passed on.
void onAllCores(int count, const std::function<void(int)>& work);

extern template class Reference<float>;
extern template class Reference<double>;
extern template class Reference<long double>;

}  // namespace lighting::reference
