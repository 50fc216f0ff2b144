// Materials: how a surface answers to light (slides 9-14, 36, 44-45).
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

/// How a shiny material makes its highlight: by the reflected vector R of slide 45, or by the half vector, as three.js does.
enum class SpecularModel { phong, blinn };

/// The Lambertian sum plus a highlight (slides 44-45). Each light with n . w > 0 adds, with v the direction towards the eye,
///   phong:  K_S (x) L f max(0, R . v)^s           R = 2 (n . w) n - w, the mirror of w about n
///   blinn:  F (x) L f (n . w) (s + 2)/8 (n . h)^s   three.js r146's own: h halfway between w and v, F Schlick's Fresnel of K_S
/// https://threejs.org/docs/#api/en/materials/MeshPhongMaterial
class MeshPhongMaterial : public MeshLambertMaterial {
  public:
    using MeshLambertMaterial::MeshLambertMaterial;
    Color specular{0x111111};  ///< K_S: the colour of the highlight, per channel >= 0
    double shininess = 30;  ///< s: the larger, the smaller the highlight; >= 0
    SpecularModel specularModel =
        SpecularModel::phong;  ///< materials of three.js's JSON files are loaded with blinn
    const char* type() const override { return "MeshPhongMaterial"; }
};

}  // namespace THREE
