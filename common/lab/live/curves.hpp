// Small diagrams of the functions in the equation, with the probed point on them.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/probe.hpp"
#include "lab/options.hpp"

namespace lab {

/// Of the chosen light (none: the brightest at the point): max(0, cos a) over the angle between n and w, f(d)
/// over the distance for a point light, with its window, and for a shiny surface max(0, cos)^s about R
/// (phong) or h (blinn). As they are with the present terms: off, the clamp leaves the cosine negative. Empty
/// where no light reaches the point. All places are from 0 to 1.
std::vector<PanelCurve> pointCurves(const ProbeReport& report, std::optional<int> chosen, Language language);

}  // namespace lab
