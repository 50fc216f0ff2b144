// The error of the shading alone: the driver's pixel against the equation in long double at the driver's own interpolated
// position and normal.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/equation.hpp"
#include "support/draw.hpp"

#include <optional>
#include <vector>

namespace support {

/// The points of a frame that are lit, as the driver has them in float, and the lights that fall on them.
struct ShadingPoints {
    using Real = long double;
    lighting::reference::Equation<Real> equation;  ///< lights as the floats that the GPU has, about the eye
    std::vector<std::optional<lighting::reference::Lit<Real>>>
        points;  ///< of each pixel, top row first; none where nothing lit is seen
    double bound = 0;  ///< what design.md 7 promises for these lights without highlights, in units of u S
};

/// Reads the interpolated positions, normals and materials of a plan from the driver. Meshes must be lit and not emissive,
/// lights without `distance`.
ShadingPoints shadingPoints(const lighting::FramePlan& plan, const lighting::Settings& settings, int width,
                            int height);

/// What the equation says of a point, and S = D (x) (sum f L + L_A) + K_S (x) sum f L, as if every cosine and power were 1.
struct Shade {
    lighting::reference::Vec3<long double> P, S;
};
Shade shade(const lighting::reference::Equation<long double>& equation,
            const lighting::reference::Lit<long double>& at);

/// What came out over all pixels of all lit meshes.
struct ShadingError {
    /// Largest |error| in units of u S (Shade::S).
    double worst = 0;
    double bound = 0;  ///< what design.md 7 promises for this scene without highlights, in the same units
    int x = 0, y = 0;  ///< where the worst is
    long long pixels = 0;  ///< how many were judged
};

/// Draws the scene, and its interpolated positions, normals and materials, in float. Lights count as the floats that the
/// GPU has; what interpolation and transforms do is not in this error. Meshes must be lit and not emissive, lights without
/// `distance`; the background must be black.
ShadingError shadingError(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options);

/// S of a highlight in light of direction w: K_S for Phong's, (K_S + grazing) (s + 2)/8 for three.js's, whose Fresnel factor
/// is K_S (1 - grazing) + grazing. The eye is at the origin.
lighting::reference::Vec3<long double> highlightStrength(const lighting::reference::Lit<long double>& at,
                                                         const lighting::reference::Vec3<long double>& w);

}  // namespace support
