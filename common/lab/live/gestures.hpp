// Gestures: what the mouse does to the camera and to lights' handles, from press to release and after.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/commands.hpp"
#include "lab/live/light_drag.hpp"
#include "lab/window.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace lab {

/// OrbitControls' gestures, and the dragging of lights. Each gesture is one step of undo.
class Gestures {
  public:
    Gestures(Session& session, Commands& commands) : session_(session), commands_(commands) {}

    /// Event::Kind::drag, pan, wheel.
    void moveCamera(const Event& event);
    /// Event::Kind::release. A camera that was moving goes on.
    void release();
    /// Event::Kind::handle: the command that moves the light there; empty if it cannot.
    std::string moveLight(const Event& event);
    /// Moves the camera on by itself, for so many seconds. False once it stands still.
    bool coast(double seconds);
    bool coasting() const { return coasting_; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Fling {
        double dx, dy;  // heights of the window a second
        bool pans;
    };

    Session& session_;
    Commands& commands_;
    std::optional<Fling> fling_;
    std::optional<LightDrag> drag_;  // of a light's handle, while it is held
    const THREE::Light* dragged_ = nullptr;
    Clock::time_point last_ = Clock::now();
    bool coasting_ = false;
};

}  // namespace lab
