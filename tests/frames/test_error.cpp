// The error of a frame, measured from end to end: the graphics driver in float against the reference in double.
// SPDX-License-Identifier: MIT
#include "support/judge.hpp"
#include "support/program.hpp"
#include "support/stage.hpp"
#include "three/object_loader.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace {

using support::DrawOptions;
using support::judge;
using support::Judgement;
using support::Stage;
using THREE::Vector3;

// Every gate is 4 times the figure measured on Mesa 22.3.6 llvmpipe, which stands beside it; errors are relative to S
// (support/judge.hpp).
void expectWithin(const Judgement& j, double measured, double mostMasked) {
    EXPECT_LE(j.worst, 4 * measured) << describe(j);
    EXPECT_LE(j.codes, 1) << describe(j);
    EXPECT_LE(j.maskedShare(), mostMasked) << describe(j);
}
void expectWithin(const Judgement& j, double measured, double mostMasked, const std::string& what) {
    SCOPED_TRACE(what);
    expectWithin(j, measured, mostMasked);
    std::cout << what << ": " << describe(j) << '\n';
}

// ---- every lesson, every single term off, three cameras of different sizes

class EachLesson : public testing::TestWithParam<const char*> {};

TEST_P(EachLesson, EveryTermOffFromSeveralCameras) {
    const support::TemporaryDirectory directory;
    const support::Outcome dumped =
        support::run({GetParam(), "--dump-scene", "scene.json", "--time", "0.7"}, directory.path());
    ASSERT_EQ(dumped.status, 0) << dumped.err;
    THREE::LoadedScene loaded = THREE::ObjectLoader().load(directory.file("scene.json"));
    const struct {
        Vector3 eye;
        int width, height;
    } views[] = {{loaded.camera->position, 128, 128}, {{-3, 0.8, 4}, 200, 90}, {{0.5, 7, -2}, 61, 97}};
    Judgement worst;
    for (const auto& view : views)
        for (int off = -1; off < lighting::termCount; ++off) {
            DrawOptions options;
            options.width = view.width;
            options.height = view.height;
            if (off >= 0)
                options.settings.terms = lighting::TermSet::all().without(static_cast<lighting::Term>(off));
            loaded.camera->position = view.eye;
            support::lookAt(*loaded.camera, {0, 1.2, 0}, options);
            const Judgement j = judge(*loaded.scene, *loaded.camera, options);
            SCOPED_TRACE(off < 0 ? "all terms"
                                 : "without " +
                                       std::string(lighting::terms()[static_cast<std::size_t>(off)].name));
            expectWithin(j, 1.2e-5, 0.25);
            if (j.worst >= worst.worst)
                worst = j;
        }
    std::cout << "the worst of 30: " << describe(worst) << '\n';
}

INSTANTIATE_TEST_SUITE_P(Chain, EachLesson,
                         testing::Values("lesson_00_scene", "lesson_01_material",
                                         "lesson_02_directional_light", "lesson_03_point_light",
                                         "lesson_04_ambient", "lesson_05_attenuation",
                                         "lesson_06_many_lights", "lesson_07_normal_space",
                                         "lesson_08_shading_frequency", "lesson_09_phong"),
                         [](const auto& test) { return std::string(test.param); });

// ---- scenes of every kind

Judgement judged(Stage& stage) {
    stage.place();
    return judge(stage.scene, stage.camera, stage.options);
}

TEST(Error, EveryExponentAndWindow) {
    for (const double k : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0})
        for (const double distance : {0.0, 4.0}) {
            Stage stage;
            stage.bulb({2, 2.5, 2}, 4, k, distance);
            expectWithin(judged(stage), 2.4e-5, 0.3, "k = " + std::to_string(k));
        }
}

TEST(Error, ManyLights) {
    for (const int count : {1, 8, 64, 192}) {
        Stage stage;
        for (int i = 0; i < count; ++i)
            stage.bulb({4 * std::cos(i * 2.4), 2 + std::sin(i * 0.7), 4 * std::sin(i * 2.4)}, 4.0 / count,
                       i % 3);
        expectWithin(judged(stage), 9.5e-6, 0.3, std::to_string(count) + " lights");
    }
}

TEST(Error, NonUniformAndMirroredScales) {
    for (const Vector3& scale :
         {Vector3(1, 0.3, 2), Vector3(-1, 1, 1), Vector3(-0.5, 2, -1.5), Vector3(1, 1, -3)}) {
        Stage stage;
        stage.bulb({2, 2.5, 2}, 4, 2);
        stage.all.scale = scale;
        stage.all.rotation.set(0.2, 0.4, -0.1);
        stage.knot.scale.set(1, 0.6, 1.3);
        expectWithin(judged(stage), 5.8e-5, 0.3, "scale");
    }
}

TEST(Error, FarFromTheOrigin) {
    for (const double offset : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8}) {
        Stage stage;
        stage.bulb({2, 2.5, 2}, 4, 2);
        stage.all.position.set(offset, -0.3 * offset, 0.7 * offset);
        expectWithin(judged(stage), 1.9e-5, 0.3, "offset " + std::to_string(offset));
    }
}

TEST(Error, SmallAndLarge) {
    for (const double size : {1e-20, 1e-12, 1e-6, 1e6, 1e12, 1e20}) {
        Stage stage;
        stage.bulb({2, 2.5, 2}, 4, 1);
        stage.all.scale.setScalar(size);
        stage.camera.near *= size;
        stage.camera.far *= size;
        stage.bulbs[0]->intensity *= size;
        expectWithin(judged(stage), 2.3e-5, 0.3, "size " + std::to_string(size));
    }
}

TEST(Error, GrazingLight) {
    for (const double height : {1e-1, 1e-3, 1e-6}) {
        Stage stage;
        stage.ambient.intensity = 0;
        stage.sun.position.set(1, height, 0.3);
        stage.bulb({3, height, 0}, 1, 0);
        expectWithin(judged(stage), 7.4e-6, 0.3, "height " + std::to_string(height));
    }
}

TEST(Error, ALightCloseToASurface) {
    for (const double height : {0.3, 0.05, 0.01}) {
        Stage stage;
        stage.bulb({1.5, height, 2}, height * height, 2);
        expectWithin(judged(stage), 9.1e-6, 0.3, "height " + std::to_string(height));
    }
}

TEST(Error, HighlightsOfBothModels) {
    for (const auto model : {THREE::SpecularModel::phong, THREE::SpecularModel::blinn})
        for (const double shininess : {0.0, 1.0, 5.0, 30.0, 200.0, 1000.0}) {
            Stage stage;
            stage.bulb({2, 2.5, 2}, 4, 2);
            stage.orange.specular.set(0xCCEEFF);
            stage.orange.shininess = shininess;
            stage.orange.specularModel = model;
            expectWithin(judged(stage), 6.3e-5, 0.3,
                         (model == THREE::SpecularModel::phong ? "phong " : "blinn ") +
                             std::to_string(shininess));
        }
}

TEST(Error, EverySwitch) {
    using namespace lighting;
    for (const Shading shading : {Shading::pixel, Shading::vertex, Shading::flat})
        for (const Space space : {Space::world, Space::view})
            for (const NormalTransform normals :
                 {NormalTransform::inverseTranspose, NormalTransform::model}) {
                Stage stage;
                stage.bulb({2, 2.5, 2}, 4, 1);
                stage.orange.specular.set(0x888888);
                stage.orange.side = THREE::DoubleSide;
                stage.green.side = THREE::BackSide;
                stage.all.scale.set(1.2, 0.8, -1);
                stage.options.settings.shading = shading;
                stage.options.settings.space = space;
                stage.options.settings.normals = normals;
                expectWithin(judged(stage), 2.1e-5, 0.75,
                             "shading " + std::to_string(static_cast<int>(shading)) + ", space " +
                                 std::to_string(static_cast<int>(space)) + ", normals " +
                                 std::to_string(static_cast<int>(normals)));
            }
}

TEST(Error, SidesFlatShadingAndEmission) {
    for (const THREE::Side side : {THREE::FrontSide, THREE::BackSide, THREE::DoubleSide})
        for (const bool flat : {false, true}) {
            Stage stage;
            stage.bulb({2, 2.5, 2}, 4, 2);
            stage.orange.side = stage.green.side = side;
            stage.orange.flatShading = flat;
            stage.green.emissive.set(0x102030);
            expectWithin(judged(stage), 1.9e-5, 0.75, "side " + std::to_string(side) + (flat ? " flat" : ""));
        }
}

}  // namespace
