// A scene of the error benchmark, with everything that it owns.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"
#include "three/three.hpp"

#include <memory>
#include <vector>

namespace bench::error {

/// Scene, camera and what the camera looks at. The background is black, the camera's picture is square.
class World {
  public:
    THREE::Scene scene;
    THREE::PerspectiveCamera camera{36, 1, 0.1, 100};
    lighting::Settings settings;  ///< only its focus is set

    /// Puts a Lambertian mesh into `into`, which must hang in the scene.
    THREE::Mesh& mesh(std::shared_ptr<THREE::BufferGeometry> geometry, const THREE::Color& albedo,
                      THREE::Object3D& into);
    THREE::Mesh& mesh(std::shared_ptr<THREE::BufferGeometry> geometry, const THREE::Color& albedo) {
        return mesh(std::move(geometry), albedo, scene);
    }
    /// Adds a light of any kind to the scene; it is the World's from then on.
    template <class T>
    T& light(std::unique_ptr<T> light) {
        T& added = scene.add(std::move(light));
        lights_.push_back(&added);
        return added;
    }
    THREE::PointLight& bulb(const THREE::Vector3& position, const THREE::Color& color, double intensity,
                            double k);
    THREE::DirectionalLight& sun(const THREE::Vector3& towards, const THREE::Color& color, double intensity);
    THREE::AmbientLight& ambient(const THREE::Color& color);

    /// Places the camera and makes `target` the focus. Last of all: updates all matrices, and validates.
    void look(const THREE::Vector3& eye, const THREE::Vector3& target);
    /// Every mesh in its own colour, whatever falls on it: the flat-colour frame.
    void makeUnlit();

    const std::vector<THREE::Light*>& lights() const { return lights_; }
    const std::vector<THREE::Mesh*>& meshes() const { return meshes_; }

  private:
    std::vector<THREE::Light*> lights_;
    std::vector<THREE::Mesh*> meshes_;
};

}  // namespace bench::error
