// The switches beside the terms: where, in which space and how the equation is evaluated. One table for options and keys.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/terms.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lab {

/// A value that a switch can have.
struct Choice {
    const char* name;  ///< on the command line
    lighting::Text meaning;
};

/// A switch with two or three values.
struct Switch {
    char key;  ///< in the window: the next value
    const char* option;  ///< on the command line: "--shading"
    lighting::Text what;
    std::span<const Choice> choices;
    /// The number of the choice, or -1: left to the materials.
    int (*get)(const lighting::Switches&);
    void (*set)(lighting::Switches&, int);

    /// The choice now, in words.
    lighting::Text now(const lighting::Switches& switches) const;
    /// Goes on to the next choice, and after the last one back to how lessons start.
    void next(lighting::Switches& switches) const;
    /// Takes the choice of that name; false if there is none.
    bool choose(std::string_view name, lighting::Switches& switches) const;
    /// "pixel|vertex|flat"
    std::string names() const;
};

/// --shading, --space, --normal-matrix, --specular.
std::span<const Switch> switchTable();

/// The switches that are not as lessons start, as options: "--shading vertex --space view"; empty if all are.
std::string switchesText(const lighting::Switches& switches);

}  // namespace lab
