// The two ways in which `check` stays with a student: in a terminal, and in a window.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/grading/grader.hpp"
#include "lab/window.hpp"

namespace grader {

/// What the command line says.
struct CheckRequest {
    GraderOptions grading;
    std::filesystem::path file;  ///< absolute
    std::string picture;  ///< where to write; empty: nowhere, in a window on F2 to check.png
    bool once = false;
    lab::PanelStyle style;
};

enum CheckStatusCode { AllRight = 0, NotYet = 1, CheckUsage = 2, CheckCannot = 75 };

/// Says the verdict and writes the picture, and does it again whenever something was saved, until a signal (SIGINT, SIGTERM) ends
/// it; or once. Returns the exit status: of the one verdict, or AllRight.
int checkInTerminal(const CheckRequest& request);

/// The same in a window, until it is closed.
int checkInWindow(const CheckRequest& request, lab::Window& window);

}  // namespace grader
