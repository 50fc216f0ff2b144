// The camera on a sphere about a point, never over the poles.
// SPDX-License-Identifier: MIT
#include "lab/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

using THREE::Vector3;

Orbit::Orbit(THREE::PerspectiveCamera& camera, const Vector3& target) : camera_(camera), target_(target) {}

double Orbit::distance() const { return std::max(Vector3(camera_.position).sub(target_).length(), 1e-30); }

void Orbit::place(const Vector3& position, const Vector3& target) {
    stop();
    camera_.position = position;
    target_ = target;
    camera_.lookAt(target_);
}

void Orbit::placeAt(const Vector3& offset) {
    camera_.position = Vector3(target_).add(offset);
    camera_.lookAt(target_);
}

void Orbit::rotate(double dx, double dy) {
    // In a frame whose pole is the camera's `up`; for (0, 1, 0) the axes are x, y and z themselves.
    const Vector3 pole = Vector3(camera_.up).normalize();
    const Vector3 side =
        Vector3(pole).cross(std::abs(pole.z) < 0.9 ? Vector3(0, 0, 1) : Vector3(1, 0, 0)).normalize();
    const Vector3 front = Vector3(side).cross(pole);
    const Vector3 offset = Vector3(camera_.position).sub(target_);
    const double radius = distance();
    const double azimuth = std::atan2(offset.dot(side), offset.dot(front)) - dx * 2 * std::numbers::pi;
    const double polar = std::acos(std::clamp(offset.dot(pole) / radius, -1.0, 1.0)) - dy * std::numbers::pi;
    const double kept = std::clamp(polar, 1e-4, std::numbers::pi - 1e-4);
    placeAt(Vector3(side)
                .multiplyScalar(radius * std::sin(kept) * std::sin(azimuth))
                .add(Vector3(pole).multiplyScalar(radius * std::cos(kept)))
                .add(Vector3(front).multiplyScalar(radius * std::sin(kept) * std::cos(azimuth))));
}

void Orbit::zoom(double steps) {
    const double factor = std::pow(0.95, std::clamp(steps, -100.0, 100.0));
    // Neither into the target nor beyond what is drawn.
    const double now = distance();
    const double nearest = std::min(now, camera_.near * 1.01);
    const double farthest = std::max(now, camera_.far * 0.5);
    placeAt(Vector3(camera_.position)
                .sub(target_)
                .multiplyScalar(std::clamp(now * factor, nearest, farthest) / now));
}

void Orbit::pan(double dx, double dy) {
    camera_.updateWorldMatrix();
    const glm::dvec3 right = Vector3(glm::dvec3(camera_.matrixWorld.elements[0])).normalize();
    const glm::dvec3 above = Vector3(glm::dvec3(camera_.matrixWorld.elements[1])).normalize();
    const double height = 2 * distance() * std::tan(camera_.fov * std::numbers::pi / 360) / camera_.zoom;
    const Vector3 shift = right * (-dx * height) + above * (dy * height);
    camera_.position.add(shift);
    target_.add(shift);
    camera_.lookAt(target_);  // the same to the last bits as for a camera that is put there
}

bool Orbit::coast(double seconds) {
    constexpr double perSecond = 6, slowest = 0.01;  // the share of speed that is lost; heights a second
    if (std::hypot(speed_.x, speed_.y) < slowest)
        stop();
    if (speed_.x == 0 && speed_.y == 0)
        return false;
    const double t = std::clamp(seconds, 0.0, 0.1);
    if (speed_.pans)
        pan(speed_.x * t, speed_.y * t);
    else
        rotate(speed_.x * t, speed_.y * t);
    const double kept = std::exp(-perSecond * t);
    speed_.x *= kept;
    speed_.y *= kept;
    return true;
}

}  // namespace lab
