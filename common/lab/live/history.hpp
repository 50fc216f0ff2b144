// Undo and redo: states of the controls, as they were.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/control.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lab {

/// The states before the present one, and those that were undone.
class History {
  public:
    /// To be told after each change; what did not change is no step. `gesture` is empty, or names a movement of many small steps, such
    /// as a drag: those that follow each other are one.
    void changed(const State& before, const State& after, const std::string& gesture);
    /// The movement is over: the next one of the same name is another step.
    void endGesture() { gesture_.clear(); }
    /// The state to go back to, or none; `now` is kept for redo.
    std::optional<State> undo(const State& now);
    /// The state that the last undo took away, or none.
    std::optional<State> redo(const State& now);

  private:
    std::vector<State> past_, future_;
    std::string gesture_;
};

}  // namespace lab
