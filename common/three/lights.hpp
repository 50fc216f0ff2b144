// Lights: directional, point and ambient (slides 29-31, 36-37, 40-43).
// SPDX-License-Identifier: MIT
#pragma once

#include "three/color.hpp"
#include "three/object3d.hpp"

namespace THREE {

/// What all lights share; L of the slides is color x intensity. https://threejs.org/docs/#api/en/lights/Light
class Light : public Object3D {
  public:
    explicit Light(const Color& c = Color(0xFFFFFF), double i = 1) : color(c), intensity(i) {}
    Color color;  ///< L's colour, per channel >= 0 (slide 26)
    double intensity;  ///< L's strength, >= 0
    bool looksAlongNegativeZ() const override { return true; }
    /// color x intensity: the slides' (L_R, L_G, L_B).
    Color radiance() const { return Color(color).multiplyScalar(intensity); }
};

/// Light from everywhere alike: adds D (x) L_A to every lit surface (slides 40-43).
/// https://threejs.org/docs/#api/en/lights/AmbientLight
class AmbientLight : public Light {
  public:
    using Light::Light;
    const char* type() const override { return "AmbientLight"; }
    bool looksAlongNegativeZ() const override { return false; }
};

/// Light from one direction all over the scene, as the sun's (slides 29-30, 36.3-36.4).
/// https://threejs.org/docs/#api/en/lights/DirectionalLight
class DirectionalLight : public Light {
  public:
    explicit DirectionalLight(const Color& c = Color(0xFFFFFF), double i = 1) : Light(c, i) {
        position.set(0, 1, 0);
    }
    /// With the target at the origin, `position` is the direction towards the light and only its direction counts
    /// (slide 36.4: "viene normalizzato"). A target somewhere else need not be in the scene.
    Object3D target;
    const char* type() const override { return "DirectionalLight"; }
    /// Unit vector towards the light, world space: w of slide 24. Zero where position and target coincide.
    Vector3 directionTowardsLight() const;
};

/// Light from a point: its direction differs from point to point (slides 29-31, 37).
/// https://threejs.org/docs/#api/en/lights/PointLight
class PointLight : public Light {
  public:
    explicit PointLight(const Color& c = Color(0xFFFFFF), double i = 1, double reach = 0, double k = 0)
        : Light(c, i), distance(reach), decay(k) {}
    double
        distance;  ///< world units at which three.js's window pow2(saturate(1 - pow4(d/distance))) reaches 0; 0: no window
    double
        decay;  ///< the exponent k of f(d) = 1 / d^k (slide 31), >= 0; 0, the default: no attenuation, as slide 37's picture
    const char* type() const override { return "PointLight"; }
};

}  // namespace THREE
