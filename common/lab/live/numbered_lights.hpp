// The lights of a scene by their numbers: how commands, handles and the probe call them.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/options.hpp"
#include "three/lights.hpp"
#include "three/scene.hpp"

#include <string>
#include <vector>

namespace lab {

/// A light and whether it reaches the picture.
struct NumberedLight {
    /// From 1, in the order of the scene; ambient and invisible lights have one too, so that numbers stay.
    int number;
    const THREE::Light* light;  ///< never null
    bool visible;  ///< it and all that it hangs on
};

/// All lights of a scene. Valid until lights are added or removed.
std::vector<NumberedLight> numberedLights(const THREE::Scene& scene);

/// "light 2", with its name if it has one: "light 2 'lamp'".
std::string lightTitle(int number, const std::string& name, Language language);

/// A number as small digits below the line: "₁₂".
std::string subscript(int number);

}  // namespace lab
