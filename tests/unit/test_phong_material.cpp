// Unit tests of MeshPhongMaterial: its fields, its way into three.js's JSON and back, what is refused.
// SPDX-License-Identifier: MIT
#include "three/object_loader.hpp"
#include "three/three.hpp"
#include "three/validate.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace {

using THREE::MeshPhongMaterial;
using THREE::SpecularModel;

// A scene file with one mesh whose material has these fields.
std::string fileWith(const std::string& fields) {
    return R"({"metadata":{"version":4.5,"type":"Object"},"geometries":[{"uuid":"g","type":"BoxGeometry"}],)"
           R"("materials":[{"uuid":"m","type":"MeshPhongMaterial")" +
           fields +
           R"(}],"object":{"type":"Scene","children":[{"type":"Mesh","geometry":"g","material":"m"}]}})";
}

const MeshPhongMaterial& materialOf(const THREE::LoadedScene& loaded) {
    const auto& mesh = dynamic_cast<const THREE::Mesh&>(*loaded.scene->children().at(0));
    return dynamic_cast<const MeshPhongMaterial&>(*mesh.material);
}

TEST(MeshPhongMaterial, StartsAsInThreeJs) {
    const MeshPhongMaterial material(0xFF8855);
    EXPECT_EQ(material.color, THREE::Color(0xFF8855));
    EXPECT_EQ(material.specular, THREE::Color(0x111111));
    EXPECT_EQ(material.shininess, 30);
    EXPECT_EQ(material.specularModel, SpecularModel::phong) << "in code, the slides'";
    EXPECT_TRUE(material.isLit());
    EXPECT_STREQ(material.type(), "MeshPhongMaterial");
}

TEST(MeshPhongMaterial, IsReadFromThreeJsJson) {
    const auto usual = THREE::ObjectLoader().parse(fileWith(""), "f");
    EXPECT_EQ(materialOf(usual).specular, THREE::Color(0x111111));
    EXPECT_EQ(materialOf(usual).shininess, 30);
    EXPECT_EQ(materialOf(usual).specularModel, SpecularModel::blinn) << "three.js has no other";
    const auto own = THREE::ObjectLoader().parse(
        fileWith(R"(,"color":255,"specular":16711680,"shininess":7.5,"emissive":65280,"flatShading":true,)"
                 R"("userData":{"specularModel":"phong","other":[1]})"),
        "f");
    EXPECT_EQ(materialOf(own).color, THREE::Color(0x0000FF));
    EXPECT_EQ(materialOf(own).specular, THREE::Color(0xFF0000));
    EXPECT_EQ(materialOf(own).shininess, 7.5);
    EXPECT_EQ(materialOf(own).emissive, THREE::Color(0x00FF00));
    EXPECT_TRUE(materialOf(own).flatShading);
    EXPECT_EQ(materialOf(own).specularModel, SpecularModel::phong);
    for (const char* userData : {"null", "{}", "\"phong\"", "{\"specularModel\":3}"}) {
        const auto loaded =
            THREE::ObjectLoader().parse(fileWith(R"(,"userData":)" + std::string(userData)), "f");
        EXPECT_EQ(materialOf(loaded).specularModel, SpecularModel::blinn) << userData;
    }
}

TEST(MeshPhongMaterial, SurvivesAFile) {
    for (const SpecularModel model : {SpecularModel::phong, SpecularModel::blinn}) {
        THREE::Scene scene;
        THREE::BoxGeometry box;
        MeshPhongMaterial material(THREE::Color(0.1, 0.2, 0.3));
        material.specular = THREE::Color(0.123456789, 1.5, 0);
        material.shininess = 1.0 / 3;
        material.emissive.set(0x102030);
        material.specularModel = model;
        THREE::Mesh mesh(box, material);
        scene.add(mesh);
        const auto loaded = THREE::ObjectLoader().parse(THREE::toJSON(scene), "f");
        EXPECT_EQ(materialOf(loaded).specular, material.specular);
        EXPECT_EQ(materialOf(loaded).shininess, material.shininess);
        EXPECT_EQ(materialOf(loaded).emissive, material.emissive);
        EXPECT_EQ(materialOf(loaded).color, material.color);
        EXPECT_EQ(materialOf(loaded).specularModel, model);
    }
}

TEST(MeshPhongMaterial, RefusesWhatItCannotDraw) {
    const struct {
        const char* fields;
        const char* message;
    } cases[] = {
        {R"(,"shininess":"much")", "f: materials[0].shininess: expected a number"},
        {R"(,"specular":-1)", "f: materials[0].specular: expected"},
        {R"(,"specularMap":"t")", "f: materials[0].specularMap: textures are not supported"},
        {R"(,"normalMap":"t")", "f: materials[0].normalMap: textures are not supported"},
    };
    for (const auto& c : cases)
        try {
            THREE::ObjectLoader().parse(fileWith(c.fields), "f");
            ADD_FAILURE() << c.fields << " was read";
        } catch (const THREE::SceneError& error) {
            EXPECT_EQ(std::string(error.what()).substr(0, std::string(c.message).size()), c.message);
        }
}

TEST(MeshPhongMaterial, IsValidatedByNameAndField) {
    const auto refusal = [](double specular, double shininess) -> std::string {
        THREE::Scene scene;
        THREE::BoxGeometry box;
        MeshPhongMaterial material;
        material.specular.g = specular;
        material.shininess = shininess;
        THREE::Mesh mesh(box, material);
        mesh.name = "cubo";
        scene.add(mesh);
        THREE::PerspectiveCamera camera;
        camera.position.z = 5;
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
        try {
            THREE::validate(scene, camera);
        } catch (const THREE::SceneError& error) {
            return error.what();
        }
        return "";
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(0.5, 0), "");
    EXPECT_EQ(refusal(2, 1e36), "");
    EXPECT_EQ(refusal(-1, 5), "Mesh 'cubo': material.specular.g must be 0 or more, found -1");
    EXPECT_EQ(refusal(nan, 5),
              "Mesh 'cubo': material.specular.g must be a number of at most 1e36, found nan");
    EXPECT_EQ(refusal(0.5, -2), "Mesh 'cubo': material.shininess must be 0 or more, found -2");
    EXPECT_EQ(
        refusal(0.5, 1e37),
        "Mesh 'cubo': material.shininess must be a number of at most 1e36, found 9.9999999999999995e+36");
}

}  // namespace
