// Unit tests of toJSON: reading back gives the same doubles, and the text is three.js's.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"
#include "three/lights.hpp"
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace {

using nlohmann::json;
using THREE::LoadedScene;

LoadedScene parse(const std::string& text) { return THREE::ObjectLoader().parse(text, "scena.json"); }

// A scene with one of everything, in numbers that no short decimal says.
struct ToJson : testing::Test {
    THREE::TorusKnotGeometry knot{1.1, 0.3, 40, 6, 2, 5};
    THREE::CylinderGeometry tube{1, 2, 3, 8, 2, true, 0.1, 4};
    THREE::SphereGeometry edited{1, 8, 6};
    THREE::BufferGeometry triangle;
    THREE::MeshLambertMaterial orange{THREE::Color(0xFF8855)};
    THREE::MeshLambertMaterial odd{THREE::Color(0.1, 1.0 / 3, 2.5)};
    THREE::MeshBasicMaterial flat{THREE::Color(0x336699)};
    THREE::Mesh knotMesh{knot, orange};
    THREE::Mesh again{knot, odd};
    THREE::Mesh tubeMesh{tube, flat};
    THREE::Mesh editedMesh{edited, orange};
    THREE::Mesh triangleMesh{triangle, flat};
    THREE::Group group;
    THREE::Object3D pivot;
    THREE::AmbientLight ambient{THREE::Color(0x101010), 0.7};
    THREE::DirectionalLight sun{THREE::Color(1.5, 0.25, 0.1), 1.25};
    THREE::PointLight lamp{THREE::Color(0xDD6666), 1.0 / 3, 12.5, 2};
    THREE::PerspectiveCamera camera{40, 1.5, 0.25, 90};
    THREE::Scene scene;

    ToJson() {
        triangle.setAttribute("position", {0, -0.0, 1e-7, 1.0 / 3, 1e20, 0, 0, 1, -1e-30}, 3);
        triangle.setIndex({0, 1, 2});
        edited.attributes.at("position").array[4] += 0.5;  // by hand, and without needsUpdate()
        orange.emissive.set(0.1, 0.2, 0.3);
        orange.emissiveIntensity = 0;
        odd.side = THREE::DoubleSide;
        odd.flatShading = true;
        odd.name = "strano \"\u00e0\"\n";
        flat.visible = false;
        knotMesh.name = "nodo";
        knotMesh.position.set(0.1, 1.0 / 3, -2);
        knotMesh.rotation.set(0.3, 7, -1);
        knotMesh.scale.set(-1, 2, 0.7);
        again.quaternion.setFromAxisAngle({1, 2, 3}, 0.7);
        again.up.set(0, 0, 1);
        tubeMesh.rotation = THREE::Euler(0.1, 0.2, 0.3, THREE::EulerOrder::ZYX);
        editedMesh.scale.set(0, 1, 1);
        editedMesh.visible = false;
        pivot.matrixAutoUpdate = false;
        pivot.matrix.elements[1][0] = 0.25;  // a shear
        group.position.set(1e8, 0, 0.1);
        lamp.position.set(2, 1.5, 5);
        sun.position.set(1, 3, -2);
        camera.position.set(0, 0.8, 5);
        camera.lookAt(0, 0.1, 0);
        camera.zoom = 1.25;
        scene.name = "prova";
        scene.background = THREE::Color(0.1, 0.2, 0.3);
        scene.add(knotMesh, group, ambient, sun, lamp);
        group.add(again, pivot);
        pivot.add(tubeMesh, editedMesh, triangleMesh);
        scene.updateMatrixWorld();
    }
};

void expectSameMaterial(const THREE::Material& a, const THREE::Material& b) {
    EXPECT_STREQ(a.type(), b.type());
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.side, b.side);
    EXPECT_EQ(a.visible, b.visible);
    EXPECT_EQ(a.flatShading, b.flatShading);
    const auto* lambert = dynamic_cast<const THREE::MeshLambertMaterial*>(&a);
    const auto* other = dynamic_cast<const THREE::MeshLambertMaterial*>(&b);
    ASSERT_EQ(lambert == nullptr, other == nullptr);
    if (lambert != nullptr) {
        EXPECT_EQ(lambert->emissive, other->emissive);
        EXPECT_EQ(lambert->emissiveIntensity, other->emissiveIntensity);
    }
}

void expectSameGeometry(const THREE::BufferGeometry& a, const THREE::BufferGeometry& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.index, b.index);
    ASSERT_EQ(a.attributes.size(), b.attributes.size());
    for (const auto& [name, attribute] : a.attributes) {
        EXPECT_EQ(attribute.array, b.attributes.at(name).array) << name;
        EXPECT_EQ(attribute.itemSize, b.attributes.at(name).itemSize) << name;
    }
}

void expectSame(const THREE::Object3D& a, const THREE::Object3D& b) {
    SCOPED_TRACE(THREE::describe(a));
    ASSERT_STREQ(a.type(), b.type());
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.visible, b.visible);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.matrixAutoUpdate, b.matrixAutoUpdate);
    EXPECT_TRUE(glm::dquat(a.quaternion) == glm::dquat(b.quaternion));
    EXPECT_EQ(a.rotation.x, b.rotation.x);
    EXPECT_EQ(a.rotation.y, b.rotation.y);
    EXPECT_EQ(a.rotation.z, b.rotation.z);
    EXPECT_EQ(a.rotation.order(), b.rotation.order());
    EXPECT_TRUE(a.matrixWorld.elements == b.matrixWorld.elements);
    if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&a)) {
        const auto& other = dynamic_cast<const THREE::Mesh&>(b);
        expectSameGeometry(*mesh->geometry, *other.geometry);
        expectSameMaterial(*mesh->material, *other.material);
    }
    if (const auto* light = dynamic_cast<const THREE::Light*>(&a)) {
        EXPECT_EQ(light->color, dynamic_cast<const THREE::Light&>(b).color);
        EXPECT_EQ(light->intensity, dynamic_cast<const THREE::Light&>(b).intensity);
    }
    ASSERT_EQ(a.children().size(), b.children().size());
    for (std::size_t i = 0; i < a.children().size(); ++i)
        expectSame(*a.children()[i], *b.children()[i]);
}

TEST_F(ToJson, readsBackAsTheSameScene) {
    scene.add(camera);
    scene.updateMatrixWorld();
    const std::string text = toJSON(scene);
    const LoadedScene loaded = parse(text);
    EXPECT_TRUE(loaded.notes.empty());
    expectSame(scene, *loaded.scene);
    EXPECT_EQ(loaded.scene->background, scene.background);
    ASSERT_NE(loaded.camera, nullptr);
    EXPECT_EQ(loaded.camera->fov, 40);
    EXPECT_EQ(loaded.camera->aspect, 1.5);
    EXPECT_EQ(loaded.camera->near, 0.25);
    EXPECT_EQ(loaded.camera->far, 90);
    EXPECT_EQ(loaded.camera->zoom, 1.25);
    const auto& read = dynamic_cast<const THREE::PointLight&>(*loaded.scene->children().at(4));
    EXPECT_EQ(read.distance, 12.5);
    EXPECT_EQ(read.decay, 2);
    EXPECT_EQ(toJSON(*loaded.scene), text) << "byte for byte";
}

TEST_F(ToJson, writesThreeJsFormat) {
    const json j = json::parse(toJSON(scene, &camera));
    EXPECT_EQ(j["metadata"], json::parse(R"({"version":4.5,"type":"Object","generator":"Object3D.toJSON"})"));
    ASSERT_EQ(j["geometries"].size(), 4U) << "a shared geometry stands once";
    ASSERT_EQ(j["materials"].size(), 3U);
    EXPECT_EQ(j["geometries"][0]["type"], "TorusKnotGeometry");
    EXPECT_EQ(j["geometries"][0]["tubularSegments"], 40);
    EXPECT_FALSE(j["geometries"][0].contains("data"));
    EXPECT_EQ(j["geometries"][1]["openEnded"], true);
    EXPECT_EQ(j["geometries"][2]["type"], "BufferGeometry") << "an edited sphere is no sphere any more";
    EXPECT_EQ(j["geometries"][3]["data"]["attributes"]["position"]["type"], "Float32Array");
    EXPECT_EQ(j["geometries"][3]["data"]["index"]["type"], "Uint16Array");
    EXPECT_EQ(j["materials"][0]["color"], 0xFF8855);
    EXPECT_FALSE(j["materials"][0].contains("lambertColor"));
    EXPECT_EQ(j["materials"][1]["color"], 0x1A55FF) << "clamped and rounded for three.js";
    EXPECT_EQ(j["materials"][1]["lambertColor"], json::parse("[0.1,0.3333333333333333,2.5]"));
    EXPECT_EQ(j["object"]["type"], "Scene");
    EXPECT_EQ(j["object"]["children"][1]["geometry"], j["geometries"][0]["uuid"]);
    EXPECT_EQ(j["object"]["children"][1]["matrix"].size(), 16U);
    EXPECT_EQ(j["object"]["children"][1]["matrix"][12], 0.1);
    EXPECT_EQ(j["object"]["children"][2]["children"][1]["matrixAutoUpdate"], false);
    const json& first = j["object"]["children"].front();
    EXPECT_EQ(first["type"], "PerspectiveCamera")
        << "a camera from outside is the one that a reader finds first";
    EXPECT_FALSE(j["object"]["children"][4].contains("target")) << "the origin needs none";
    const std::string uuid = first["uuid"];
    EXPECT_EQ(uuid.size(), 36U);
    EXPECT_EQ(uuid[14], '4');
    EXPECT_EQ(toJSON(scene, &camera), toJSON(scene, &camera));
}

TEST_F(ToJson, givesDirectionalLightsTheirTarget) {
    sun.target.position.set(0.5, 1, -3);
    const THREE::Vector3 expected = sun.directionTowardsLight();
    const std::string text = toJSON(scene, &camera);
    const json j = json::parse(text);
    EXPECT_EQ(j["object"]["children"][4]["target"], j["object"]["children"].back()["uuid"]);
    EXPECT_EQ(j["object"]["children"].back()["type"], "Object3D");
    LoadedScene loaded = parse(text);
    const auto& read = dynamic_cast<const THREE::DirectionalLight&>(*loaded.scene->children().at(4));
    EXPECT_EQ(read.directionTowardsLight(), expected);
    EXPECT_EQ(toJSON(*loaded.scene), text);

    scene.position.set(0, 4, 0);  // the target outside the tree does not move with the scene
    scene.updateMatrixWorld();
    LoadedScene moved = parse(toJSON(scene));
    const auto& follows = dynamic_cast<const THREE::DirectionalLight&>(*moved.scene->children().at(3));
    EXPECT_LT(follows.directionTowardsLight().distanceTo(sun.directionTowardsLight()), 1e-15);

    group.add(sun.target);  // a target in the tree is written where it stands
    scene.updateMatrixWorld();
    LoadedScene hung = parse(toJSON(scene));
    expectSame(scene, *hung.scene);
    EXPECT_EQ(
        dynamic_cast<const THREE::DirectionalLight&>(*hung.scene->children().at(3)).directionTowardsLight(),
        sun.directionTowardsLight());
}

TEST_F(ToJson, prefersAnEditedColourToTheExactOne) {
    json j = json::parse(toJSON(scene));
    j["materials"][1]["color"] = 0x00FF00;
    const LoadedScene loaded = parse(j.dump());
    const auto& mesh = dynamic_cast<const THREE::Mesh&>(*loaded.scene->children().at(1)->children().at(0));
    EXPECT_EQ(mesh.material->color, THREE::Color(0x00FF00));
}

TEST_F(ToJson, prefersAnEditedMatrixToTheParts) {
    json j = json::parse(toJSON(scene));
    ASSERT_TRUE(j["object"]["children"][0].contains("position"));
    j["object"]["children"][0]["matrix"][12] = 9;
    EXPECT_EQ(parse(j.dump()).scene->children().at(0)->position.x, 9);
}

TEST_F(ToJson, refusesWhatJsonCannotSay) {
    const auto refusal = [this] {
        try {
            toJSON(scene);
        } catch (const THREE::SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    lamp.name = "luce2";
    lamp.intensity = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal().substr(0, 78),
              "PointLight 'luce2': intensity: expected a finite number, found NaN, which JSON");
    lamp.intensity = 1;
    odd.color.r = std::numeric_limits<double>::infinity();
    EXPECT_NE(refusal().find("lambertColor: expected a finite number, found infinity"), std::string::npos);
    odd.color.r = 1;
    THREE::Mesh orphan{triangle, orange};
    orphan.name = "orfana";
    {
        THREE::MeshLambertMaterial brief;
        orphan.material = brief;
    }
    scene.add(orphan);
    EXPECT_NE(refusal().find("Mesh 'orfana': its material was destroyed"), std::string::npos);
}

}  // namespace
