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
    /// Back to where it all began.
    void reset();

    const THREE::Vector3& target() const { return target_; }
    /// From the camera to the target, world units, > 0.
    double distance() const;

  private:
    void place(const THREE::Vector3& offset);

    THREE::PerspectiveCamera& camera_;
    THREE::Vector3 target_;
    THREE::Vector3 startPosition_;
    THREE::Quaternion startQuaternion_;
    THREE::Vector3 startTarget_;
};

}  // namespace lab
