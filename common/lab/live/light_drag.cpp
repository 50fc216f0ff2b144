// Rays through the mouse against a plane and a sphere.
// SPDX-License-Identifier: MIT
#include "lab/live/light_drag.hpp"

#include "lab/live/light_helpers.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace lab {

using THREE::Vector3;

namespace {

bool usable(const glm::dvec3& v) {
    const auto good = [](double x) { return std::abs(x) <= THREE::largestNumber; };  // not NaN, either
    return good(v.x) && good(v.y) && good(v.z);
}

glm::dmat4 toParent(const THREE::Object3D& object) {
    return object.parent() == nullptr ? THREE::Matrix4()
                                      : THREE::Matrix4(object.parent()->matrixWorld).invert();
}

}  // namespace

LightDrag::LightDrag(THREE::Light& light, const THREE::PerspectiveCamera& camera, const Vector3& focus)
    : light_(light), camera_(camera), focus_(focus) {
    if (const auto* const sun = dynamic_cast<const THREE::DirectionalLight*>(&light)) {
        const glm::dvec3 w = sun->directionTowardsLight();
        const glm::dvec3 place = glm::dvec3(focus) + w * helperRadius(camera, focus);
        behind_ = glm::dot(Projection(camera).eye() - place, w) < 0;
    }
}

bool LightDrag::to(const PanelPoint& at) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !light_.matrixAutoUpdate)
        return false;
    if (const auto* const sun = dynamic_cast<const THREE::DirectionalLight*>(&light_))
        return turnDirection(*sun, at);
    return dynamic_cast<const THREE::PointLight*>(&light_) != nullptr && movePoint(at);
}

bool LightDrag::put(const glm::dvec3& position) {
    if (!usable(position))
        return false;
    const Vector3 before = light_.position;
    light_.position = position;
    light_.updateWorldMatrix();
    if (usable(light_.matrixWorld.position()))
        return true;
    light_.position = before;
    light_.updateWorldMatrix();
    return false;
}

bool LightDrag::movePoint(const PanelPoint& at) {
    const Projection projection(camera_);
    const double depth = -projection.view(light_.matrixWorld.position()).z;
    const glm::dmat4 inverse = toParent(light_);
    if (!(depth >= camera_.near) || inverse == glm::dmat4(0.0))
        return false;
    return put(inverse * glm::dvec4(projection.world(projection.ray(at) * depth), 1));
}

bool LightDrag::turnDirection(const THREE::DirectionalLight& sun, const PanelPoint& at) {
    const Projection projection(camera_);
    const double radius = helperRadius(camera_, focus_);
    const glm::dmat4 inverse = toParent(light_);
    const glm::dvec3 eye = projection.eye(), toFocus = glm::dvec3(focus_) - eye;
    const glm::dvec3 far = projection.world(projection.ray(at)) - eye;
    const double squared = glm::dot(toFocus, toFocus), length = glm::length(far);
    if (!(radius > 0) || inverse == glm::dmat4(0.0) || !(length > 0) || !std::isfinite(length))
        return false;
    const glm::dvec3 ray = far / length;
    const double along = glm::dot(ray, toFocus);
    const glm::dvec3 aside = toFocus - ray * along;  // from the ray's nearest point to the focus
    const double inside = radius * radius - glm::dot(aside, aside);
    glm::dvec3 w;
    if (inside > 0 && along > 0) {
        behind_ = behind_ != beyond_;
        beyond_ = false;
        w = (ray * (behind_ ? std::sqrt(inside) : -std::sqrt(inside)) - aside) / radius;
    } else {
        // The rim is where rays from the eye touch: rays at this angle from the focus, here in the mouse's
        // direction.
        beyond_ = true;
        const glm::dvec3 off = ray - toFocus * (along / squared);
        const double size = glm::length(off), sine = radius / std::sqrt(squared);
        if (!(size > 0))
            return false;
        w = off / size * std::sqrt(1 - sine * sine) - toFocus * (sine / std::sqrt(squared));
    }
    // position = start + t step is where, seen from the target, the light is in direction w.
    const glm::dvec3 aim =
        sun.target.parent() != nullptr ? sun.target.matrixWorld.position() : sun.target.position;
    const glm::dvec3 start = inverse * glm::dvec4(aim, 1), step = inverse * glm::dvec4(w, 0);
    const double a = glm::dot(step, step), b = glm::dot(start, step);
    const double kept = light_.position.lengthSq();
    const double root = b * b - a * (glm::dot(start, start) - kept);
    double t = root >= 0 ? (-b + std::sqrt(root)) / a : 0;
    if (!(t > 0) || !std::isfinite(t))
        t = glm::length(glm::dvec3(light_.matrixWorld.position()) - aim);
    return t > 0 && put(start + step * t);
}

bool dragLight(THREE::Light& light, const THREE::PerspectiveCamera& camera, const Vector3& focus,
               const PanelPoint& at) {
    return LightDrag(light, camera, focus).to(at);
}

}  // namespace lab
