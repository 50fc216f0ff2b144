// The keys of a lesson's window: each one says a command.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window.hpp"
#include "lighting/terms.hpp"

#include <span>
#include <string>

namespace lab {

/// A key and what it says.
struct Key {
    int code;  ///< as Event::key
    bool shift, control;
    const char* name;  ///< as it is written: "Shift+V"
    const char* command;  ///< as on stdin
    lighting::Text help;  ///< in the window's list; null: listed with another key
};

std::span<const Key> keyTable();

/// What a key says; empty if nothing.
std::string commandOf(const Event& event);
/// The key that says this command, as it is written; empty if none does.
std::string keyFor(const std::string& command);

}  // namespace lab
