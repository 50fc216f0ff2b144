// Controls: everything that can be moved while a lesson runs, in one table. Keys, panel, stdin, state files and tests all go
// through it, and all in the same way: a control has a name, and its value is a text.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/panel.hpp"
#include "lighting/terms.hpp"
#include "three/color.hpp"
#include "three/vector3.hpp"

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lab {

/// A value that a control can have.
struct ControlChoice {
    std::string name;  ///< in commands and state files
    lighting::Text words;
};

/// Something that can be moved.
struct Control {
    std::string name;  ///< words with blanks between them: "light 2 color"
    WidgetKind kind = WidgetKind::toggle;
    std::string group = {};  ///< whose title it stands under: "lights"; empty: on no panel
    lighting::Text help = {};  ///< what it is
    double min = 0, max = 1, step = 0.01;  ///< of numbers; step: also of vectors
    std::vector<ControlChoice> choices = {};  ///< of choices; toggles have "on" and "off"
    std::function<std::string()> get = {};  ///< the value now
    std::function<void(const std::string&)> set = {};  ///< throws UsageError that says what was expected
    std::function<bool()> moved = {};  ///< whether the value is not the program's own
    std::function<void()> reset = {};  ///< back to the program's own value
    bool saved = true;  ///< belongs to the picture, and so to state files and to undo

    /// The value after `value`: a toggle's other one, a choice's next one (from the last back to the first), a number `steps`
    /// steps up, within its range.
    std::string next(int steps = 1) const;
};

/// The values of the saved controls that are not the program's own, by name.
using State = std::map<std::string, std::string>;

/// The controls of a running lesson, in the order in which they are shown and set.
class ControlTable {
  public:
    /// A variable of the program's as a control; what it holds now is its own value.
    Control& addToggle(const std::string& name, const std::string& group, lighting::Text help, bool& value,
                       bool own);
    Control& addChoice(const std::string& name, const std::string& group, lighting::Text help,
                       std::vector<ControlChoice> choices, std::function<int()> get,
                       std::function<void(int)> set, int own);
    Control& addNumber(const std::string& name, const std::string& group, lighting::Text help, double min,
                       double max, double& value, double own);
    Control& add(Control control);
    void clear() { controls_.clear(); }

    std::deque<Control>& all() { return controls_; }
    const std::deque<Control>& all() const { return controls_; }
    /// The control of that name, or null.
    Control* find(std::string_view name);
    /// Gives a control a value, as a state file does. Throws UsageError with the control's name before what was expected and found.
    void give(const Control& control, const std::string& value);
    /// Sets a control to the text, as a command does; "toggle", "next", "previous" and "reset" are understood as well. Throws UsageError with the
    /// control's name before what was expected and found.
    void set(const Control& control, const std::string& value);

    /// What is not the program's own now.
    State state() const;
    /// Makes it so: sets what `wanted` has, resets everything else that is saved. Throws UsageError for a name that there is not,
    /// or a value that cannot be; what came before it is set then.
    void apply(const State& wanted);

  private:
    std::deque<Control> controls_;
};

}  // namespace lab
