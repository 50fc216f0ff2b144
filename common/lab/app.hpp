// App: shows a lesson's scene in a window or as a frame, as its command line asks.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/options.hpp"
#include "three/scene.hpp"

#include <functional>
#include <string>

namespace lab {

/// Moves things as a function of the time in seconds, and of nothing else: `--time` gives the same picture each time.
using Animation = std::function<void(double seconds)>;

/// A lesson's program around its scene. What it hides: command line, window or headless frame, keys, panel, messages.
class App {
  public:
    /// Reads the command line. Wrong usage, --help, --version and --list-terms end the program here.
    App(int argc, char** argv, const std::string& lesson);

    /// Shows the scene until the window is closed, or writes the frame that the command line asks for. Returns the
    /// program's exit status: 0 done, 2 wrong usage, 3 no way to render, 4 unusable scene, 5 cannot write; each but 0
    /// with a message on stderr. The camera's aspect follows the picture's size.
    int run(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const Animation& animation = {});
    /// The same for the scene file that the command line names (scene_viewer). Its first camera is used; without one
    /// the whole scene is brought into view.
    int runFile();

  private:
    Options options_;
};

}  // namespace lab
