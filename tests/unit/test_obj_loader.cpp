// Unit tests of loadObj: what an .obj means, and that a bad line is refused with its number.
// SPDX-License-Identifier: MIT
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace {

class ObjLoader : public testing::Test {
  protected:
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("lambert_obj_" + std::to_string(::getpid()));
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return (folder / name).string();
    }
    THREE::LoadedScene load(const std::string& text) const {
        return THREE::ObjectLoader().load(write("scena.OBJ", text));
    }
    // What follows "...scena.OBJ: " in the refusal, or "" where the text loads.
    std::string refusal(const std::string& text) const {
        try {
            load(text);
        } catch (const THREE::SceneError& error) {
            const std::string message = error.what();
            return message.substr(message.find(": ") + 2);
        }
        return "";
    }
};

const THREE::Mesh& mesh(const THREE::LoadedScene& loaded, std::size_t number) {
    return dynamic_cast<const THREE::Mesh&>(*loaded.scene->children().at(number));
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjLoader, cutsPolygonsAndComputesNormals) {
    const auto quad = load(square + "f 1 2 3 4\n");
    EXPECT_EQ(mesh(quad, 0).geometry->triangleCount(), 2U);
    EXPECT_EQ(mesh(quad, 0).geometry->vertexCount(), 4U);
    const auto& normal = mesh(quad, 0).geometry->attributes.at("normal");
    for (std::size_t i = 0; i < normal.count(); ++i)
        EXPECT_EQ(normal.getXYZ(i), THREE::Vector3(0, 0, 1));
    EXPECT_EQ(mesh(quad, 0).material->color, THREE::Color(1, 1, 1));
    EXPECT_TRUE(quad.notes.empty());
    const auto pentagon = load(square + "v 0.5 2 0\nf -5 -4 -3 -1 -2\n");
    EXPECT_EQ(mesh(pentagon, 0).geometry->triangleCount(), 3U);
}

TEST_F(ObjLoader, readsDoublesNormalsAndTextureCoordinates) {
    const auto loaded = load("v 0.1 +100000000.125 -3e-2\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nvn 0 1 0\nvn 1 0 0\n"
                             "f 1/1/1 2/1/1 3/1/2\nf 1//2 3//2 2//2\n");
    const THREE::BufferGeometry& geometry = *mesh(loaded, 0).geometry;
    EXPECT_NEAR(geometry.attributes.at("position").getX(0), 0.1, 1e-16) << "doubles, not floats";
    EXPECT_NEAR(geometry.attributes.at("position").getY(0), 100000000.125, 1e-6);
    EXPECT_EQ(geometry.attributes.at("normal").getXYZ(0), THREE::Vector3(0, 1, 0));
    EXPECT_EQ(geometry.vertexCount(), 5U) << "corners that agree in v and vn share a vertex";
    EXPECT_EQ(geometry.getAttribute("uv"), nullptr) << "not every corner has one";
}

// At \r alone too: tinyobjloader ends lines there, so a line that is checked must end there as well.
TEST_F(ObjLoader, endsLinesAsEverySystemDoes) {
    for (const char* const end : {"\n", "\r\n", "\r"}) {
        std::string text;
        for (const char* const line : {"o a  b", "v 0 0 0", "v 1 0 0", "", "\tv 0 1 0 ", "f 1 2 3"})
            text.append(line).append(end);
        const auto loaded = load(text);
        EXPECT_EQ(mesh(loaded, 0).geometry->vertexCount(), 3U);
        EXPECT_EQ(mesh(loaded, 0).name, "a b");
        EXPECT_EQ(refusal(text + "x" + end),
                  "line 7: expected a Wavefront keyword such as v, vn, f or usemtl "
                  "(free-form surfaces are not supported), found x");
    }
    EXPECT_EQ(refusal("v 0 0 0\nv\r1 0 0\r\nv 0 1 0\nf 1 2 3\n"),
              "line 2: expected 3 numbers after v, found 0");
}

TEST_F(ObjLoader, readsTextWithItsMaterialsBesideTheFile) {
    const std::string mtl = write("m.mtl", "newmtl a\rKd 1 0 0\r");
    const auto loaded = THREE::parseObj("mtllib m.mtl\nusemtl a\n" + square + "f 1 2 3\n", mtl);
    EXPECT_EQ(mesh(loaded, 0).material->color, THREE::Color(1, 0, 0));
}

TEST_F(ObjLoader, smoothsAsTheFileSays) {
    // Two triangles of a roof along the edge from 1 to 2.
    const std::string roof = "v 0 0 0\nv 1 0 0\nv 0 -1 1\nv 0 -1 -1\n";
    const auto vertices = [&](const std::string& faces) {
        return mesh(load(roof + faces), 0).geometry->vertexCount();
    };
    EXPECT_EQ(vertices("f 1 3 2\nf 1 2 4\n"), 4U) << "smooth where the file does not say";
    EXPECT_EQ(vertices("s 1\nf 1 3 2\nf 1 2 4\n"), 4U);
    EXPECT_EQ(vertices("s off\nf 1 3 2\nf 1 2 4\n"), 6U);
    EXPECT_EQ(vertices("s 1\nf 1 3 2\ns 2\nf 1 2 4\n"), 6U);
}

TEST_F(ObjLoader, makesAMeshPerShapeWithItsMaterial) {
    write(
        "colori.mtl",
        "newmtl arancio\nKd 1 0.5 0.25\nillum 1\nKs 1 1 1\nKe 0 0 0.5\nnewmtl vuoto\nmap_Kd a.png\nd 0.5\n");
    const auto loaded =
        load("mtllib colori.mtl\n" + square +
             "o primo\nusemtl arancio\nf 1 2 3\nusemtl vuoto\nf 1 3 4\no secondo\nf 1 2 4\nl 1 2\n");
    ASSERT_EQ(loaded.scene->children().size(), 3U);
    EXPECT_EQ(mesh(loaded, 0).name, "primo");
    EXPECT_EQ(mesh(loaded, 1).name, "primo");
    EXPECT_EQ(mesh(loaded, 2).name, "secondo");
    EXPECT_EQ(mesh(loaded, 0).material->name, "arancio");
    EXPECT_EQ(mesh(loaded, 0).material->color, THREE::Color(1, 0.5, 0.25));
    EXPECT_EQ(mesh(loaded, 0).material->emitted(), THREE::Color(0, 0, 0.5));
    EXPECT_EQ(mesh(loaded, 1).material->color, THREE::Color(1, 1, 1)) << "no Kd: white";
    EXPECT_STREQ(mesh(loaded, 0).material->type(), "MeshLambertMaterial") << "illum 1: no highlight";
    EXPECT_EQ(loaded.notes.size(), 3U) << "map_Kd, d and the line";
}

TEST_F(ObjLoader, readsHighlights) {
    write("lucidi.mtl", "newmtl a\nKs 1 0.5 0.25\nNs 12\nillum 2\nnewmtl b\nKs 1 1 1\nnewmtl c\nNs 5\n");
    const auto loaded =
        load("mtllib lucidi.mtl\n" + square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl c\nf 1 2 4\n");
    const auto phong = [&](std::size_t i) {
        return dynamic_cast<const THREE::MeshPhongMaterial*>(mesh(loaded, i).material.get());
    };
    ASSERT_NE(phong(0), nullptr);
    EXPECT_EQ(phong(0)->specular, THREE::Color(1, 0.5, 0.25));
    EXPECT_EQ(phong(0)->shininess, 12);
    EXPECT_EQ(phong(0)->specularModel, THREE::SpecularModel::blinn);
    ASSERT_NE(phong(1), nullptr);
    EXPECT_EQ(phong(1)->shininess, 30) << "no Ns: three.js's default";
    EXPECT_EQ(phong(2), nullptr) << "no Ks: nothing shines";
}

TEST_F(ObjLoader, notesAMissingMaterialFile) {
    const auto loaded = load("mtllib manca.mtl\nusemtl x\n" + square + "f 1 2 3\n");
    EXPECT_EQ(mesh(loaded, 0).material->color, THREE::Color(1, 1, 1));
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_NE(loaded.notes[0].find("manca.mtl: no such file"), std::string::npos);
}

TEST_F(ObjLoader, refusesBadLinesByNumber) {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"", "expected a scene, found an empty file"},
        {"# nothing\n", "expected faces (lines that begin with f), found none"},
        {"v 1 2\n", "line 1: expected 3 numbers after v, found 2"},
        {"v 1 2 x\n", "line 1: expected a number of at most 1e36, found x"},
        {"v 1 2 nan\n", "line 1: expected a number"},
        {"v 1 2 1e999\n", "line 1: expected a number"},
        {"\n\nv 1 2 1e37\n", "line 3: expected a number"},
        {"f 1 2\n", "line 1: expected a face of 3 to 1000 corners, found 2 corners"},
        {"v 0 0 0\nf 1 1 0\n",
         "line 2: expected a corner as v, v/vt, v//vn or v/vt/vn, counted from 1, found 0"},
        {"v 0 0 0\nf 1 1 2\n", "line 2: expected a number up to 1, how many lines v there are, found 2"},
        {"v 0 0 0\nf 1 1 -2\n", "line 2: expected a corner whose numbers exist (1 lines v so far), found -2"},
        {"v 0 0 0\nf 1//1 1//1 1//1\n", "line 2: expected a number up to 0, how many lines vn"},
        {"v 0 0 0\nf 1/9 1/9 1/9\n", "line 2: expected a number up to 0, how many lines vt"},
        {"v 0 0 0\nf 1/ 1 1\n", "line 2: expected a corner as"},
        {"v 0 0 0\nf 1/1/1/1 1 1\n", "line 2: expected a corner as"},
        {"v 0 0 0\nf 99999999999999999999 1 1\n", "line 2: expected a corner as"},
        {"v 0 0 0\nf 4294967297 1 1\n", "line 2: expected a corner whose numbers exist"},
        {"curv 0 1 2\n", "line 1: expected a Wavefront keyword"},
        {"\x7f"
         "ELF\x01\n",
         "line 1: expected a Wavefront keyword"},
        {"v 0 0 \\\n0\n", "line 1: expected each statement on one line"},
    };
    for (const Case& c : cases)
        EXPECT_EQ(refusal(c.text).substr(0, std::string(c.message).size()), c.message) << c.text;
    std::string corners = "v 0 0 0\nf";
    for (int i = 0; i < 1001; ++i)
        corners += " 1";
    EXPECT_EQ(refusal(corners).substr(0, 33), "line 2: expected a face of 3 to 1");
    write("rotto.mtl", "newmtl a\nKd 1 uno 1\n");
    EXPECT_EQ(refusal("mtllib rotto.mtl\n" + square + "f 1 2 3\n"),
              "line 2: expected a number of at most 1e36, found uno");
}

}  // namespace
