// Deterministic small changes, from a counter-based hash instead of a library's distributions.
// SPDX-License-Identifier: MIT
#include "lab/jitter.hpp"

#include "three/lights.hpp"

#include <algorithm>

namespace lab {

namespace {

// Numbers in [-1, 1) from a seed, the same on every machine (a 64-bit mixing function over a counter).
class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL) {}
    double next() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t x = state_;
        for (const int shift : {31, 29, 33})
            x = (x ^ (x >> shift)) * 0xD6E8FEB86659FD93ULL;
        x ^= x >> 32;
        return static_cast<double>(x >> 11) * 0x1p-52 - 1;
    }
    THREE::Vector3 vector(double size) {
        const double x = next(), y = next(), z = next();
        return {x * size, y * size, z * size};
    }

  private:
    std::uint64_t state_;
};

constexpr double cameraShare = 0.08;  // of its distance from the target
constexpr double lightShare = 0.08;  // of its distance from its parent's origin
constexpr double meshShare = 0.05;  // of its size
constexpr double meshTurn = 0.12;  // radians

}  // namespace

void Jitter::apply(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const THREE::Vector3& target) {
    Numbers numbers(seed_);
    remember(camera);
    const double distance = THREE::Vector3(camera.position).sub(target).length();
    camera.position.add(numbers.vector(cameraShare * distance));
    camera.lookAt(target);
    scene.traverse([&](THREE::Object3D& object) {
        const bool light = dynamic_cast<THREE::Light*>(&object) != nullptr;
        const auto* mesh = dynamic_cast<THREE::Mesh*>(&object);
        if ((!light && mesh == nullptr) || !object.matrixAutoUpdate)
            return;
        remember(object);
        if (light) {
            object.position.add(numbers.vector(lightShare * object.position.length()));
            return;
        }
        const double radius = mesh->geometry ? std::max(mesh->geometry->boundingSphere().radius, 0.0) : 0;
        object.position.add(numbers.vector(meshShare * std::min(radius, distance)));
        THREE::Quaternion turn;
        turn.setFromAxisAngle(numbers.vector(1), meshTurn * numbers.next());
        object.quaternion = THREE::Quaternion(glm::dquat(turn) * glm::dquat(object.quaternion));
    });
}

void Jitter::undo() {
    for (const Place& place : places_) {
        place.object->position = place.position;
        place.object->quaternion = place.quaternion;
        place.object->rotation.setSilently(place.rotation);
    }
    places_.clear();
}

}  // namespace lab
