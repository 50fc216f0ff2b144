// Rounds lights to floats.
// SPDX-License-Identifier: MIT
#include "render/light_numbers.hpp"

#include <algorithm>
#include <limits>

namespace render {

namespace {

float toFloat(double x) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -largest, largest));
}
glm::vec4 toFloats(const glm::dvec3& v, double w) {
    return {toFloat(v.x), toFloat(v.y), toFloat(v.z), toFloat(w)};
}

}  // namespace

LightNumbers numbersOf(const lighting::FramePlan& plan) {
    LightNumbers all;
    for (const lighting::DirectionalAddend& light : plan.directional) {
        all.geometry.push_back(toFloats(light.w, 0));
        all.radiance.push_back(toFloats(light.color, light.intensity));
        all.falloff.emplace_back(0);
        all.lights.push_back(light.light);
    }
    for (const lighting::PointAddend& light : plan.point) {
        all.geometry.push_back(toFloats(light.position, light.distance > 0 ? 1 / light.distance : 0));
        all.radiance.push_back(toFloats(light.color, light.intensity));
        all.falloff.push_back(toFloats({light.decay, light.exponent, 0}, 0));
        all.lights.push_back(light.light);
    }
    all.moves.assign(all.count(), false);
    all.ambient = glm::vec3(toFloats(plan.ambient, 0));
    return all;
}

LightNumbers pick(const LightNumbers& all, const lighting::FramePlan& plan, const lighting::LightSet& set) {
    LightNumbers out;
    const auto append = [&](std::size_t i) {
        out.geometry.push_back(all.geometry[i]);
        out.radiance.push_back(all.radiance[i]);
        out.falloff.push_back(all.falloff[i]);
        out.lights.push_back(all.lights[i]);
        out.moves.push_back(all.moves[i]);
    };
    for (std::size_t i = 0; i < plan.directional.size() && !set.empty; ++i)
        append(i);
    for (const std::uint32_t i : set.point)
        append(plan.directional.size() + i);
    out.ambient = all.ambient;
    out.ambientMoves = all.ambientMoves;
    return out;
}

}  // namespace render
