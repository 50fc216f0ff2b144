// Unit tests of validate(): each number that is refused, by the names of its object and its field.
// SPDX-License-Identifier: MIT
#include "three/lights.hpp"
#include "three/validate.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace {

using THREE::Vector3;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
const double unusable[] = {nan, infinite, -infinite, 2e36, -2e36};

// A scene in which everything is good; each test spoils one number.
struct Validate : testing::Test {
    THREE::BufferGeometry triangle;
    THREE::MeshLambertMaterial orange{THREE::Color(1, 0.5, 0.25)};
    THREE::Mesh mesh{triangle, orange};
    THREE::Group group;
    THREE::AmbientLight ambient;
    THREE::PointLight lamp;
    THREE::DirectionalLight sun;
    THREE::Scene scene;
    THREE::PerspectiveCamera camera;

    Validate() {
        triangle.setAttribute("position", {0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
        triangle.setAttribute("normal", {0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
        triangle.setIndex({0, 1, 2});
        mesh.name = "nodo";
        lamp.name = "luce2";
        sun.name = "miaLuce";
        camera.name = "occhio";
        group.add(mesh);
        scene.add(group, ambient, lamp, sun);
        camera.position.set(0, 0, 5);
    }

    // The refusal's text, or "" where nothing is refused.
    std::string refusal() {
        scene.updateMatrixWorld();
        camera.updateMatrixWorld();
        try {
            THREE::validate(scene, camera);
        } catch (const THREE::SceneError& error) {
            return error.what();
        }
        return "";
    }

    // Each value must be refused with a text that begins "who: field must be" and ends with the value.
    template <class Field>
    void expectRefused(const std::string& who, const std::string& field, Field& number,
                       const std::vector<double>& values) {
        const double good = number;
        for (const double bad : values) {
            SCOPED_TRACE(testing::Message() << field << " = " << bad);
            number = bad;
            const std::string text = refusal();
            EXPECT_EQ(text.rfind(who + ": " + field + " must be ", 0), 0u) << text;
            EXPECT_NE(text.find(", found "), std::string::npos) << text;
        }
        number = good;
        EXPECT_EQ(refusal(), "");
    }

    void expectRefusal(const std::string& who, const std::vector<std::string>& parts) {
        const std::string text = refusal();
        EXPECT_EQ(text.rfind(who + ": ", 0), 0u) << text;
        for (const std::string& part : parts)
            EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is missing in: " << text;
    }
};

std::vector<double> withUnusable(std::vector<double> values) {
    values.insert(values.end(), std::begin(unusable), std::end(unusable));
    return values;
}

TEST_F(Validate, AGoodScenePasses) {
    EXPECT_EQ(refusal(), "");
    scene.background = THREE::Color(0x123456);
    EXPECT_EQ(refusal(), "");
    const THREE::Scene empty;
    EXPECT_NO_THROW(THREE::validate(empty, camera));
}

TEST_F(Validate, TheMessageSaysWhatWasExpectedAndFound) {
    lamp.intensity = -0.5;
    EXPECT_EQ(refusal(), "PointLight 'luce2': intensity must be 0 or more, found -0.5");
    lamp.intensity = nan;
    EXPECT_EQ(refusal(), "PointLight 'luce2': intensity must be a number of at most 1e36, found nan");
}

TEST_F(Validate, ObjectsWithoutNameAreCalledByTheirPlace) {
    EXPECT_EQ(THREE::describe(scene), "Scene");
    EXPECT_EQ(THREE::describe(mesh), "Mesh 'nodo'");
    mesh.name.clear();
    EXPECT_EQ(THREE::describe(mesh), "Mesh (no name, child 0 of Group (no name, child 0 of Scene))");
    scene.name = "miaScena";
    EXPECT_EQ(THREE::describe(ambient), "AmbientLight (no name, child 1 of Scene 'miaScena')");
}

TEST_F(Validate, PlaceOfAnyObject) {
    const std::string who = "Mesh 'nodo'";
    for (Vector3* vector : {&mesh.position, &mesh.scale, &mesh.up}) {
        const std::string field = vector == &mesh.position ? "position"
                                  : vector == &mesh.scale  ? "scale"
                                                           : "up";
        expectRefused(who, field + ".x", vector->x, withUnusable({}));
        expectRefused(who, field + ".y", vector->y, withUnusable({}));
        expectRefused(who, field + ".z", vector->z, withUnusable({}));
    }
    expectRefused("PerspectiveCamera 'occhio'", "position.y", camera.position.y, withUnusable({}));
    expectRefused("Group (no name, child 0 of Scene)", "scale.z", group.scale.z, withUnusable({}));
}

TEST_F(Validate, RotationAndQuaternionEachByItsOwnName) {
    const std::string who = "Mesh 'nodo'";
    expectRefused(who, "rotation.x", mesh.rotation.x, withUnusable({}));
    expectRefused(who, "rotation.y", mesh.rotation.y, withUnusable({}));
    expectRefused(who, "rotation.z", mesh.rotation.z, withUnusable({}));
    expectRefused(who, "quaternion.x", mesh.quaternion.x, withUnusable({}));
    expectRefused(who, "quaternion.y", mesh.quaternion.y, withUnusable({}));
    expectRefused(who, "quaternion.z", mesh.quaternion.z, withUnusable({}));
    expectRefused(who, "quaternion.w", mesh.quaternion.w, withUnusable({}));
}

TEST_F(Validate, UpOfLengthZeroIsRefusedAndAVeryShortOneIsNot) {
    camera.up.set(0, 0, 0);
    expectRefusal("PerspectiveCamera 'occhio'", {"up", "zero", "(0, 0, 0)"});
    camera.up.set(0, 1e-200, 0);
    EXPECT_EQ(refusal(), "");
    mesh.up.set(0, 0, 0);
    expectRefusal("Mesh 'nodo'", {"up", "zero"});
}

// Each number is small enough by itself, but not what they make together. Row M14 ends here as well.
TEST_F(Validate, MatrixWorldIsRefusedWhereItsPartsMultiplyTooFar) {
    group.scale.setScalar(1e20);
    mesh.scale.setScalar(1e20);
    expectRefusal("Mesh 'nodo'", {"matrixWorld", "at most 1e36", "1e+40"});
    group.scale.setScalar(1);
    mesh.scale.setScalar(1);
    mesh.matrixAutoUpdate = false;
    mesh.matrix.elements[1][2] = nan;
    expectRefusal("Mesh 'nodo'", {"matrixWorld", "found nan"});
}

TEST_F(Validate, Lights) {
    expectRefused("PointLight 'luce2'", "intensity", lamp.intensity, withUnusable({-1, -1e-300}));
    expectRefused("PointLight 'luce2'", "decay", lamp.decay, withUnusable({-1}));
    expectRefused("PointLight 'luce2'", "distance", lamp.distance, withUnusable({-1}));
    expectRefused("PointLight 'luce2'", "color.r", lamp.color.r, withUnusable({-0.5}));
    expectRefused("DirectionalLight 'miaLuce'", "color.g", sun.color.g, withUnusable({-0.5}));
    expectRefused("DirectionalLight 'miaLuce'", "intensity", sun.intensity, withUnusable({-1}));
    expectRefused("AmbientLight (no name, child 1 of Scene)", "color.b", ambient.color.b,
                  withUnusable({-0.5}));
    expectRefused("AmbientLight (no name, child 1 of Scene)", "intensity", ambient.intensity,
                  withUnusable({-1}));
    lamp.intensity = 1e20;
    lamp.color.set(0, 1e20, 0);
    expectRefusal("PointLight 'luce2'", {"color x intensity", "1e+40"});
}

TEST_F(Validate, DirectionalLightWithoutDirection) {
    sun.position.set(0, 0, 0);
    expectRefusal("DirectionalLight 'miaLuce'", {"position", "target", "coincide"});
    sun.position.set(0, 1e-200, 0);
    EXPECT_EQ(refusal(), "");
    sun.target.position.set(0, 1e-200, 0);
    expectRefusal("DirectionalLight 'miaLuce'", {"position", "target", "coincide"});
    sun.position.set(1, 0, 0);
    expectRefused("DirectionalLight 'miaLuce'", "target.position.z", sun.target.position.z, withUnusable({}));
}

// The target is in the graph, but where nothing is checked because nothing is drawn.
TEST_F(Validate, ATargetBelowAnInvisibleBadObjectIsRefusedWithItsLight) {
    THREE::Group hidden;
    hidden.visible = false;
    hidden.add(sun.target);
    scene.add(hidden);
    EXPECT_EQ(refusal(), "");
    for (const double bad : unusable) {
        hidden.position.x = bad;
        expectRefusal("DirectionalLight 'miaLuce'", {"target.matrixWorld", "found "});
    }
}

TEST_F(Validate, Materials) {
    expectRefused("Mesh 'nodo'", "material.color.r", orange.color.r, withUnusable({-0.5}));
    expectRefused("Mesh 'nodo'", "material.color.b", orange.color.b, withUnusable({-0.5}));
    orange.emissive.set(1, 1, 1);
    expectRefused("Mesh 'nodo'", "material.emissive.g", orange.emissive.g, withUnusable({-0.5}));
    orange.color.set(2, 2, 2);  // more light than came in: physically wrong, but an equation all the same
    EXPECT_EQ(refusal(), "");
}

TEST_F(Validate, Background) {
    scene.background = THREE::Color(0.1, 0.2, 0.3);
    expectRefused("Scene", "background.g", scene.background->g, withUnusable({-0.5}));
}

TEST_F(Validate, Camera) {
    const std::string who = "PerspectiveCamera 'occhio'";
    expectRefused(who, "fov", camera.fov, withUnusable({0, -10, 180, 270}));
    expectRefused(who, "aspect", camera.aspect, withUnusable({0, -1}));
    expectRefused(who, "near", camera.near, withUnusable({0, -1, camera.far, 2 * camera.far}));
    expectRefused(who, "far", camera.far, withUnusable({0, -1}));
    expectRefused(who, "zoom", camera.zoom, withUnusable({0, -1}));
    camera.near = 10;
    camera.far = 10;
    expectRefusal(who, {"near must be less than far", "10"});
}

TEST_F(Validate, CameraWhoseProjectionIsNoNumberForAFloat) {
    const std::string who = "PerspectiveCamera 'occhio'";
    camera.aspect = 1e-40;
    expectRefusal(who, {"aspect", "projection"});
    camera.aspect = 1;
    camera.fov = 1e-300;
    expectRefusal(who, {"fov", "projection"});
    camera.fov = 50;
    camera.near = 1e35;
    camera.far = 1.0000001e35;
    expectRefusal(who, {"near", "far", "projection"});
}

// Row C5's neighbours: a camera that has no view because its own or its parents' scale took it away.
TEST_F(Validate, CameraWithoutAView) {
    const std::string who = "PerspectiveCamera 'occhio'";
    camera.scale.set(1, 0, 1);
    expectRefusal(who, {"scale", "0"});
    for (const double tiny : {1e-40, 1e-103, 1e-110, 1e-300}) {
        camera.scale.setScalar(tiny);
        expectRefusal(who, {"scale"});
    }
    camera.scale.setScalar(1e-20);
    EXPECT_EQ(refusal(), "");
}

TEST_F(Validate, WhatIsInvisibleIsNotRefused) {
    mesh.visible = false;
    mesh.position.x = nan;
    EXPECT_EQ(refusal(), "");
    mesh.visible = true;
    group.visible = false;
    EXPECT_EQ(refusal(), "");
    group.visible = true;
    EXPECT_NE(refusal(), "");
}

// Naming an object looks for it among its siblings: a still scene must never do that. Counted: names asked for.
class CountedMesh : public THREE::Mesh {
  public:
    CountedMesh(THREE::BufferGeometry& g, THREE::Material& m, int& count) : Mesh(g, m), count_(count) {}
    const char* type() const override {
        ++count_;
        return "Mesh";
    }

  private:
    int& count_;
};

TEST_F(Validate, TenThousandUnnamedMeshesAreNotNamed) {
    int count = 0;
    for (int i = 0; i < 10'000; ++i)
        scene.add(std::make_unique<CountedMesh>(triangle, orange, count));
    EXPECT_EQ(refusal(), "");
    EXPECT_EQ(count, 0);
    scene.children().back()->position.x = nan;
    EXPECT_EQ(refusal().rfind("Mesh (no name, child 10003 of Scene): position.x must be ", 0), 0u);
    EXPECT_EQ(count, 1);
}

TEST_F(Validate, AMeshTooFarForFloatsBesideSoNearAPlane) {
    expectRefused("Mesh 'nodo'", "distance from the camera and size together", mesh.position.z,
                  {-1e30, 1e35});
    expectRefused("Mesh 'nodo'", "distance from the camera and size together", mesh.scale.x, {1e30});
    mesh.position.z = -1e30;
    camera.near = 1.5;
    EXPECT_EQ(refusal(), "");
}

}  // namespace
