// Beam: parallel rays of light that end on the first thing in their way.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/strokes.hpp"
#include "three/scene.hpp"

#include <vector>

namespace lab {

/// A beam of equally spaced parallel rays, and what each of them hits (slides 16-23). Rays are counted where they meet
/// triangles, as three.js's Raycaster does: nothing here knows of cosines.
class Beam {
  public:
    /// `columns` x `rows` rays that fly downwards (-y) from the height `top` on, about the y axis; `across` is from column to
    /// column (x), `along` from row to row (z). Each row is shifted against the one before, so that seen along z all rays are
    /// equally spaced, across / rows from each other.
    Beam(int columns, int rows, double across, double along, double top);

    /// Where each ray ends: on the mesh that it meets first, on a side that its material draws. Rays that meet none have no
    /// end. The meshes must live until the next strike.
    void strike(const std::vector<THREE::Mesh*>& meshes);

    /// How many rays end on this mesh, one of those that were given to strike().
    int hits(const THREE::Mesh& mesh) const;
    /// The rays that end there, from their start to their end, world space.
    std::vector<Segment> raysTo(const THREE::Mesh& mesh) const;
    /// The points where they end.
    std::vector<THREE::Vector3> pointsOn(const THREE::Mesh& mesh) const;

  private:
    struct Ray {
        THREE::Vector3 start, end;
        const THREE::Mesh* target;  // null: none was met
    };
    std::vector<Ray> rays_;
};

}  // namespace lab
