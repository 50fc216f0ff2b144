// Where a directional light comes from.
// SPDX-License-Identifier: MIT
#include "three/lights.hpp"

namespace THREE {

Vector3 DirectionalLight::directionTowardsLight() const {
    // A target outside the scene graph is never updated by it, so its own position is its place in the world.
    const Vector3 aim = target.parent() != nullptr ? target.matrixWorld.position() : target.position;
    return matrixWorld.position().sub(aim).normalize();
}

}  // namespace THREE
