// What the probe found, in words: a table for the panel, and one line for stdout.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/probe.hpp"
#include "lab/options.hpp"

namespace lab {

/// For Panel::probe. First lines of one span: where the point is and what is special about it; then rows of a name and a value, and
/// for a lit point a table with a column for each light (w, n . w, after the clamp, f(d), d, L, the diffuse addend); then the other
/// addends, the sum, the sum clamped, its code, and the driver's. Factors that are off say so. At most `lights` lights have a column:
/// the brightest, in the order of the scene.
std::vector<Line> probeLines(const ProbeReport& report, Language language, std::size_t lights = 3);

/// The same, complete, in one line: "probe " and fields "name = value" with "; " between them. Names are the
/// same in every language, numbers have six significant digits, vectors are "(x, y, z)" in world space. What
/// is off has " (off)" or " (spento)" behind its value. Names of the scene have neither ';' nor line breaks
/// in it.
std::string probeText(const ProbeReport& report, Language language);

/// What is special about the point: hidden, unlit, flat, per vertex, without a normal ... A sentence each;
/// may be empty.
std::vector<std::string> probeRemarks(const ProbeReport& report, Language language);

/// The numbers, at most `count`, of the lights that add most to the point, in the order of the scene; those
/// that are off do not count.
std::vector<int> brightestLights(const ProbeReport& report, std::size_t count);

}  // namespace lab
