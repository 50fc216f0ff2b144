// App: shows a lesson's scene in a window or as a frame, as its command line asks.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/controls.hpp"
#include "lab/options.hpp"
#include "lab/phases.hpp"
#include "three/scene.hpp"

#include <functional>
#include <string>

namespace lab {

/// Moves things as a function of the time in seconds, and of nothing else: `--time` gives the same picture each time.
using Animation = std::function<void(double seconds)>;

class View;

/// Makes the View that these options ask for, hands it to `use`, and leaves scene and camera as they were.
using WithView = std::function<void(const Options& options, const std::function<void(View&)>& use)>;

/// A lesson's program around its scene. What it hides: command line, window or headless frame, keys, panel, messages.
class App {
  public:
    /// Reads the command line. Wrong usage, --help, --version and --list-terms end the program here.
    App(int argc, char** argv, const std::string& lesson);

    /// A number that is moved by hand, in the window or by `--set name=value`; the animation reads it. It stays where it
    /// is as long as the App lives. Throws std::invalid_argument unless the name is new and min <= start <= max.
    const double& slider(const std::string& name, double start, double min, double max,
                         lighting::Text label) {
        return controls_.add(name, start, min, max, label);
    }
    /// For the animation: a number of this frame, for the panel and, with --frame, for stdout.
    void show(lighting::Text label, double value) { controls_.readings.push_back({label, value}); }

    /// Shows the scene until the window is closed, or writes the frames that the command line asks for. Returns the
    /// program's exit status: 0 done, 2 wrong usage, 3 no way to render, 4 unusable scene, 5 cannot write; each but 0
    /// with a message on stderr. The camera's aspect follows the picture's size.
    int run(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const Animation& animation = {});
    /// The same for the scene file that the command line names (scene_viewer). Its first camera is used; without one
    /// the whole scene is brought into view.
    int runFile();

  private:
    int present(const WithView& withView);

    Phases phases_;
    Options options_;
    Controls controls_;
};

}  // namespace lab
