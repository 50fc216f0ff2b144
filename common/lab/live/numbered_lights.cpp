// Counts the lights of a scene.
// SPDX-License-Identifier: MIT
#include "lab/live/numbered_lights.hpp"

namespace lab {

namespace {

void count(const THREE::Object3D& object, bool visible, std::vector<NumberedLight>& lights) {
    visible = visible && object.visible;
    if (const auto* light = dynamic_cast<const THREE::Light*>(&object))
        lights.push_back({static_cast<int>(lights.size()) + 1, light, visible});
    for (const THREE::Object3D* const child : object.children())
        count(*child, visible, lights);
}

}  // namespace

std::vector<NumberedLight> numberedLights(const THREE::Scene& scene) {
    std::vector<NumberedLight> lights;
    count(scene, true, lights);
    return lights;
}

std::string lightTitle(int number, const std::string& name, Language language) {
    const std::string title = say({"luce ", "light "}, language) + std::to_string(number);
    return name.empty() ? title : title + " '" + name + "'";
}

std::string subscript(int number) {
    static const char* const digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string text;
    for (const char digit : std::to_string(number))
        text += digit >= '0' && digit <= '9' ? digits[digit - '0'] : "₋";
    return text;
}

}  // namespace lab
