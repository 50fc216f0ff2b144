// State files: what was moved, as JSON, so that a picture can be made again.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/control.hpp"
#include "lab/options.hpp"

#include <string>

namespace lab {

/// What a state file says.
struct SavedState {
    std::string program;  ///< whose state it is
    std::string sceneFile;  ///< scene_viewer's, as it was given; else empty
    int width = 0, height = 0;  ///< of the picture, pixels
    State controls;
};

/// The text of a state file; in one line where `oneLine`.
std::string stateText(const SavedState& state, bool oneLine);
/// Reads a state file of `program`. Throws UsageError that names file, field, what was expected and found.
SavedState readState(const std::string& file, const std::string& program);

/// Where --state is given and --size is not: the picture is as large as the saved one. Throws as readState does.
void takeStateSize(Options& options);

/// `base` + `extension`, or with the first number that is free for all of the extensions: no file is ever written over.
std::string freeName(const std::string& base, const std::vector<std::string>& extensions);

}  // namespace lab
