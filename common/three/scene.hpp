// Scene, Mesh and PerspectiveCamera: what is drawn, and from where.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"
#include "three/color.hpp"
#include "three/materials.hpp"
#include "three/object3d.hpp"

#include <optional>

namespace THREE {

/// The root of everything that is drawn or gives light. https://threejs.org/docs/#api/en/scenes/Scene
class Scene : public Object3D {
  public:
    std::optional<Color> background;  ///< colour of pixels that nothing covers; none: black
    const char* type() const override { return "Scene"; }
};

/// A geometry with a material, at a place (slide 36.1). https://threejs.org/docs/#api/en/objects/Mesh
class Mesh : public Object3D {
  public:
    /// With three.js's default material: white, unlit.
    explicit Mesh(BufferGeometry& g)
        : Mesh(Handle<BufferGeometry>(g), std::make_shared<MeshBasicMaterial>()) {}
    /// Geometry and material stay the caller's; destroying one while the mesh is in a scene is noticed by validate().
    Mesh(BufferGeometry& g, Material& m) : geometry(g), material(m) {}
    /// For loaders: shared ones live as long as a mesh uses them.
    Mesh(Handle<BufferGeometry> g, Handle<Material> m) : geometry(std::move(g)), material(std::move(m)) {}

    Handle<BufferGeometry> geometry;  ///< shape, object space
    Handle<Material> material;  ///< surface
    const char* type() const override { return "Mesh"; }
};

/// A pinhole camera that looks along its own -z. https://threejs.org/docs/#api/en/cameras/PerspectiveCamera
class PerspectiveCamera : public Object3D {
  public:
    explicit PerspectiveCamera(double verticalFov = 50, double widthOverHeight = 1, double nearPlane = 0.1,
                               double farPlane = 2000)
        : fov(verticalFov), aspect(widthOverHeight), near(nearPlane), far(farPlane) {}
    double fov;  ///< vertical angle of view in degrees, in (0, 180)
    double aspect;  ///< width over height, > 0
    double near;  ///< nearest depth that is drawn, > 0
    double far;  ///< farthest depth, > near
    double zoom = 1;  ///< factor of magnification, > 0
    const char* type() const override { return "PerspectiveCamera"; }
    bool looksAlongNegativeZ() const override { return true; }
    /// View space to clip space (z from -w to w), from the fields above; needs no updateProjectionMatrix().
    Matrix4 projectionMatrix() const;
    /// World space to view space, from matrixWorld.
    Matrix4 matrixWorldInverse() const;
    /// Kept so that three.js code reads on: the projection is always formed from the fields.
    void updateProjectionMatrix() {}
};

}  // namespace THREE
