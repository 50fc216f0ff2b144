// From a scene and a command line to a plan.
// SPDX-License-Identifier: MIT
#include "lab/view.hpp"

#include "lab/live/values.hpp"
#include "three/lights.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lab {

using THREE::Vector3;

THREE::Sphere worldBounds(const THREE::Scene& scene) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector3 low(infinity, infinity, infinity), high(-infinity, -infinity, -infinity);
    scene.traverseVisible([&](const THREE::Object3D& object) {
        const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object);
        if (mesh == nullptr || !mesh->geometry || mesh->geometry->vertexCount() == 0)
            return;
        const THREE::Box3 box = mesh->geometry->boundingBox();
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3 p = mesh->matrixWorld.applyTo({(corner & 1) != 0 ? box.max.x : box.min.x,
                                                         (corner & 2) != 0 ? box.max.y : box.min.y,
                                                         (corner & 4) != 0 ? box.max.z : box.min.z});
            low.set(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
            high.set(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
        }
    });
    if (!(low.x <= high.x))
        return {Vector3(), 0};
    const Vector3 center = Vector3(low).multiplyScalar(0.5).add(Vector3(high).multiplyScalar(0.5));
    return {center, Vector3(high).sub(center).length()};
}

void bringIntoView(THREE::PerspectiveCamera& camera, const THREE::Scene& scene) {
    const THREE::Sphere bounds = worldBounds(scene);
    const double radius = bounds.radius > 0 ? bounds.radius : 1;
    const double top = std::tan(camera.fov * std::numbers::pi / 360);  // at depth 1; the narrower way decides
    const double distance = 1.05 * radius / std::sin(std::atan(top * std::min(1.0, camera.aspect)));
    camera.position = Vector3(0.45, 0.35, 1).normalize().multiplyScalar(distance).add(bounds.center);
    camera.near = radius / 100;
    camera.far = radius * 100;
    camera.lookAt(bounds.center);
}

namespace {

// What the camera orbits: the point on its axis that is nearest the scene's middle.
Vector3 orbitTarget(THREE::Scene& scene, THREE::PerspectiveCamera& camera,
                    const std::optional<Vector3>& knownMiddle) {
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    const Vector3 eye = camera.matrixWorld.position();
    const Vector3 forward =
        Vector3(glm::dvec3(camera.matrixWorld.elements[2])).normalize().multiplyScalar(-1);
    const Vector3 middle = knownMiddle ? *knownMiddle : worldBounds(scene).center;
    const double along = Vector3(middle).sub(eye).dot(forward);
    return Vector3(forward).multiplyScalar(std::max(along, 2 * camera.near)).add(eye);
}

}  // namespace

View::Start::Start(const THREE::PerspectiveCamera& camera)
    : position(camera.position), quaternion(camera.quaternion), rotation(camera.rotation), fov(camera.fov),
      aspect(camera.aspect) {}

void View::Start::putBack(THREE::PerspectiveCamera& camera) const {
    camera.position = position;
    camera.quaternion = quaternion;
    camera.rotation.setSilently(rotation);
    camera.fov = fov;
    camera.aspect = aspect;
}

View::View(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const Animation& animation,
           const Options& options, Controls& controls, const std::optional<Vector3>& middle)
    : decay(options.decay), lightCut(options.lightCut), scene_(scene), camera_(camera), animation_(animation),
      options_(options), controls_(controls), start_(camera), ownTarget_(orbitTarget(scene, camera, middle)),
      orbit_(camera, ownTarget_), seed_(options.jitter), jitter_(options.jitter.value_or(0)) {
    if (options.camera)
        moveTo(*options.camera);
}

View::~View() {
    putBack();
    start_.putBack(camera_);
}

void View::putBack() {
    jitter_.undo();
    overrides.undo();
    for (const auto& [light, own] : ownDecays_)
        light->decay = own;
    ownDecays_.clear();
}

void View::moveTo(const CameraOption& wanted) {
    jitter_.undo();
    camera_.fov = wanted.fov.value_or(camera_.fov);
    orbit_.place({wanted.position[0], wanted.position[1], wanted.position[2]},
                 {wanted.target[0], wanted.target[1], wanted.target[2]});
}

void View::setCamera(const std::string& text) { moveTo(readCamera(text)); }

std::string View::cameraText() {
    jitter_.undo();
    const Vector3 eye = camera_.position, target = orbit_.target();
    return numbersText({eye.x, eye.y, eye.z, target.x, target.y, target.z, camera_.fov});
}

bool View::cameraMoved() {
    jitter_.undo();
    const auto same = [](const Vector3& a, const Vector3& b) {
        return a.x == b.x && a.y == b.y && a.z == b.z;
    };
    const THREE::Quaternion &now = camera_.quaternion, &start = start_.quaternion;
    return !same(camera_.position, start_.position) || !same(orbit_.target(), ownTarget_) ||
           camera_.fov != start_.fov || now.x != start.x || now.y != start.y || now.z != start.z ||
           now.w != start.w;
}

void View::resetCamera() {
    jitter_.undo();
    start_.putBack(camera_);
    orbit_.setTarget(ownTarget_);
}

void View::setJitter(std::optional<std::uint64_t> seed) {
    jitter_.undo();
    seed_ = seed;
    jitter_ = Jitter(seed.value_or(0));
}

void View::update(double time, int width, int height) {
    putBack();
    controls_.readings.clear();
    if (animation_)
        animation_(time);
    if (decay)
        scene_.traverse([this](THREE::Object3D& object) {
            if (auto* point = dynamic_cast<THREE::PointLight*>(&object)) {
                ownDecays_.emplace_back(point, point->decay);
                point->decay = *decay;
            }
        });
    overrides.apply(scene_);
    camera_.aspect = static_cast<double>(width) / height;
    const auto check = [this] {
        scene_.updateMatrixWorld();
        camera_.updateWorldMatrix();
        THREE::validate(scene_, camera_);
    };
    check();
    if (seed_) {
        jitter_.apply(scene_, camera_, orbit_.target());
        check();
    }
}

lighting::Settings View::settings(const lighting::Switches& switches) const {
    lighting::Settings settings;
    static_cast<lighting::Switches&>(settings) = switches;
    settings.skip = options_.skip;
    settings.lightCut = lightCut;
    settings.focus = orbit_.target();
    settings.focusDistance = orbit_.distance();
    return settings;
}

lighting::FramePlan View::plan(const lighting::Switches& switches) const {
    return lighting::planFrame(scene_, camera_, settings(switches));
}

}  // namespace lab
