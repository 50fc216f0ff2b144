// The equation as text: what the panel draws and what messages and pictures carry.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/options.hpp"
#include "lighting/frame_plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lab {

/// How a symbol stands in the equation now.
enum class SymbolState {
    plain,  ///< punctuation: belongs to no term
    active,  ///< on, and this scene shows it
    idle,  ///< on or off makes no difference to this scene
    off  ///< off: its neutral element stands in its place
};

/// A piece of the equation, left to right.
struct Symbol {
    std::string text;  ///< UTF-8
    SymbolState state;
    std::optional<lighting::Term> term;
};

/// The symbols of  P = ( sum max(0, n . w) f(d) D (x) L ) + D (x) L_A  with their states; where something shines, the highlight
/// is among them. `full` is the plan of the scene with all terms on: it knows which ones can matter.
std::vector<Symbol> equation(lighting::TermSet on, const lighting::FramePlan& full);

/// The equation in one line without the symbols that are off: what is left on the blackboard. `shiny`: with the highlight.
std::string equationText(lighting::TermSet on, bool shiny);

}  // namespace lab
