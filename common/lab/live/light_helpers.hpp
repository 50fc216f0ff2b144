// Where the lights are, over the picture: three.js's DirectionalLightHelper and PointLightHelper, drawn of
// the lights as they are now.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/numbered_lights.hpp"
#include "lab/live/projection.hpp"
#include "lab/strokes.hpp"

#include <optional>
#include <vector>

namespace lab {

/// A light's sign in the world. Its size on the screen is always the same.
struct LightHelper {
    int number;  ///< as numberedLights counts
    const THREE::Light* light;  ///< never null
    THREE::Vector3 place;  ///< world space. Point light: where it is; directional: focus + helperRadius x w
    /// World space. Point light: the edges of an octahedron, three.js's wireframe sphere of 4 x 2.
    /// Directional: a square that faces the focus, and the line from its middle to the focus, along which the
    /// light shines.
    std::vector<Segment> segments;
};

/// The signs of all visible directional and point lights; ambient light is nowhere. `focus`: what the camera
/// orbits, world space; directional lights, which have no place, are shown about it. None of what is not
/// before the camera. The world matrices of scene and camera must be up to date. `size`: half the width of a
/// sign, in picture heights.
std::vector<LightHelper> lightHelpers(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                                      const THREE::Vector3& focus, double size = 0.025);

/// The sphere about the focus on which directional lights are shown: a third of the picture wide, at most 0.7
/// of the way to the eye, world units; 0 where the focus is not before the camera.
double helperRadius(const THREE::PerspectiveCamera& camera, const THREE::Vector3& focus);

/// What of them is drawn, and what can be grabbed.
struct LightMarks {
    std::vector<PanelStroke> strokes;
    std::vector<PanelHandle> handles;  ///< "light 2", of lights whose place is in the picture
};

/// `chosen`: the number of the light that is drawn stronger.
LightMarks lightMarks(const std::vector<LightHelper>& helpers, const THREE::PerspectiveCamera& camera,
                      std::optional<int> chosen, Language language);

}  // namespace lab
