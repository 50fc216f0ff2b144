// Deterministic small changes, from a counter-based hash instead of a library's distributions.
// SPDX-License-Identifier: MIT
#include "lab/jitter.hpp"

#include "three/lights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

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

// A smooth field over the directions, three numbers in [-1, 1] at each: what it does to an object depends on where the object
// is, not on when it was added. So the same scene built in another order, or a direction of another length, is changed alike.
class Field {
  public:
    explicit Field(Numbers& numbers) {
        for (Wave& wave : waves_) {
            wave.along = numbers.vector(2);
            wave.phase = 3.141592653589793 * numbers.next();
        }
    }
    /// Only the direction of `place` counts.
    THREE::Vector3 at(const THREE::Vector3& place, double size) const {
        const double length = place.length();
        const THREE::Vector3 direction =
            length > 0 ? THREE::Vector3(place).multiplyScalar(1 / length) : THREE::Vector3();
        const auto value = [&](const Wave& wave) {
            return size * std::sin(wave.phase + wave.along.dot(direction));
        };
        return {value(waves_[0]), value(waves_[1]), value(waves_[2])};
    }

  private:
    struct Wave {
        THREE::Vector3 along;
        double phase;
    };
    std::array<Wave, 3> waves_;
};

constexpr double cameraShare = 0.08;  // of its distance from the target
constexpr double lightShare = 0.08;  // of its distance from its parent's origin
constexpr double meshShare = 0.05;  // of its size
constexpr double meshTurn = 0.12;  // radians

struct Moved {
    THREE::Object3D* object;
    glm::dmat4 world;  // before anything is moved
    THREE::Vector3 place;  // in the world; of a directional light, from its target
};

// Lights and meshes, parents first.
std::vector<Moved> movedOf(THREE::Scene& scene) {
    std::vector<Moved> all;
    scene.updateMatrixWorld();
    scene.traverse([&](THREE::Object3D& object) {
        if (dynamic_cast<THREE::Light*>(&object) == nullptr && dynamic_cast<THREE::Mesh*>(&object) == nullptr)
            return;
        THREE::Vector3 place = object.matrixWorld.position();
        if (auto* sun = dynamic_cast<THREE::DirectionalLight*>(&object))
            place.sub(sun->target.getWorldPosition());
        all.push_back({&object, object.matrixWorld, place});
    });
    return all;
}

// Moves and turns an object in the world, whatever it hangs below and however its matrix was made.
void move(const Moved& moved, const THREE::Vector3& by, const glm::dquat& turn) {
    THREE::Object3D& object = *moved.object;
    THREE::Object3D* const parent = object.parent();
    if (parent != nullptr)
        parent->updateWorldMatrix();
    const glm::dmat4 above = parent == nullptr ? glm::dmat4(1) : parent->matrixWorld.elements;
    if (above == glm::dmat4(1) && object.matrixAutoUpdate) {
        object.position.add(by);
        object.quaternion = THREE::Quaternion(turn * glm::dquat(object.quaternion));
        return;
    }
    glm::dmat4 world = moved.world;
    world[3] = glm::dvec4(0, 0, 0, 1);
    world = glm::mat4_cast(turn) * world;
    world[3] = moved.world[3] + glm::dvec4(glm::dvec3(by), 0);
    object.matrix = THREE::Matrix4(above).invert().multiply(world);
    object.matrixAutoUpdate = false;
}

}  // namespace

void Jitter::apply(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const THREE::Vector3& target) {
    Numbers numbers(seed_);
    remember(camera);
    const double distance = THREE::Vector3(camera.position).sub(target).length();
    camera.position.add(numbers.vector(cameraShare * distance));
    camera.lookAt(target);
    const Field lights(numbers), meshes(numbers), axes(numbers);
    const double turn = meshTurn * (0.75 + 0.25 * numbers.next());
    for (const Moved& moved : movedOf(scene)) {
        remember(*moved.object);
        const THREE::Vector3& place = moved.place;
        const auto* mesh = dynamic_cast<THREE::Mesh*>(moved.object);
        if (mesh == nullptr) {
            move(moved, lights.at(place, lightShare * place.length()), glm::dquat(1, 0, 0, 0));
            continue;
        }
        const double radius = mesh->geometry ? std::max(mesh->geometry->boundingSphere().radius, 0.0) : 0;
        THREE::Quaternion turned;
        turned.setFromAxisAngle(axes.at(place, 1), turn);
        move(moved, meshes.at(place, meshShare * std::min(radius, distance)), turned);
    }
}

void Jitter::undo() {
    for (const Place& place : places_) {
        place.object->position = place.position;
        place.object->quaternion = place.quaternion;
        place.object->rotation.setSilently(place.rotation);
        place.object->matrix = place.matrix;
        place.object->matrixAutoUpdate = place.matrixAutoUpdate;
    }
    places_.clear();
}

}  // namespace lab
