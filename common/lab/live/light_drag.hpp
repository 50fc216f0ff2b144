// A light that follows the mouse.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/projection.hpp"
#include "three/lights.hpp"

namespace lab {

/// From the press of the button on a light's handle to its release.
///
/// A point light moves in the plane through it that is parallel to the screen. A directional one turns so
/// that its handle, which lightHelpers puts on a sphere about the focus, is under the mouse: on the half of
/// the sphere where it was, in front or behind. Beyond the sphere's rim it slides along the rim; the mouse
/// that comes back over the rim brings it round to the other half.
class LightDrag {
  public:
    /// World matrices must be up to date, here and at each to(). Light and camera must stay until the last
    /// to().
    LightDrag(THREE::Light& light, const THREE::PerspectiveCamera& camera, const THREE::Vector3& focus);

    /// Moves the handle to a place of the picture, and the light with it: its `position`, in its parent's
    /// space; of a directional light the length of `position` stays, where its target and parent leave such a
    /// place. Updates its world matrix. False, and nothing moves: a place that is no number, a light that is
    /// not before the camera or has no place (ambient), whose matrix is set by hand or whose parent is flat,
    /// or a result that no scene may have.
    bool to(const PanelPoint& at);

  private:
    bool movePoint(const PanelPoint& at);
    bool turnDirection(const THREE::DirectionalLight& sun, const PanelPoint& at);
    bool put(const glm::dvec3& position);

    THREE::Light& light_;
    const THREE::PerspectiveCamera& camera_;
    THREE::Vector3 focus_;
    bool behind_ = false;  // on the far half of the sphere
    bool beyond_ = false;  // the mouse is off the sphere
};

/// A drag of one step: press on the handle, move to `at`, release.
bool dragLight(THREE::Light& light, const THREE::PerspectiveCamera& camera, const THREE::Vector3& focus,
               const PanelPoint& at);

}  // namespace lab
