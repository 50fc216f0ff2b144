// OrbitControls: the camera on a sphere about a point.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/scene.hpp"

namespace lab {

/// Turns, zooms and shifts a camera about a target, as three.js's OrbitControls do with the mouse.
/// https://threejs.org/docs/#examples/en/controls/OrbitControls
class Orbit {
  public:
    /// About `target` (world space), starting from where the camera stands and looks.
    Orbit(THREE::PerspectiveCamera& camera, const THREE::Vector3& target);

    /// A drag by a fraction of the window's height: the whole height turns by a full circle sideways, half up and down.
    void rotate(double dx, double dy);
    /// Wheel steps; each one nearer or farther by 5 %.
    void zoom(double steps);
    /// A drag by a fraction of the window's height: the target's plane follows the mouse.
    void pan(double dx, double dy);
    /// A drag was let go while it moved by so many heights of the window a second: it goes on, slower and slower, as with three.js's
    /// damping. `pans`: it shifted.
    void fling(double dx, double dy, bool pans) { speed_ = {dx, dy, pans}; }
    /// Goes on for so many seconds. False once it stands still.
    bool coast(double seconds);
    /// No motion goes on.
    void stop() { speed_ = {}; }
    /// Puts the camera somewhere, looking at another point, which it orbits from now on.
    void place(const THREE::Vector3& position, const THREE::Vector3& target);
    /// The point that it orbits, without a move of the camera.
    void setTarget(const THREE::Vector3& target) {
        stop();
        target_ = target;
    }

    const THREE::Vector3& target() const { return target_; }
    /// From the camera to the target, world units, > 0.
    double distance() const;

  private:
    struct Speed {
        double x = 0, y = 0;  // heights of the window a second
        bool pans = false;
    };
    void placeAt(const THREE::Vector3& offset);

    THREE::PerspectiveCamera& camera_;
    THREE::Vector3 target_;
    Speed speed_;
};

}  // namespace lab
