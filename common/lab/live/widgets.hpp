// From the table of controls to widgets.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/panel_builder.hpp"

#include <vector>

namespace lab {

/// The controls of a session and the buttons beside them, in groups.
std::vector<WidgetGroup> widgetGroups(Session& session, const PanelFacts& facts);

}  // namespace lab
