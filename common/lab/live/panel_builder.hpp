// From a session to what stands beside its picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/probe.hpp"
#include "lab/live/session.hpp"
#include "render/renderer.hpp"

#include <optional>
#include <string>

namespace lab {

/// What the panel needs to know beside the session.
struct PanelFacts {
    std::string program;  ///< its name
    std::string slides;  ///< "38-39"; may be empty
    std::string before;  ///< the lesson before this one; may be empty
    Span message;  ///< the last answer
    std::optional<ProbeReport> probe;
    render::FrameStats drawn;  ///< of the last picture
    std::optional<PanelLegend> legend;  ///< in place of the view's own
    int chosenSlider = 0;
    int width = 960;  ///< of the window, pixels
};

Panel buildPanel(Session& session, const PanelFacts& facts);

}  // namespace lab
