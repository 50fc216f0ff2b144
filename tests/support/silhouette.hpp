// Which pixels of a picture lie on a silhouette: where comparing two rasterisers means comparing who won the edge.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/three.hpp"

#include <cstdint>
#include <vector>

namespace support {

/// One byte per pixel, top row first: 1 away from silhouettes, 0 on one. A pixel is on a silhouette if, in a 3 x 3
/// neighbourhood, another mesh (or none) is seen, or the depth jumps: its second difference is over 1 % of the depth.
/// Seen is what the triangles that face the camera leave in a depth buffer in doubles. Matrices must be up to date.
std::vector<std::uint8_t> awayFromSilhouettes(const THREE::Scene& scene,
                                              const THREE::PerspectiveCamera& camera, int width, int height);

}  // namespace support
