// Readings beside the picture: table, diagrams, legend; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window/panel_text.hpp"

namespace lab {

/// Lines with several spans in columns, from ImGui's cursor on; where `width` is too small, smaller or
/// without columns.
void drawTable(const Look& look, const std::vector<Line>& lines, float width);

/// Diagrams beside each other, on further lines where `width` is too small.
void drawCurves(const Look& look, const std::vector<PanelCurve>& curves, float width);

void drawLegend(const Look& look, const PanelLegend& legend, float width);

}  // namespace lab
