// Undo and redo.
// SPDX-License-Identifier: MIT
#include "lab/live/history.hpp"

#include <utility>

namespace lab {

namespace {

constexpr std::size_t mostSteps = 500;

std::optional<State> take(std::vector<State>& from, std::vector<State>& into, const State& now) {
    if (from.empty())
        return std::nullopt;
    into.push_back(now);
    State state = std::move(from.back());
    from.pop_back();
    return state;
}

}  // namespace

void History::changed(const State& before, const State& after, const std::string& gesture) {
    if (before == after)
        return;
    future_.clear();
    const bool goesOn = !gesture.empty() && gesture == gesture_;
    gesture_ = gesture;
    if (goesOn)
        return;
    past_.push_back(before);
    if (past_.size() > mostSteps)
        past_.erase(past_.begin());
}

std::optional<State> History::undo(const State& now) {
    endGesture();
    return take(past_, future_, now);
}

std::optional<State> History::redo(const State& now) {
    endGesture();
    return take(future_, past_, now);
}

}  // namespace lab
