// Unit tests of ObjectLoader: what three.js's JSON means, and that each refusal names file, path, expected and found.
// SPDX-License-Identifier: MIT
#include "three/lights.hpp"
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace {

using THREE::LoadedScene;

LoadedScene parse(const std::string& json) { return THREE::ObjectLoader().parse(json, "scena.json"); }

// The refusal's text, or "" where the text loads. Any other exception fails the test by itself.
std::string refusal(const std::string& json) {
    try {
        parse(json);
    } catch (const THREE::SceneError& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const std::string triangle =
    R"({"uuid":"g","type":"BufferGeometry","data":{"attributes":{"position":{"itemSize":3,"type":"Float32Array",)"
    R"("array":[0,0,0,1,0,0,0,1,0]}}}})";
const std::string lambert = R"({"uuid":"m","type":"MeshLambertMaterial","color":16746581})";
const std::string mesh = R"({"type":"Mesh","geometry":"g","material":"m"})";

// A scene of the given children (and more fields of the Scene), geometries and materials.
std::string scene(const std::string& children, const std::string& geometries = triangle,
                  const std::string& materials = lambert, const std::string& more = "") {
    return R"({"metadata":{"version":4.5,"type":"Object"},"geometries":[)" + geometries +
           R"(],"materials":[)" + materials + R"(],"object":{"type":"Scene")" + more + R"(,"children":[)" +
           children + "]}}";
}
std::string withGeometry(const std::string& geometry) { return scene(mesh, geometry); }
std::string withMaterial(const std::string& fields) {
    return scene(mesh, triangle, R"({"uuid":"m","type":"MeshLambertMaterial",)" + fields + "}");
}
std::string withAttribute(const std::string& fields) {
    return withGeometry(R"({"uuid":"g","type":"BufferGeometry","data":{"attributes":{"position":{)" + fields +
                        "}}}}");
}

template <class T>
const T& child(const LoadedScene& loaded, std::size_t number) {
    const T* object = dynamic_cast<const T*>(loaded.scene->children().at(number));
    if (object == nullptr)
        throw std::runtime_error("child of another class");
    return *object;
}

void expectDirection(const THREE::DirectionalLight& light, double x, double y, double z) {
    EXPECT_LT(light.directionTowardsLight().distanceTo({x, y, z}), 1e-15);
}

TEST(ObjectLoader, readsEveryThreeJsScene) {
    const char* const names[] = {"s01_dark",         "s02_directional",  "s03_point_decay0",
                                 "s04_point_decay2", "s05_point_decay1", "s06_dir_point",
                                 "s07_ambient",      "s08_lez04"};
    for (const std::string name : names) {
        const LoadedScene loaded =
            THREE::ObjectLoader().load(LAMBERT_SOURCE_DIR "/tests/threejs/" + name + ".json");
        EXPECT_EQ(loaded.scene->name, name);
        ASSERT_NE(loaded.camera, nullptr) << name;
        EXPECT_EQ(loaded.camera->fov, 40) << name;
        EXPECT_TRUE(loaded.notes.empty()) << name << ": " << loaded.notes.front();
        EXPECT_NO_THROW(THREE::validate(*loaded.scene, *loaded.camera)) << name;
    }
}

TEST(ObjectLoader, readsLez04AsItStands) {
    const LoadedScene loaded = THREE::ObjectLoader().load(LAMBERT_SOURCE_DIR "/tests/threejs/s08_lez04.json");
    const auto& knot = child<THREE::Mesh>(loaded, 0);
    EXPECT_EQ(knot.geometry->vertexCount(), 3381U);
    EXPECT_EQ(knot.geometry->triangleCount(), 6400U);
    EXPECT_EQ(knot.material->color.getHex(), 0xFF8855U);
    const auto& sun = child<THREE::DirectionalLight>(loaded, 1);
    EXPECT_EQ(sun.position, THREE::Vector3(0, 3, -2));
    EXPECT_NEAR(sun.directionTowardsLight().y, 3 / std::sqrt(13.0), 1e-15);
    const auto& lamp = child<THREE::PointLight>(loaded, 2);
    EXPECT_EQ(lamp.color.getHex(), 0xDD6666U);
    EXPECT_EQ(lamp.position, THREE::Vector3(2, 1.5, 5));
    EXPECT_EQ(lamp.decay, 0);
    EXPECT_EQ(child<THREE::AmbientLight>(loaded, 3).color.getHex(), 0x101010U);
    EXPECT_EQ(loaded.scene->background->getHex(), 0U);
}

TEST(ObjectLoader, readsPartsWhereThereIsNoMatrix) {
    const LoadedScene loaded = parse(scene(
        R"({"type":"Group","position":[1,2,3],"rotation":[0.1,0.2,0.3,"ZYX"],"scale":[2,3,4],"up":[0,0,1],"children":[)" +
        mesh + R"(]},{"type":"PointLight","quaternion":[0,1,0,0],"visible":false,"name":"spenta"})"));
    const auto& group = child<THREE::Group>(loaded, 0);
    EXPECT_EQ(group.position, THREE::Vector3(1, 2, 3));
    EXPECT_EQ(group.rotation.y, 0.2);
    EXPECT_EQ(group.rotation.order(), THREE::EulerOrder::ZYX);
    EXPECT_EQ(group.scale, THREE::Vector3(2, 3, 4));
    EXPECT_EQ(group.up, THREE::Vector3(0, 0, 1));
    EXPECT_EQ(group.children().at(0)->matrixWorld.position(), THREE::Vector3(1, 2, 3));
    const auto& lamp = child<THREE::PointLight>(loaded, 1);
    EXPECT_EQ(lamp.quaternion.y, 1);
    EXPECT_FALSE(lamp.visible);
    EXPECT_EQ(lamp.name, "spenta");
    EXPECT_EQ(lamp.decay, 0) << "a file that does not say it means slide 37's light";
    EXPECT_EQ(lamp.intensity, 1);
}

TEST(ObjectLoader, normalizesWholeNumbersAsOpenGl) {
    const auto first = [](const std::string& type, const std::string& array) {
        const LoadedScene loaded = parse(withAttribute(R"("itemSize":3,"normalized":true,"type":")" + type +
                                                       R"(","array":[)" + array + "]"));
        return child<THREE::Mesh>(loaded, 0).geometry->attributes.at("position").array;
    };
    EXPECT_EQ(first("Int8Array", "127,-127,-128, 0,0,0, 0,0,0"),
              (std::vector<double>{1, -1, -1, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(first("Uint8Array", "255,51,0, 0,0,0, 0,0,0"),
              (std::vector<double>{1, 0.2, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(first("Int16Array", "32767,-32768,0, 0,0,0, 0,0,0"),
              (std::vector<double>{1, -1, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(first("Uint16Array", "65535,13107,0, 0,0,0, 0,0,0"),
              (std::vector<double>{1, 0.2, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(ObjectLoader, readsParametricGeometriesByOldAndNewNames) {
    for (const char* type :
         {"BoxGeometry", "SphereGeometry", "PlaneGeometry", "TorusGeometry", "TorusKnotGeometry",
          "CylinderGeometry", "BoxBufferGeometry", "TorusKnotBufferGeometry"}) {
        const LoadedScene loaded =
            parse(withGeometry(std::string(R"({"uuid":"g","name":"forma","type":")") + type + "\"}"));
        const THREE::BufferGeometry& geometry = *child<THREE::Mesh>(loaded, 0).geometry;
        EXPECT_GT(geometry.triangleCount(), 0U) << type;
        EXPECT_EQ(std::string(type).substr(0, 3), std::string(geometry.type()).substr(0, 3));
        EXPECT_EQ(geometry.name, "forma");
    }
    const LoadedScene cone =
        parse(withGeometry(R"({"uuid":"g","type":"ConeGeometry","radius":2,"openEnded":true})"));
    const auto parameters = child<THREE::Mesh>(cone, 0).geometry->parameters();
    EXPECT_EQ(parameters.at(0), (std::pair<std::string, double>("radiusTop", 0)));
    EXPECT_EQ(parameters.at(1), (std::pair<std::string, double>("radiusBottom", 2)));
    EXPECT_EQ(parameters.at(5), (std::pair<std::string, double>("openEnded", 1)));
}

TEST(ObjectLoader, aimsDirectionalLights) {
    const std::string light = R"({"type":"DirectionalLight","position":[0,5,0],"target":)";
    const LoadedScene object =
        parse(scene(R"({"type":"Object3D","uuid":"t","position":[3,1,0]},)" + light + "\"t\"}"));
    expectDirection(child<THREE::DirectionalLight>(object, 1), -0.6, 0.8, 0);
    EXPECT_EQ(object.scene->children().at(0), &child<THREE::DirectionalLight>(object, 1).target);

    // A target that draws stays itself; the light's own target hangs below it and follows it.
    LoadedScene onMesh = parse(
        scene(light + R"("t"},{"type":"Mesh","uuid":"t","geometry":"g","material":"m","position":[3,1,0]})"));
    expectDirection(child<THREE::DirectionalLight>(onMesh, 0), -0.6, 0.8, 0);
    onMesh.scene->children().at(1)->position.set(0, 1, 0);
    onMesh.scene->updateMatrixWorld();
    expectDirection(child<THREE::DirectionalLight>(onMesh, 0), 0, 1, 0);

    const LoadedScene elsewhere = parse(scene(light + "\"altrove\"}"));
    expectDirection(child<THREE::DirectionalLight>(elsewhere, 0), 0, 1, 0);

    // Targets that hold each other's lights must neither leak nor hang.
    const LoadedScene ring =
        parse(scene(R"({"type":"Object3D","uuid":"a","children":[{"type":"DirectionalLight","target":"b"}]},)"
                    R"({"type":"Object3D","uuid":"b","children":[{"type":"DirectionalLight","target":"a"}]},)"
                    R"({"type":"DirectionalLight","uuid":"c","target":"c"})"));
    EXPECT_EQ(ring.scene->children().size(), 3U);
}

TEST(ObjectLoader, wrapsAnObjectThatIsNoScene) {
    const LoadedScene loaded = parse(R"({"geometries":[)" + triangle + R"(],"materials":[)" + lambert +
                                     R"(],"object":)" + mesh + "}");
    EXPECT_EQ(loaded.scene->children().size(), 1U);
    EXPECT_EQ(child<THREE::Mesh>(loaded, 0).material->color.getHex(), 0xFF8855U);
}

TEST(ObjectLoader, keepsAShearOnlyWhereTheMatrixStands) {
    const std::string sheared = R"({"type":"Group","matrix":[1,0,0,0,1,1,0,0,0,0,1,0,0,0,0,1])";
    const LoadedScene dropped = parse(scene(sheared + "}"));
    EXPECT_TRUE(contains(dropped.notes.at(0), "object.children[0].matrix: its shear")) << dropped.notes.at(0);
    const LoadedScene kept = parse(scene(sheared + R"(,"matrixAutoUpdate":false})"));
    EXPECT_TRUE(kept.notes.empty());
    EXPECT_EQ(kept.scene->children().at(0)->matrixWorld.elements[1][0], 1);
}

struct Left {
    const char* children;
    const char* note;
};

// What cannot change the picture is left out with a note, and leaves a plain object at its place.
TEST(ObjectLoader, leavesOutWhatCannotBeSeen) {
    const Left cases[] = {
        {R"({"type":"SpotLight","intensity":0})",
         "object.children[0]: SpotLight left out: it gives no light"},
        {R"({"type":"HemisphereLight","color":0,"groundColor":0})", "it gives no light"},
        {R"({"type":"SpotLight","visible":false})", "it is invisible (scena.json: object.children[0]"},
        {R"({"type":"Sprite","layers":2})", "the camera does not see its layers"},
        {R"({"type":"Mesh","layers":6,"geometry":"g","material":"m"})", "the camera does not see its layers"},
        {R"({"type":"RectAreaLight"})", "only MeshStandardMaterial"},
        {R"({"type":"Audio"})", "heard"},
        {R"({"type":"InstancedMesh","count":0})", "no instances"},
        {R"({"type":"Points","geometry":"vuota"})", "its geometry is empty"},
        {R"({"type":"Mesh","visible":false,"geometry":"g","material":"std"})",
         "MeshStandardMaterial is not supported"},
        {R"({"type":"Group","visible":false,"children":[{"type":"Line"}]})",
         "children[0].children[0]: Line left out"},
    };
    const std::string empty = R"({"uuid":"vuota","type":"BufferGeometry","data":{"attributes":{}}})";
    const std::string standard = R"({"uuid":"std","type":"MeshStandardMaterial"})";
    for (const Left& c : cases) {
        const LoadedScene loaded = parse(scene(c.children, triangle + "," + empty, lambert + "," + standard));
        ASSERT_EQ(loaded.notes.size(), 1U) << c.children;
        EXPECT_TRUE(contains(loaded.notes[0], c.note)) << loaded.notes[0];
        EXPECT_EQ(loaded.scene->children().size(), 1U);
    }
}

TEST(ObjectLoader, usesTheFirstPerspectiveCamera) {
    const LoadedScene loaded =
        parse(scene(R"({"type":"OrthographicCamera"},{"type":"PerspectiveCamera","fov":30},)"
                    R"({"type":"PerspectiveCamera","name":"b","filmOffset":3})"));
    EXPECT_EQ(loaded.camera, loaded.scene->children().at(1));
    EXPECT_EQ(loaded.camera->fov, 30);
    EXPECT_EQ(loaded.notes.size(), 2U);
    EXPECT_EQ(parse(scene(mesh)).camera, nullptr);
}

TEST(ObjectLoader, notesFilesOfPhysicalUnits) {
    const std::string old = R"({"metadata":{"version":4.5},"object":{"type":"Scene"}})";
    const std::string recent = R"({"metadata":{"version":4.6},"object":{"type":"Scene"}})";
    EXPECT_TRUE(parse(old).notes.empty());
    EXPECT_TRUE(contains(parse(recent).notes.at(0), "pi times brighter"));
}

TEST(ObjectLoader, ignoresWhatIsHarmless) {
    const std::string harmless =
        R"("depthFunc":3,"depthTest":true,"stencilWrite":false,"reflectivity":1,"opacity":0.5,"transparent":false,)"
        R"("blending":0,"dithering":true,"toneMapped":false,"map":null,"specularMap":"x","wireframe":false,)"
        R"("vertexColors":false,"alphaTest":0.25,"userData":{"a":[1]},"side":2,"flatShading":true,"emissive":255,)"
        R"("emissiveIntensity":0.5)";
    const LoadedScene loaded = parse(withMaterial(harmless));
    EXPECT_TRUE(loaded.notes.empty());
    const THREE::Material& material = *child<THREE::Mesh>(loaded, 0).material;
    EXPECT_EQ(material.side, THREE::DoubleSide);
    EXPECT_TRUE(material.flatShading);
    EXPECT_EQ(material.emitted(), THREE::Color(0, 0, 0.5));
    EXPECT_EQ(material.color, THREE::Color(1, 1, 1)) << "three.js's default";
    EXPECT_TRUE(
        parse(scene(R"({"type":"Mesh","geometry":"g","material":"m","castShadow":true,"renderOrder":3})",
                    triangle, lambert, R"(,"background":null,"fog":null)"))
            .notes.empty());
}

TEST(ObjectLoader, takesAnyOpacityOfAnOpaqueMaterialWithoutAlphaTest) {
    for (const char* const fields : {R"("opacity":-1)", R"("opacity":-1,"alphaTest":0)", R"("alphaTest":-1)"})
        EXPECT_EQ(refusal(withMaterial(fields)), "");
}

TEST(ObjectLoader, takesAnArrayOfOneMaterialWhereItsGroupsCoverAll) {
    const std::string listed = R"({"type":"Mesh","geometry":"g","material":["m"]})";
    std::string grouped = triangle;
    grouped.insert(grouped.size() - 2, R"(,"groups":[{"start":0,"count":3,"materialIndex":0}])");
    EXPECT_EQ(refusal(scene(listed, grouped)), "");
    EXPECT_TRUE(contains(refusal(scene(listed)), "object.children[0].material: several materials"));
}

}  // namespace
