// The equation with one point's numbers in place of its symbols.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/equation.hpp"
#include "lab/live/probe.hpp"

namespace lab {

/// How a symbol's state looks.
Tone toneOf(SymbolState state);

/// P = ( max(0, 0.62) · 1 · (1.00, 0.53, 0.33) ⊗ (1, 1, 1) + ... ) + (..) ⊗ (..) = (0.71, 0.40, 0.25):
/// written out for each light where up to three are on, else for the brightest two. `symbols` is
/// lab::equation of the same switches: a number has the tone of its symbol and, as command, "term NAME
/// toggle". Of an unlit surface and the background only P = colour is left; per vertex it is the mean of the
/// corners. Off, a factor is its neutral element.
std::vector<PanelSymbol> equationWithNumbers(const ProbeReport& report, const std::vector<Symbol>& symbols,
                                             Language language);

/// All of it in one line.
std::string equationText(const std::vector<PanelSymbol>& symbols);

}  // namespace lab
