// Reference: a scene drawn by evaluating the slides' equation at the exact centre of every pixel, without GL, shaders or
// frame plan. Truth for tests and graders, numbers for the pixel probe, and a picture where there is no driver.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/geometry.hpp"

#include <array>
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

/// How the camera sees a point of a surface.
enum class Sight {
    visible,
    hidden,  ///< something is in front of it
    turnedAway,  ///< its side that the material draws looks the other way
    outside  ///< not in the picture, or not between near and far
};

/// Everything about one pixel, or one point of a surface (the probe of windows and graders). World space.
template <class T>
struct Probe {
    const THREE::Mesh* mesh = nullptr;  ///< null: the background is seen, and only P counts
    std::size_t triangle = 0;
    Vec3<T> weights{T(0)};  ///< of the triangle's corners
    Vec3<T> Q{T(0)};  ///< the point
    Vec3<T> n{T(0)};  ///< unit normal; zero: none
    Vec3<T> v{T(0)};  ///< unit vector towards the eye
    T depth{0};  ///< distance along the view direction
    bool front =
        true;  ///< the front side is lit; false: the back, with its normal turned where the material says so
    bool flat = false;  ///< n is the triangle's own
    bool lit = false;  ///< false: an unlit material, P is its colour
    Vec3<T> D{T(0)};  ///< the material's colour, whether the term is on or not
    Gloss<T> gloss;  ///< of the highlight; not of unlit materials
    std::vector<Addend<T>>
        addends;  ///< of every directional and point light that is on, directional ones first
    Vec3<T> ambient{T(0)};  ///< D (x) L_A
    Vec3<T> emitted{T(0)};  ///< the material's own light
    Vec3<T> P{T(0)};  ///< the pixel, not clamped
    /// Per-vertex shading only: the sums at the triangle's corners, without emitted. P is what lies between
    /// them, plus emitted, while addends and ambient are the point's own.
    std::optional<std::array<Vec3<T>, 3>> corners;
};

/// A scene, seen by a camera, in the scalar T: float, double, long double (built into the library), or a wider one.
/// Positions, quaternions and scales of the scene count, not its matrices. The constructor copies all that
/// counts: afterwards the scene may change or go, also while another thread draws, and pointers to its meshes
/// and lights only say which ones they were. The scene must be valid (THREE::validate).
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
    /// The equation at a surface, seen or not.
    Probe<T> probe(const Surface<T>& surface) const;
    /// The nearest surface under the pixel's centre, if there is one.
    std::optional<Surface<T>> surface(int x, int y) const;
    /// The point of a mesh that has these weights in one of its triangles, on the side that its material draws
    /// (of two, the one that faces the eye), wherever the camera looks; none where the mesh is not drawn or
    /// has no such triangle.
    std::optional<Surface<T>> surfaceAt(const THREE::Mesh* mesh, std::size_t triangle,
                                        const Vec3<T>& weights) const;
    /// Where it is in the picture, in pixels from the top left corner (a pixel's centre is at half numbers), and
    /// its depth; none beside or behind the eye.
    std::optional<Vec3<T>> picture(const Surface<T>& surface) const;
    /// Whether the camera sees it.
    Sight sight(const Surface<T>& surface) const;
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
    Hit nearest(const Vec3<T>& ray, int x, int y, int margin) const;
    Surface<T> interpolated(std::size_t body, std::size_t triangle, bool front, const Vec3<T>& weights,
                            T depth) const;
    void look(const THREE::PerspectiveCamera& camera);
    Pixels pixelsOf(const Body<T>& body, std::size_t triangle) const;
    Vec3<T> ray(int x, int y) const {
        return {columns_[static_cast<std::size_t>(x)], rows_[static_cast<std::size_t>(y)], T(-1)};
    }
    Vec3<T> faceNormal(const Body<T>& body, std::size_t triangle) const;
    std::array<Vec3<T>, 3> shadedCorners(const Surface<T>& surface) const;
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
