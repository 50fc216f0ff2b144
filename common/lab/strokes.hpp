// Strokes: sticks, arrows, balls and bars as one geometry, for what a lesson draws into its scene beside its objects.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"

#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace lab {

/// Radians in a degree: lessons write angles as sliders give them, in degrees.
inline constexpr double degree = std::numbers::pi / 180;

/// The unit vector at `theta` degrees from the y axis; `phi` degrees are counted about it, from x (0) to -z (90).
THREE::Vector3 direction(double theta, double phi);
/// The point at a distance from the origin in a direction, and the same for many.
THREE::Vector3 along(const THREE::Vector3& direction, double distance);
std::vector<THREE::Vector3> along(std::span<const THREE::Vector3> directions, double distance);

/// A straight piece of a line.
struct Segment {
    THREE::Vector3 from, to;
};

/// A geometry that is drawn by hand, as often as one likes: a lesson's animation clears it and draws it anew. All places and
/// sizes are in object space; thickness is a radius. What is drawn is solid and has normals.
class Strokes : public THREE::BufferGeometry {
  public:
    Strokes() { clear(); }
    /// Nothing is drawn any more.
    Strokes& clear();
    /// A round stick from one point to another; a ball between equal ones.
    Strokes& stick(const THREE::Vector3& from, const THREE::Vector3& to, double thickness);
    Strokes& sticks(std::span<const Segment> segments, double thickness);
    /// A stick with a head at its end, which takes 12 times the thickness, at most half of the length.
    Strokes& arrow(const THREE::Vector3& from, const THREE::Vector3& to, double thickness);
    Strokes& ball(const THREE::Vector3& center, double radius);
    Strokes& balls(std::span<const THREE::Vector3> centers, double radius);
    /// A box along the axes, from one corner to the opposite one.
    Strokes& box(const THREE::Vector3& corner, const THREE::Vector3& opposite);
    /// A ring about an axis (of any length but 0) through its centre.
    Strokes& circle(const THREE::Vector3& center, const THREE::Vector3& axis, double radius,
                    double thickness);
    /// Sticks from each point to the next, with round joints.
    Strokes& line(std::span<const THREE::Vector3> points, double thickness);

  private:
    void append(const THREE::BufferGeometry& part, const THREE::Vector3& origin,
                const THREE::Vector3 (&axes)[3]);
};

/// A diagram that stands in the scene, facing +z: numbers x from `first` to `last` to the right, numbers y upwards.
struct Chart {
    using Function = std::function<double(double x)>;

    THREE::Vector3 corner;  ///< where x = first and y = 0 stand
    double width, height;  ///< from first to last, and from y = 0 to y = top
    double first, last, top;

    /// The place of a point of the diagram, `nearer` to the eye than its plane.
    THREE::Vector3 at(double number, double y, double nearer = 0) const;
    /// A bar for each of `count` numbers x, 2 or more, at equal steps from first to last; none where the function is 0.
    /// `thickness` is half its width.
    void bars(Strokes& into, int count, double thickness, const Function& function) const;
    /// The function as a line through `count` points, 2 or more.
    void curve(Strokes& into, int count, double thickness, const Function& function) const;

  private:
    double x(int i, int count) const { return first + (last - first) * i / (count - 1); }
};

}  // namespace lab
