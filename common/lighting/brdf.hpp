// The BRDF f_r(w_i, w_r) of slides 10-14, and what it does with the light that arrives: the share sent back, photons.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/vector3.hpp"

#include <functional>
#include <vector>

namespace lighting {

/// Of the light that arrives from w_i at a surface with normal n, how much leaves into each bit of solid angle about w_r
/// (slides 10-11), in 1/sr. All three are unit vectors that point away from the surface.
using Brdf =
    std::function<double(const THREE::Vector3& n, const THREE::Vector3& wi, const THREE::Vector3& wr)>;

/// Lambert's BRDF, a constant (slides 13-14): f_r = a / pi.
///
/// The pi is what makes a the share that is sent back: a surface with f_r = a would send back pi a. The slides call the
/// constant itself a and fold the pi into the light, so that P = (n . w) D L has none.
struct LambertBrdf {
    double albedo = 1;  ///< a, from 0, absorbs all, to 1, sends all back

    /// 0 unless both directions are above the surface.
    double operator()(const THREE::Vector3& n, const THREE::Vector3& wi, const THREE::Vector3& wr) const;
    /// The share that is sent back, whatever the direction of arrival: a.
    double sentBack() const { return albedo; }
};

/// The Phong material of slides 44-45 as a BRDF: f_r = a / pi + k max(0, R . w_r)^s / (pi (n . w_i)), R the mirror of w_i
/// about n. It is what gives D (n . w) L + K_S max(0, R . v)^s L with the pi in L. No real surface is like that: it may send
/// back more than arrives, and exchanging w_i with w_r changes it.
struct PhongBrdf {
    double albedo = 1;  ///< a, as Lambert's
    double specular = 0;  ///< k: how strong the highlight is, >= 0; with 0 this is Lambert's
    int shininess = 30;  ///< s: the larger, the smaller the highlight; a whole number, 0 to 100000

    /// 0 unless both directions are above the surface; without a highlight where R . w_r is not positive.
    double operator()(const THREE::Vector3& n, const THREE::Vector3& wi, const THREE::Vector3& wr) const;
    /// The share that is sent back of what arrives at `theta` radians from the normal, in closed form; 0 unless the light
    /// is above the surface.
    double sentBack(double theta) const;
};

/// What becomes of light from one direction, whatever the BRDF: its integral over the hemisphere, and single photons.
class Reflection {
  public:
    /// Divides the hemisphere about n into `rings` rings of 4 x rings cells, each as high as the others; f_r is taken at
    /// the middle of each. More rings, more accurate: 90 give a highlight of s = 100 four digits.
    Reflection(const Brdf& brdf, const THREE::Vector3& n, const THREE::Vector3& wi, int rings = 90);

    /// The share that is sent back: the integral of f_r (n . w_r) over all directions w_r. The furnace test asks whether it
    /// stays below 1.
    double sentBack() const { return rows_.back(); }
    /// Where the photons go that are sent back when `arriving` arrive: as many directions as the share says, to the nearest
    /// whole number. They are distributed as f_r (n . w_r), evenly and the same each time: not by chance.
    std::vector<THREE::Vector3> photons(int arriving) const;

  private:
    THREE::Vector3 direction(double theta, double phi) const;

    int rings_, cells_;  // cells: of each ring
    THREE::Vector3 n_, side_, front_;  // an orthonormal frame
    std::vector<double> rows_;  // light sent into the first 0, 1, 2, ... rings
    std::vector<double> columns_;  // ... and within each ring into its first 0, 1, 2, ... cells
};

/// How many of these directions are within `degrees` of an axis; unit vectors.
int countWithin(const std::vector<THREE::Vector3>& directions, const THREE::Vector3& axis, double degrees);

}  // namespace lighting
