// Thousands of lights: which of them reach which part of the picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

namespace lighting {

/// The picture in tiles, their depth in slices; each such cluster has the list of the point lights that may reach a point in it.
/// Only lights with a finite PointAddend::reach are in lists; the others shine everywhere.
struct LightClusters {
    int columns = 1;  ///< of tiles, from the left
    int rows = 1;  ///< from the bottom
    int slices = 1;  ///< in depth, from the front; each is deeper than the one before by the same factor
    double slicesPerOctave =
        0;  ///< slice = floor(log2(depth) slicesPerOctave + firstSlice), depth in frame units, view space
    double firstSlice = 0;
    /// Four numbers per cluster (slice by slice, row by row), and one more at the end: where its lights with k = 0, 1, 2 and other
    /// exponents begin in `lights`. Each list ends where the next one begins.
    std::vector<std::uint32_t> begins;
    std::vector<std::uint32_t> lights;  ///< numbers of FramePlan::point, ascending within each list

    std::size_t count() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) *
               static_cast<std::size_t>(slices);
    }
};

/// Sorts the plan's lights into clusters. Without `cull` there is one cluster with all of them (--no-skip). No list leaves
/// out a light that adds anything to a point in its cluster; some have more than they need.
LightClusters clusterLights(const FramePlan& plan, bool cull);

}  // namespace lighting
