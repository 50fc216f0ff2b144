// Unit tests of what validate() says of meshes whose vertices, indices or lifetime are wrong.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"
#include "three/validate.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string refusal(THREE::Scene& scene) {
    THREE::PerspectiveCamera camera;
    scene.updateMatrixWorld();
    try {
        THREE::validate(scene, camera);
    } catch (const THREE::SceneError& error) {
        return error.what();
    }
    return "";
}

struct Geometry : testing::Test {
    THREE::BufferGeometry geometry;
    THREE::MeshLambertMaterial material;
    THREE::Mesh mesh{geometry, material};
    THREE::Scene scene;

    Geometry() {
        geometry.setAttribute("position", {0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
        geometry.setAttribute("normal", {0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
        geometry.setIndex({0, 1, 2});
        mesh.name = "nodo";
        scene.add(mesh);
    }

    void expectRefusal(const std::vector<std::string>& parts) {
        const std::string text = refusal(scene);
        EXPECT_EQ(text.rfind("Mesh 'nodo': ", 0), 0u) << text;
        for (const std::string& part : parts)
            EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is missing in: " << text;
    }
};

TEST_F(Geometry, NumbersOfVerticesByTheirPlace) {
    for (const double bad : {nan, std::numeric_limits<double>::infinity(), 2e36, -2e36}) {
        geometry.attributes["position"].array[7] = bad;
        geometry.needsUpdate();
        expectRefusal({"geometry.attributes.position[7] must be a number of at most 1e36, found "});
    }
    geometry.attributes["position"].array[7] = 1;
    geometry.attributes["normal"].array[2] = nan;
    geometry.needsUpdate();
    expectRefusal({"geometry.attributes.normal[2]", "found nan"});
}

TEST_F(Geometry, AttributesOfAWrongSize) {
    geometry.setAttribute("normal", {0, 0, 1, 0, 0, 1}, 3);
    expectRefusal({"geometry.attributes.normal", "expected 3", "found 2"});
    // What setAttribute refuses by itself may still be written by hand.
    geometry.attributes["normal"].array = {0, 0, 1, 0, 0, 1, 0, 0};
    geometry.needsUpdate();
    expectRefusal({"geometry.attributes.normal", "3 numbers per vertex", "8 numbers"});
    geometry.setAttribute("normal", {0, 1, 0, 1, 0, 1}, 2);
    expectRefusal({"geometry.attributes.normal", "itemSize 2"});
    geometry.attributes.erase("normal");
    geometry.setAttribute("position", {0, 0, 0, 1, 0, 0, 0, 1}, 4);
    expectRefusal({"geometry.attributes.position", "itemSize 4", "8 numbers"});
    geometry.attributes["position"].itemSize = 0;  // nothing may be divided by it
    geometry.needsUpdate();
    expectRefusal({"geometry.attributes.position", "itemSize 0"});
}

TEST_F(Geometry, IndexOutOfRangeWithItsNumber) {
    geometry.setIndex({0, 1, 2, 0, 3, 1});
    expectRefusal({"geometry.index[4]", "3, found 3"});
    geometry.setIndex({0, 1, 4294967295u});
    expectRefusal({"geometry.index[2]", "found 4294967295"});
    geometry.setIndex({0, 1, 2, 0});
    expectRefusal({"geometry.index", "3 indices per triangle", "found 4"});
}

TEST_F(Geometry, AnIndexWithoutAnyVertex) {
    geometry.attributes.clear();
    geometry.needsUpdate();
    expectRefusal({"geometry.index[0]", "found 0"});
    geometry.setIndex({});
    EXPECT_EQ(refusal(scene), "");  // nothing to draw is not wrong
}

// Good numbers are read once per version, so a change by hand must be announced, as in three.js.
TEST_F(Geometry, AreReadOncePerVersion) {
    EXPECT_EQ(refusal(scene), "");
    EXPECT_EQ(geometry.validatedVersion(), geometry.version());
    geometry.attributes["position"].array[0] = nan;
    EXPECT_EQ(refusal(scene), "");
    geometry.needsUpdate();
    EXPECT_NE(refusal(scene), "");
    EXPECT_NE(refusal(scene), "");  // what was refused stays refused
    EXPECT_NE(geometry.validatedVersion(), geometry.version());
}

TEST_F(Geometry, DestroyedBeforeItsMesh) {
    auto short_lived = std::make_unique<THREE::BoxGeometry>();
    mesh.geometry = *short_lived;
    EXPECT_EQ(refusal(scene), "");
    short_lived.reset();
    expectRefusal({"geometry was destroyed", "declare the geometry first"});
}

TEST_F(Geometry, MaterialDestroyedBeforeItsMesh) {
    auto short_lived = std::make_unique<THREE::MeshBasicMaterial>();
    mesh.material = *short_lived;
    EXPECT_EQ(refusal(scene), "");
    short_lived.reset();
    expectRefusal({"material was destroyed", "declare the material first"});
}

TEST_F(Geometry, ThatIsSharedLivesAsLongAsItsMesh) {
    auto shared = std::make_shared<THREE::BoxGeometry>();
    mesh.geometry = THREE::Handle<THREE::BufferGeometry>(shared);
    shared.reset();
    EXPECT_EQ(refusal(scene), "");
}

TEST_F(Geometry, EveryBuiltInShapePasses) {
    const THREE::BoxGeometry box;
    const THREE::SphereGeometry sphere;
    const THREE::PlaneGeometry plane;
    const THREE::TorusGeometry torus;
    const THREE::TorusKnotGeometry knot;
    const THREE::CylinderGeometry cylinder;
    for (const THREE::BufferGeometry* shape :
         {static_cast<const THREE::BufferGeometry*>(&box), static_cast<const THREE::BufferGeometry*>(&sphere),
          static_cast<const THREE::BufferGeometry*>(&plane),
          static_cast<const THREE::BufferGeometry*>(&torus), static_cast<const THREE::BufferGeometry*>(&knot),
          static_cast<const THREE::BufferGeometry*>(&cylinder)}) {
        geometry.attributes = shape->attributes;
        geometry.setIndex(shape->index);
        EXPECT_EQ(refusal(scene), "") << shape->type();
        EXPECT_GT(geometry.vertexCount(), 0u) << shape->type();
    }
}

}  // namespace
