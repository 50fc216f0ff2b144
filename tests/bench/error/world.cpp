// Puts scenes together.
// SPDX-License-Identifier: MIT
#include "bench/error/world.hpp"

#include "three/validate.hpp"

namespace bench::error {

THREE::Mesh& World::mesh(std::shared_ptr<THREE::BufferGeometry> geometry, const THREE::Color& albedo,
                         THREE::Object3D& into) {
    const THREE::Handle<THREE::Material> material(std::make_shared<THREE::MeshLambertMaterial>(albedo));
    THREE::Mesh& added = into.add(
        std::make_unique<THREE::Mesh>(THREE::Handle<THREE::BufferGeometry>(std::move(geometry)), material));
    meshes_.push_back(&added);
    return added;
}

THREE::PointLight& World::bulb(const THREE::Vector3& position, const THREE::Color& color, double intensity,
                               double k) {
    auto light = std::make_unique<THREE::PointLight>(color, intensity, 0, k);
    light->position = position;
    return this->light(std::move(light));
}

THREE::DirectionalLight& World::sun(const THREE::Vector3& towards, const THREE::Color& color,
                                    double intensity) {
    auto light = std::make_unique<THREE::DirectionalLight>(color, intensity);
    light->position = towards;
    return this->light(std::move(light));
}

THREE::AmbientLight& World::ambient(const THREE::Color& color) {
    return light(std::make_unique<THREE::AmbientLight>(color));
}

void World::look(const THREE::Vector3& eye, const THREE::Vector3& target) {
    camera.position = eye;
    camera.lookAt(target);
    settings.focus = target;
    settings.focusDistance = THREE::Vector3(eye).sub(target).length();
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    THREE::validate(scene, camera);
}

void World::makeUnlit() {
    for (THREE::Mesh* mesh : meshes_)
        mesh->material =
            THREE::Handle<THREE::Material>(std::make_shared<THREE::MeshBasicMaterial>(mesh->material->color));
}

}  // namespace bench::error
