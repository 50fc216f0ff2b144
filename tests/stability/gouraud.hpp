// What lighting a mesh at its vertices costs: rows G15 and G16.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/rows.hpp"

namespace stability {

/// A frame lit per vertex. Codes are 1/255.
struct PerVertex {
    double fromFragments = 0;  ///< the most that the driver's differs from its frame lit per fragment, codes
    double twin = 0;  ///< the same of strict IEEE's, between vertices by the reference's weights, codes
    double units = 0;  ///< strict IEEE's error against the reference, which interpolates as well, in u S
    double gl = 0;  ///< the driver's error against it, transforms and all, codes
    double spaces = 0;  ///< between world and view space, codes
};
/// Draws a scene whose only mesh, a matt one, covers the picture.
PerVertex perVertex(THREE::Scene& scene, THREE::PerspectiveCamera& camera,
                    const support::DrawOptions& options, Outcome& outcome);
/// At most 16 u S in strict IEEE, and on the driver 4 times what was measured on Mesa 22.3.6 llvmpipe.
void requireAsReference(const PerVertex& found, Outcome& outcome);

/// G15: the terminator of a sphere of 64 segments, where max(0, n . w) has its kink inside triangles: at most 7.8 codes from
/// what fragments show.
void terminator(Outcome& outcome);

}  // namespace stability
