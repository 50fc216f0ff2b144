// What is drawn over the picture at the probed point: n, the directions towards the lights, R, v, and the
// angle between them.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/probe.hpp"
#include "lab/live/projection.hpp"

namespace lab {

/// Strokes and words over the picture.
struct Overlay {
    std::vector<PanelStroke> strokes;
    std::vector<PanelTag> tags;
};

/// How the arrows at a point are wanted.
struct OverlayOptions {
    std::optional<int>
        chosen;  ///< number of the light that is drawn stronger, with its angle; none: the brightest
    bool reflected = false;  ///< R and v also where nothing shines
    std::size_t lights = 8;  ///< as many lights at most get an arrow: the brightest and the chosen one
    double length = 0.18;  ///< of an arrow across the view, in picture heights, whatever the distance
};

/// The arrows at a point. n; towards each light w, faint where it comes from behind the surface or is off;
/// for lights before the surface R; v, which always points at the eye, so that it is seen as a ring. Tags
/// "n", "ω₂", "R₂", "v" and the angle between n and w in degrees beside an arc. All faint where the point is
/// hidden. Empty for the background and points that are not before the camera; of an unlit surface only n.
Overlay pointOverlay(const ProbeReport& report, const THREE::PerspectiveCamera& camera,
                     const OverlayOptions& options = {});

/// The light that is meant: `chosen` if it reaches the point, else the brightest there; null without lights.
const ProbeLight* chosenLight(const ProbeReport& report, std::optional<int> chosen);

/// R = 2 (n . w) n - w, the mirror of w about n.
glm::dvec3 mirrored(const glm::dvec3& n, const glm::dvec3& w);

/// The angle between two unit vectors, degrees: 0 to 180, precise also where they are nearly alike.
double degreesBetween(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace lab
