// --jitter SEED: the same lesson, seen and lit a little differently.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/scene.hpp"

#include <cstdint>
#include <vector>

namespace lab {

/// Small changes of the camera's place, the lights' and the meshes', all from one seed: the same seed, the same changes
/// on every machine, whatever the order in which the scene was built, and in which groups. For hidden variations in grading.
class Jitter {
  public:
    explicit Jitter(std::uint64_t seed) : seed_(seed) {}
    /// Moves camera, lights and meshes, the meshes turned as well; `target` (world space) stays what the camera looks at.
    void apply(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const THREE::Vector3& target);
    /// Puts everything back, so that an animation finds what it left.
    void undo();

  private:
    struct Place {
        THREE::Object3D* object;
        THREE::Vector3 position;
        THREE::Quaternion quaternion;
        THREE::Euler rotation;  // angles taken from the quaternion would differ in their last digits
        THREE::Matrix4 matrix;
        bool matrixAutoUpdate;
    };
    void remember(THREE::Object3D& object) {
        places_.push_back({&object, object.position, object.quaternion, object.rotation, object.matrix,
                           object.matrixAutoUpdate});
    }

    std::uint64_t seed_;
    std::vector<Place> places_;
};

}  // namespace lab
