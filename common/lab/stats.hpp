// --stats: what a frame was, cost and did without, as one line of JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/controls.hpp"
#include "lab/failure.hpp"
#include "lab/phases.hpp"
#include "lighting/frame_plan.hpp"
#include "render/renderer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lab {

/// Everything that the line says.
struct StatsReport {
    std::string frame;  ///< the file that it was written to, or empty
    std::string renderer;  ///< the driver's own name
    int width = 0;
    int height = 0;
    double firstFrameMilliseconds = 0;  ///< from the process's start to its first picture
    std::vector<double> frameMilliseconds;  ///< of each timed frame
    Controls controls;  ///< sliders and readings of the frame
    std::optional<double>
        millisecondsPerLight;  ///< what each directional or point light adds; none: not timed
    Phases phases;  ///< where this frame's time went
};

/// One line without the line's end. `frame` is of the frame that was drawn.
std::string statsJson(const StatsReport& report, const render::FrameStats& frame);

/// The same for a line of --frames-from that gave no frame: `frame` is empty if it names none.
std::string failureJson(const std::string& frame, int line, const Failure& failure);

/// A variant in words: "lit directional=1 point=k0:1 ambient terms=albedo,cosine".
std::string variantText(const lighting::Variant& variant);

/// Milliseconds since the kernel started this process, to a tick of its clock (10 ms on most machines).
double millisecondsSinceProcessStart();

}  // namespace lab
