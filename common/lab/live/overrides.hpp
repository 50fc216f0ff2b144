// Overrides: values of lights and materials that were given by hand, in place of the scene's own.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/lights.hpp"
#include "three/materials.hpp"
#include "three/scene.hpp"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace lab {

/// What was given to a light; what was not is its own.
struct LightOverride {
    std::optional<bool> on;
    std::optional<THREE::Color> color;
    std::optional<double> intensity;
    std::optional<THREE::Vector3> position;  ///< in its parent's space
    std::optional<double> decay;  ///< point lights: k
};

/// What was given to a material.
struct MaterialOverride {
    std::optional<THREE::Color> color;
    std::optional<THREE::Color> specular;  ///< MeshPhongMaterial: K_S
    std::optional<double> shininess;  ///< MeshPhongMaterial: s
};

/// Put on the scene after its animation has moved it, and taken off before the animation moves it again: so an animation need
/// not know of them, and each can be taken back. What an animation has taken out of the scene is forgotten.
class Overrides {
  public:
    std::map<THREE::Light*, LightOverride> lights;
    std::map<THREE::Material*, MaterialOverride> materials;

    void apply(THREE::Scene& scene);
    void undo();

  private:
    void forgetWhatIsGone(THREE::Scene& scene);
    template <class T>
    void put(T& place, const std::optional<T>& value) {
        if (!value)
            return;
        undo_.push_back([&place, before = place] { place = before; });
        place = *value;
    }
    std::vector<std::function<void()>> undo_;  // in the order in which they were put on
};

}  // namespace lab
