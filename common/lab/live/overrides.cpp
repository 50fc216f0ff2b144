// Puts values on objects and takes them off again.
// SPDX-License-Identifier: MIT
#include "lab/live/overrides.hpp"

#include <set>

namespace lab {

void Overrides::forgetWhatIsGone(THREE::Scene& scene) {
    std::set<const void*> there;
    scene.traverse([&there](THREE::Object3D& object) {
        if (const auto* light = dynamic_cast<const THREE::Light*>(&object))
            there.insert(light);
        if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object))
            there.insert(mesh->material.get());
    });
    const auto gone = [&there](const auto& row) { return !there.contains(row.first); };
    std::erase_if(lights, gone);
    std::erase_if(materials, gone);
}

void Overrides::apply(THREE::Scene& scene) {
    undo();
    if (lights.empty() && materials.empty())
        return;
    forgetWhatIsGone(scene);
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
