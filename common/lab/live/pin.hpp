// The pinned point of the probe as text, for state files.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/probe.hpp"
#include "three/scene.hpp"

#include <optional>
#include <string>

namespace lab {

/// "mesh,triangle,weight,weight,weight", where meshes are counted from 1 in the order of the scene; "none".
std::string pinText(const std::optional<SurfacePoint>& pin, const THREE::Scene& scene);
/// Reads it. Throws UsageError for a mesh or a triangle that the scene has not.
std::optional<SurfacePoint> readPin(const std::string& text, const THREE::Scene& scene);

}  // namespace lab
