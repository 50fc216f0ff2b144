// Materials: how a surface answers to light (slides 9-14, 36).
// SPDX-License-Identifier: MIT
#pragma once

#include "three/color.hpp"
#include "three/resource.hpp"

namespace THREE {

/// Which sides of a triangle are drawn; the numbers are three.js's. On the back of a BackSide or DoubleSide
/// surface the normal is turned round.
enum Side { FrontSide = 0, BackSide = 1, DoubleSide = 2 };

/// What all materials share. https://threejs.org/docs/#api/en/materials/Material
class Material : public Resource {
  public:
    Color color{
        0xFFFFFF};  ///< base colour: D of slide 27 for a lit material, the pixel itself for an unlit one; >= 0
    Side side = FrontSide;  ///< front faces only, by default
    bool visible = true;  ///< false: meshes of this material are not drawn
    bool flatShading =
        false;  ///< one normal per triangle instead of interpolated ones (no effect where nothing is lit)

    /// three.js's class name, as in its JSON.
    virtual const char* type() const = 0;
    /// Whether lights reach it.
    virtual bool isLit() const = 0;
    /// Light that it gives off by itself: added after all addends (slide 9's "emette luce propria"); 0 for unlit ones.
    virtual Color emitted() const { return Color(0, 0, 0); }
};

/// Flat colour, no lighting. https://threejs.org/docs/#api/en/materials/MeshBasicMaterial
class MeshBasicMaterial : public Material {
  public:
    MeshBasicMaterial() = default;
    explicit MeshBasicMaterial(const Color& c) { color = c; }
    const char* type() const override { return "MeshBasicMaterial"; }
    bool isLit() const override { return false; }
};

/// The Lambertian material: the same share of light in every direction (slides 13-14, 36.1).
/// https://threejs.org/docs/#api/en/materials/MeshLambertMaterial
class MeshLambertMaterial : public Material {
  public:
    MeshLambertMaterial() = default;
    explicit MeshLambertMaterial(const Color& c) { color = c; }
    Color emissive{0x000000};  ///< light of its own, independent of every lamp; >= 0
    double emissiveIntensity = 1;  ///< factor of emissive; >= 0
    const char* type() const override { return "MeshLambertMaterial"; }
    bool isLit() const override { return true; }
    Color emitted() const override { return Color(emissive).multiplyScalar(emissiveIntensity); }
};

}  // namespace THREE
