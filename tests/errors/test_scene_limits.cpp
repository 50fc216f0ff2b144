// What a scene file may ask for: no more than fits a machine, and nothing that cannot be written and read again.
// SPDX-License-Identifier: MIT
#include "three/lights.hpp"
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <gtest/gtest.h>

namespace {

std::string refusal(const std::string& json) {
    try {
        THREE::ObjectLoader().parse(json, "scene.json");
    } catch (const THREE::SceneError& error) {
        return error.what();
    }
    return "";
}

std::string child(const std::string& fields) {
    return R"({"object":{"type":"Scene","children":[{"type":"Group",)" + fields + "}]}}";
}

// `levels` objects, one below the other; the last one is `innermost`.
std::string nested(const std::string& outermost, int levels, const std::string& innermost) {
    std::string before = R"({"type":")" + outermost + R"(","children":[)";
    std::string after = "]}";
    for (int i = 2; i < levels; ++i) {
        before += R"({"type":"Group","children":[)";
        after += "]}";
    }
    return R"({"object":)" + before + innermost + after + "}";
}

// A few hundred bytes could otherwise ask for gigabytes. Geometries that are then refused have cost as much.
TEST(SceneLimits, CountTheVerticesOfAllParametricGeometries) {
    const auto plane = [](const std::string& fields) {
        return R"({"type":"PlaneGeometry","widthSegments":1999,"heightSegments":999,)" + fields + "}";
    };
    const std::string two = plane(R"("uuid":"1")") + "," + plane(R"("uuid":"2","drawRange":{"start":3})");
    const std::string object = R"("object":{"type":"Scene"}})";
    EXPECT_EQ(refusal(R"({"geometries":[)" + two + "]," + object), "");
    EXPECT_EQ(
        refusal(R"({"geometries":[)" + two + "," + plane(R"("uuid":"3")") + "]," + object),
        "scene.json: geometries[2]: expected at most 5 million vertices in a file's parametric geometries, "
        "found more; use fewer segments");
}

TEST(SceneLimits, RefuseAPlaceWhoseMatrixIsTooLarge) {
    for (const char* const fields :
         {R"("scale":[1e30,1,1],"quaternion":[0,1e5,0,1])", R"("scale":[1e36,1,1],"quaternion":[0,10,0,1])",
          R"("visible":false,"matrix":[1e36,1e36,0,0,0,1,0,0,0,0,1,0,0,0,0,1])"})
        EXPECT_EQ(
            refusal(child(fields)),
            "scene.json: object.children[0]: expected a place whose matrix and scale are numbers of at most "
            "1e36, found larger ones; scale the scene down");
    EXPECT_EQ(refusal(child(R"("scale":[1e36,1,1],"position":[-1e36,0,0])")), "");
}

TEST(SceneLimits, LetTheDeepestSceneBeReadAgain) {
    for (const auto& [outermost, levels] : {std::pair{"Scene", 257}, std::pair{"Group", 256}}) {
        const THREE::LoadedScene deepest =
            THREE::ObjectLoader().parse(nested(outermost, levels, R"({"type":"PointLight"})"), "scene.json");
        EXPECT_EQ(refusal(toJSON(*deepest.scene)), "");
        EXPECT_NE(refusal(nested(outermost, levels + 1, R"({"type":"PointLight"})")), "");
    }
    // A light's target that is another object hangs below it, one level deeper.
    const std::string light = R"({"type":"DirectionalLight","uuid":"l","target":"l"})";
    EXPECT_NE(refusal(nested("Scene", 257, light))
                  .find("target: expected the uuid of an object at most 255 levels"),
              std::string::npos);
    const THREE::LoadedScene deep = THREE::ObjectLoader().parse(nested("Scene", 256, light), "scene.json");
    EXPECT_EQ(refusal(toJSON(*deep.scene)), "");
}

// The fuzzer's finding: of two lights that aim at one object, the first one's target became that object.
TEST(SceneLimits, WriteTheSameTextAgain) {
    const std::string light = R"({"type":"DirectionalLight","position":[1,2,3],"target":"t"})";
    const THREE::LoadedScene first =
        THREE::ObjectLoader().parse(R"({"object":{"type":"Scene","children":[)" + light + "," + light +
                                        R"(,{"type":"Object3D","uuid":"t","position":[0,1,0]}]}})",
                                    "scene.json");
    const std::string text = toJSON(*first.scene);
    const THREE::LoadedScene second = THREE::ObjectLoader().parse(text, "scene.json");
    EXPECT_EQ(toJSON(*second.scene), text);
    for (const std::size_t i : {0U, 1U}) {
        const auto& read = dynamic_cast<const THREE::DirectionalLight&>(*second.scene->children().at(i));
        EXPECT_EQ(read.target.parent(), second.scene->children().at(2));
        EXPECT_LT(read.directionTowardsLight().distanceTo(THREE::Vector3(1, 1, 3).normalize()), 1e-15);
    }
}

}  // namespace
