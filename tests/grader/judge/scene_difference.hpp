// What a student's scene lacks: two scenes compared by what can be seen of them, not by how they were built.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace grader {

/// One thing about a scene, by its name, as rubrics cite it:
///   mesh[i].present, .geometry, .place (position and rotation), .scale, .material (its kind), .color, .flat, .specular, .shininess, .side,
///     .emissive
///   directional[i].present, .direction, .color, .intensity     point[i].present, .position, .color, .intensity, .decay, .distance
///   ambient.present, .color, .intensity     mesh.extra, directional.extra, point.extra     background
/// Numbers are those of the expected scene, in its order. Lights that shine from the same place count as one, `color` is L's hue and
/// `intensity` its brightest channel, so that nobody is told apart by how a light is written.
struct Aspect {
    bool right = true;
    std::string found;  ///< the student's value, as text; never the expected one
    bool operator==(const Aspect&) const = default;
};
using Aspects = std::map<std::string, Aspect>;

/// All aspects of the expected scene, right or wrong in the other. Objects are paired by what is nearest.
Aspects compareScenes(const THREE::Scene& expected, const THREE::Scene& found);

/// Whether a name of compareScenes is meant by a rubric's pattern: * stands for any characters, ? for one, [ ] for themselves,
/// and a range [1-12] for the numbers in it.
bool matches(const std::string& pattern, const std::string& aspect);
/// Whether one of the patterns means it. `*` alone means nothing by name: it is what no other check means.
bool isMeant(const std::vector<std::string>& patterns, const std::string& aspect);

}  // namespace grader
