// Programs: the lessons in the slides' order, and how one goes on in the window of another. Each lesson is built twice, as a program
// and as a module with the same `main`; a window loads the modules.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window.hpp"

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lab {

class View;

/// What a program that runs in another one's window is told, and tells. It crosses from one module into another: plain data.
struct Handover {
    std::shared_ptr<Window> window;  ///< to go on in
    std::string program;  ///< to go on with when this one returns; empty: leave
    std::vector<std::string> arguments;  ///< of that one
    std::deque<Event> pending;  ///< what came after the wish to go on: for that one
    std::function<void(View& view)> guest;  ///< set: hand the View to this and return, show nothing
};

/// The names of all lessons, in the order of the slides; empty where the lab's list is gone.
std::vector<std::string> programOrder();
/// The lesson after `program` (steps = 1) or before it (-1); a program that is none of the lessons stands before the first. Throws
/// UsageError at either end.
std::string neighbour(const std::string& program, int steps);
/// The one lesson that `wanted` means: a name, a part of one, or a number. Throws UsageError that lists them.
std::string programNamed(const std::string& wanted);
/// The slides of a lesson, as its header says them: "38-39"; empty where the lab has no such source.
std::string slidesOf(const std::string& program);

/// Throws UsageError if a lesson's module is not there.
void expectProgram(const std::string& program);
/// Runs a lesson's `main` in this process. Throws UsageError if its module is not there.
int runProgram(const std::string& program, const std::vector<std::string>& arguments, Handover& handover);

}  // namespace lab

/// Set by the program that loads this one; null where it is the first.
extern "C" lab::Handover* lambertHandover;
