// Lobe: a function of direction as a surface.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"

#include <functional>

namespace lab {

/// A surface above the xz plane, as far from the origin in each direction as a function says: how BRDFs are drawn.
class Lobe : public THREE::BufferGeometry {
  public:
    /// The hemisphere in `rings` rings of 2 x rings quads.
    explicit Lobe(int rings = 90);

    /// Takes the shape of `radius`, a function of unit vectors with y >= 0, at least 0. Where it would reach beyond `longest`
    /// it is drawn smaller as a whole. Returns the scale, at most 1.
    double follow(const std::function<double(const THREE::Vector3&)>& radius, double longest);

  private:
    std::vector<THREE::Vector3> directions_;
};

}  // namespace lab
