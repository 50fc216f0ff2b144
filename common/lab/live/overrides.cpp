// Puts values on objects and takes them off again.
// SPDX-License-Identifier: MIT
#include "lab/live/overrides.hpp"

namespace lab {

void Overrides::apply() {
    undo();
    for (const auto& [light, given] : lights) {
        put(light->visible, given.on);
        put(light->color, given.color);
        put(light->intensity, given.intensity);
        put(light->position, given.position);
        if (auto* const point = dynamic_cast<THREE::PointLight*>(light))
            put(point->decay, given.decay);
    }
    for (const auto& [material, given] : materials) {
        put(material->color, given.color);
        if (auto* const phong = dynamic_cast<THREE::MeshPhongMaterial*>(material)) {
            put(phong->specular, given.specular);
            put(phong->shininess, given.shininess);
        }
    }
}

void Overrides::undo() {
    for (auto step = undo_.rbegin(); step != undo_.rend(); ++step)
        (*step)();
    undo_.clear();
}

}  // namespace lab
