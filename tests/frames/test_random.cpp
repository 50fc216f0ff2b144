// Properties of random scenes: drawn by bit pattern over all that is accepted, and over what lessons are like. A failing one
// prints the seed that makes it again (RC_PARAMS, RapidCheck's documentation) and shrinks the scene.
// SPDX-License-Identifier: MIT
#include "lighting/reference/reference.hpp"
#include "support/judge.hpp"
#include "support/shading.hpp"
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <mutex>
#include <rapidcheck/gtest.h>

namespace {

using lighting::reference::Reference;
using support::DrawOptions;
using THREE::Vector3;

// Any double from -1e36 to 1e36 by its bits: the exponent evenly over the range of floats, now and then over that of doubles;
// zeros, the ends of the range and denormal floats more often than chance would have it.
rc::Gen<double> number() {
    const auto byBits = [](int low, int high) {
        return rc::gen::map(rc::gen::tuple(rc::gen::inRange(low, high), rc::gen::arbitrary<std::uint64_t>()),
                            [](const auto& parts) {
                                const auto exponent = static_cast<std::uint64_t>(std::get<0>(parts) + 1023)
                                                      << 52;
                                const std::uint64_t mantissa = std::get<1>(parts) & 0x800F'FFFF'FFFF'FFFFULL;
                                return std::bit_cast<double>(exponent | mantissa);
                            });
    };
    return rc::gen::weightedOneOf<double>(
        {{4, byBits(-149, 119)},
         {8, byBits(-20, 20)},
         {1, byBits(-1022, 119)},
         {2, rc::gen::element(0.0, -0.0, 1.0, -1.0, 1e36, -1e36, 1e-45, 5e-324)}});
}
rc::Gen<double> positive() {
    return rc::gen::map(number(), [](double x) { return x == 0 ? 1 : std::abs(x); });
}
rc::Gen<double> notNegative() {
    return rc::gen::map(number(), [](double x) { return std::abs(x); });
}
// Numbers as lessons have them.
rc::Gen<double> ordinary(double low, double high) {
    return rc::gen::map(rc::gen::inRange(0, 1 << 20),
                        [low, high](int i) { return low + (high - low) * i / (1 << 20); });
}

Vector3 vectorOf(const rc::Gen<double>& g) { return {*g, *g, *g}; }
THREE::Color colorOf(const rc::Gen<double>& g) { return {*g, *g, *g}; }

// A scene whose every number comes from a generator.
struct RandomScene {
    THREE::Scene scene;
    THREE::BoxGeometry box{1, 1, 1};
    THREE::TorusKnotGeometry knot{1, 0.4, 24, 8};
    THREE::BufferGeometry triangles;
    THREE::PerspectiveCamera camera;
    std::vector<std::unique_ptr<THREE::MeshPhongMaterial>> materials;
    std::vector<std::unique_ptr<THREE::Mesh>> meshes;
    std::vector<std::unique_ptr<THREE::Light>> lights;
    DrawOptions options;

    template <class LightType>
    LightType& light(const THREE::Color& color, double intensity) {
        lights.push_back(std::make_unique<LightType>(color, intensity));
        scene.add(*lights.back());
        return static_cast<LightType&>(*lights.back());
    }

    THREE::Mesh& mesh(THREE::BufferGeometry& geometry, const THREE::Color& color) {
        materials.push_back(std::make_unique<THREE::MeshPhongMaterial>(color));
        materials.back()->specular.set(0x000000);
        meshes.push_back(std::make_unique<THREE::Mesh>(geometry, *materials.back()));
        scene.add(*meshes.back());
        return *meshes.back();
    }
};

// A highlight for the last mesh, half of the time.
void makeShiny(RandomScene& s, const rc::Gen<double>& color, const rc::Gen<double>& shininess) {
    THREE::MeshPhongMaterial& material = *s.materials.back();
    material.specular = *rc::gen::arbitrary<bool>() ? colorOf(color) : THREE::Color(0, 0, 0);
    material.shininess = *shininess;
    material.specularModel = *rc::gen::element(THREE::SpecularModel::phong, THREE::SpecularModel::blinn);
}

lighting::Switches anySwitches() {
    lighting::Switches switches;
    switches.shading =
        *rc::gen::element(lighting::Shading::pixel, lighting::Shading::vertex, lighting::Shading::flat);
    switches.space = *rc::gen::element(lighting::Space::world, lighting::Space::view);
    switches.normals =
        *rc::gen::element(lighting::NormalTransform::inverseTranspose, lighting::NormalTransform::model);
    return switches;
}

// Over the whole range that is accepted.
void makeWild(RandomScene& s) {
    const rc::Gen<double> any = number(), strong = notNegative();
    std::vector<double> positions, normals;
    for (int i = *rc::gen::inRange(1, 5) * 9; i > 0; --i) {
        positions.push_back(*any);
        normals.push_back(*any);
    }
    s.triangles.setAttribute("position", positions, 3).setAttribute("normal", normals, 3);
    THREE::BufferGeometry* const geometries[] = {&s.box, &s.knot, &s.triangles};
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
        THREE::Mesh& mesh = s.mesh(*geometries[*rc::gen::inRange(0, 3)], colorOf(strong));
        mesh.position = vectorOf(any);
        mesh.scale = *rc::gen::arbitrary<bool>() ? vectorOf(any) : Vector3(1, 1, 1);
        mesh.rotation.set(*ordinary(-4, 4), *ordinary(-4, 4), *ordinary(-4, 4));
        s.materials.back()->side = *rc::gen::element(THREE::FrontSide, THREE::BackSide, THREE::DoubleSide);
        s.materials.back()->flatShading = *rc::gen::arbitrary<bool>();
        s.materials.back()->emissive = *rc::gen::arbitrary<bool>() ? colorOf(strong) : THREE::Color(0, 0, 0);
        makeShiny(s, strong, strong);
    }
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
        auto& light = s.light<THREE::PointLight>(colorOf(strong), *strong);
        light.position = vectorOf(any);
        light.decay = *rc::gen::oneOf(rc::gen::element(0.0, 1.0, 2.0), notNegative());
        light.distance = *rc::gen::oneOf(rc::gen::just(0.0), notNegative());
    }
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
        s.light<THREE::DirectionalLight>(colorOf(strong), *strong).position = vectorOf(any);
    if (*rc::gen::arbitrary<bool>())
        s.light<THREE::AmbientLight>(colorOf(strong), *strong);
    s.camera.fov = *ordinary(1, 179);
    s.camera.near = *positive();
    s.camera.far = *positive();
    s.camera.position = vectorOf(any);
    if (*rc::gen::inRange(0, 4) > 0) {  // else most scenes reach too far for so near a plane
        double reach = s.camera.position.length();
        for (const auto& mesh : s.meshes)
            reach = std::max(reach, mesh->position.length() +
                                        2 * mesh->geometry->boundingSphere().radius * mesh->scale.length());
        s.camera.near = std::max(s.camera.near, std::min(1e-29 * reach, 1e30));
        s.camera.far = std::max(s.camera.far, 2 * s.camera.near);
    }
    static_cast<lighting::Switches&>(s.options.settings) = anySwitches();
    const Vector3 target = *rc::gen::arbitrary<bool>() ? s.meshes[0]->position : vectorOf(any);
    support::lookAt(s.camera, target, s.options);
    if (!(s.options.settings.focusDistance > 0))
        s.options.settings.focusDistance = 1;
}

// As lessons and submissions are: sizes from millimetres to miles, lights that one can see.
void makeOrdinary(RandomScene& s, bool windows) {
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
        THREE::Mesh& mesh =
            s.mesh(*rc::gen::arbitrary<bool>() ? static_cast<THREE::BufferGeometry&>(s.box) : s.knot,
                   colorOf(ordinary(0, 1.5)));
        mesh.position = vectorOf(ordinary(-2, 2));
        mesh.scale.set(*ordinary(0.2, 2) * *rc::gen::element(-1, 1), *ordinary(0.2, 2), *ordinary(0.2, 2));
        mesh.rotation.set(*ordinary(-4, 4), *ordinary(-4, 4), *ordinary(-4, 4));
    }
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
        auto& light = s.light<THREE::PointLight>(colorOf(ordinary(0, 1)), *ordinary(0, 4));
        light.position = vectorOf(ordinary(-5, 5));
        light.decay = *rc::gen::element(0.0, 1.0, 2.0, 0.5, 1.7);
        light.distance = windows ? *rc::gen::element(0.0, 4.0, 9.0) : 0;
    }
    s.light<THREE::DirectionalLight>(colorOf(ordinary(0, 1)), 1).position =
        Vector3(*ordinary(-1, 1), 1, *ordinary(-1, 1));
    s.light<THREE::AmbientLight>(colorOf(ordinary(0, 0.3)), 1);
    s.camera.position = Vector3(*ordinary(-4, 4), *ordinary(-4, 4), *ordinary(4, 8));
    support::lookAt(s.camera, vectorOf(ordinary(-0.5, 0.5)), s.options);
    s.options.settings.terms =
        *rc::gen::arbitrary<bool>()
            ? lighting::TermSet::all()
            : lighting::TermSet::all().without(static_cast<lighting::Term>(*rc::gen::inRange(0, 9)));
}

// Up to date and valid, or refused by a message that says something.
bool accepted(RandomScene& s, int width, int height) {
    s.options.width = width;
    s.options.height = height;
    s.camera.aspect = static_cast<double>(width) / height;
    s.scene.updateMatrixWorld();
    s.camera.updateWorldMatrix();
    try {
        THREE::validate(s.scene, s.camera);
    } catch (const THREE::SceneError& refused) {
        RC_ASSERT(std::string(refused.what()).find(": ") != std::string::npos);
        return false;
    }
    return true;
}

RC_GTEST_PROP(Random, WhateverIsAcceptedIsDrawnWithFiniteNumbers, ()) {
    RandomScene s;
    makeWild(s);
    const bool valid = accepted(s, 13, 11);
    RC_CLASSIFY(valid, "accepted");
    if (!valid)
        return;
    RC_LOG() << THREE::toJSON(s.scene, &s.camera);  // for scene_viewer
    lighting::Settings settings = s.options.settings;
    settings.countNonfinite = true;
    const image::Frame frame = support::renderer().render(s.scene, s.camera, settings, {13, 11, true});
    RC_ASSERT(support::renderer().stats().nonfinite == 0);
    for (const float value : std::get<image::Floats>(frame.pixels))
        RC_ASSERT(std::isfinite(value));
    std::vector<double> truth;
    Reference<double>(s.scene, s.camera, settings, 13, 11).draw([&](int, int, const glm::dvec3& P) {
        static std::mutex mutex;
        const std::lock_guard<std::mutex> lock(mutex);
        truth.push_back(P.x + P.y + P.z);
    });
    for (const double value : truth)
        RC_ASSERT(std::isfinite(value));
}

RC_GTEST_PROP(Random, TheShadingKeepsItsBound, ()) {
    RandomScene s;
    makeOrdinary(s, false);
    RC_PRE(accepted(s, 40, 40));
    const support::ShadingError e = support::shadingError(s.scene, s.camera, s.options);
    RC_ASSERT(e.worst <= e.bound);
}

RC_GTEST_PROP(Random, NoCodeIsOffByMoreThanOne, ()) {
    RandomScene s;
    makeOrdinary(s, true);
    makeShiny(s, ordinary(0, 1), ordinary(0, 100));
    const lighting::TermSet terms = s.options.settings.terms;
    static_cast<lighting::Switches&>(s.options.settings) = anySwitches();
    s.options.settings.terms = terms;
    RC_PRE(accepted(s, 48, 36));
    const support::Judgement j = support::judge(s.scene, s.camera, s.options);
    RC_LOG() << support::describe(j);
    RC_ASSERT(j.codes <= 1);
    RC_ASSERT(j.worst < 1e-3);  // relative to S; beside near silhouettes some 1e-4
}

// Doubling every light doubles every number, to the last bit.
RC_GTEST_PROP(Random, TwiceTheLightTwiceThePixel, ()) {
    RandomScene s;
    makeOrdinary(s, true);
    RC_PRE(accepted(s, 24, 24));
    const auto draw = [&s] {
        const image::Frame frame =
            support::renderer().render(s.scene, s.camera, s.options.settings, {24, 24, true});
        return std::get<image::Floats>(frame.pixels);
    };
    const image::Floats once = draw();
    for (const auto& light : s.lights)
        light->intensity *= 2;
    const image::Floats twice = draw();
    for (std::size_t i = 0; i < once.size(); ++i)
        RC_ASSERT(twice[i] == 2 * once[i]);
}

}  // namespace
