// The window's loop: events to commands, and drawing only what changed.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/programs.hpp"
#include "lab/view.hpp"

namespace lab {

/// Shows the view in the handover's window until it is closed, or until another program is to go on in it (Handover::program).
void runLive(View& view, const Options& options, Handover& handover);

}  // namespace lab
