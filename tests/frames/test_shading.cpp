// The bound that is promised for the shading from the interpolated position and normal (design: (18 + N) u S), everywhere.
// SPDX-License-Identifier: MIT
#include "support/shading.hpp"
#include "support/stage.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using support::Stage;
using THREE::Vector3;

// Without exception: every channel of every pixel. Returns the worst, in u S.
double expectBounded(Stage& stage, const std::string& what) {
    stage.scene.background = THREE::Color(0x000000);
    stage.place();
    const support::ShadingError e = support::shadingError(stage.scene, stage.camera, stage.options);
    EXPECT_GT(e.pixels, 4000);
    EXPECT_LE(e.worst, e.bound) << what << ", at " << e.x << ',' << e.y;
    std::cout << what << ": worst " << e.worst << " u S, bound " << e.bound << '\n';
    return e.worst;
}

TEST(Shading, EveryExponent) {
    for (const double k : {0.0, 1.0, 2.0, 0.5, 1.5, 1.9, 3.0}) {
        Stage stage;
        stage.bulb({2, 2.5, 2}, 4, k);
        stage.bulb({-1.5, 0.4, 1}, 0.7, k);
        expectBounded(stage, "k = " + std::to_string(k));
    }
}

TEST(Shading, ManyLights) {
    for (const int count : {1, 8, 64, 192, 600}) {
        Stage stage;
        for (int i = 0; i < count; ++i)
            stage.bulb({4 * std::cos(i * 2.4), 2 + std::sin(i * 0.7), 4 * std::sin(i * 2.4)}, 4.0 / count,
                       i % 3);
        expectBounded(stage, std::to_string(count) + " lights");
    }
}

TEST(Shading, GrazingAndClose) {
    for (const double height : {1.0, 1e-1, 1e-2, 1e-4, 1e-7}) {
        Stage stage;
        stage.sun.position.set(1, height, 0.3);
        stage.bulb({1.5, height, 2}, 1, 2);
        stage.bulb({3, height, 0}, 1, 0);
        expectBounded(stage, "height " + std::to_string(height));
    }
}

TEST(Shading, FarSmallLargeAndScaled) {
    for (const double size : {1e-25, 1e-9, 1.0, 1e9, 1e17}) {
        Stage stage;
        stage.bulb({2, 2.5, 2}, 4 * size * size, 2);
        stage.bulb({2, 4, -2}, 1, 0);
        stage.all.scale.setScalar(size);
        stage.camera.near *= size;
        stage.camera.far *= size;
        stage.all.position.set(1e5 * size, 0, -1e5 * size);
        expectBounded(stage, "size " + std::to_string(size));
    }
    // The scaled form of the shader, by lights as far away as floats reach and strengths to match.
    for (const double distance : {1e14, 1e18, 1e25}) {
        Stage stage;
        stage.bulb({distance, distance, 0.3 * distance}, 1, 0);
        stage.bulb({-distance, distance, 0}, distance, 1);
        stage.bulb({0, distance, distance}, std::min(distance * distance, 1e36), 2);
        stage.place();
        expectBounded(stage, "distance " + std::to_string(distance));
    }
}

TEST(Shading, EveryTermOff) {
    for (const lighting::TermInfo& row : lighting::terms()) {
        Stage stage;
        stage.bulb({2, 2.5, 2}, 4, 2);
        stage.options.settings.terms = lighting::TermSet::all().without(row.term);
        expectBounded(stage, std::string("without ") + row.name);
    }
}

// The stage in three glossy materials, K_S for each of its own, under a sun and two bulbs.
struct GlossyStage : Stage {
    THREE::MeshPhongMaterial glossyOrange{THREE::Color(0xFF8855)}, glossyGreen{THREE::Color(0x66AA77)},
        glossyBlue{THREE::Color(0x7788AA)};

    GlossyStage(THREE::SpecularModel model, double shininess) {
        knot.material = glossyOrange;
        box.material = glossyGreen;
        floor.material = glossyBlue;
        glossyOrange.specular.set(0x808080);
        glossyGreen.specular.set(0xFFFFFF);
        glossyBlue.specular.set(0x111111);
        for (THREE::MeshPhongMaterial* material : {&glossyOrange, &glossyGreen, &glossyBlue}) {
            material->shininess = shininess;
            material->specularModel = model;
        }
        bulb({2, 2.5, 2}, 4, 2);
        bulb({-1.5, 3, 4}, 0.7, 0);
    }
};

// A turned ball seen through a long lens, so that the highlights of two lights, one upon the other, cover the picture.
struct CloseUp {
    THREE::Scene scene;
    THREE::SphereGeometry geometry{1, 48, 32};
    THREE::MeshPhongMaterial material{THREE::Color(0x000000)};
    THREE::Mesh ball{geometry, material};
    THREE::DirectionalLight sun{THREE::Color(0xFFEEDD), 0.5};
    THREE::PointLight bulb{THREE::Color(0xDD6666)};
    THREE::PerspectiveCamera camera{40, 1, 0.1, 100};
    support::DrawOptions options;

    // `degrees`: from the normal to the lights and to the eye.
    CloseUp(THREE::SpecularModel model, double shininess, double degrees, double away) {
        scene.add(ball, sun, bulb);
        ball.rotation.set(0.5, 0.3, 0.2);
        material.specular.set(0x80FF40);
        material.shininess = shininess;
        material.specularModel = model;
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, 0.8, 0.5)),
                         across = glm::normalize(glm::cross(n, glm::dvec3(0.9, -0.1, 0.4)));
        const double angle = degrees / 180 * std::numbers::pi;
        const glm::dvec3 towardsEye = std::cos(angle) * n + std::sin(angle) * across;
        const glm::dvec3 towardsLight = std::cos(angle) * n - std::sin(angle) * across;
        camera.position = n + 5.0 * towardsEye;
        camera.fov = std::min(20.0, 300 / std::sqrt(shininess + 1));
        sun.position = towardsLight;
        bulb.position = n + away * towardsLight;
        bulb.decay = away > 1e9 ? 0 : 2;
        bulb.intensity = away > 1e9 ? 1 : away * away;
        options.width = options.height = 128;
        support::lookAt(camera, n, options);
    }
};

// Rounding turns R and h by a few u, and where (R . v)^s is steepest that is sqrt(s) times as much: highlights have no single
// bound. The gates are 4 times the figures measured on Mesa 22.3.6 llvmpipe, in u S.
struct MeasuredHighlight {
    double shininess, phong, blinn;
};
constexpr MeasuredHighlight measuredHighlights[] = {{0, 3.5, 7.6},   {1, 7.3, 6.7},     {5, 8.9, 5.9},
                                                    {30, 15.6, 7.3}, {200, 28.4, 12.4}, {1000, 49.7, 20.3},
                                                    {1e5, 808, 229}};

// The worst of all views.
double worstHighlight(THREE::SpecularModel model, double shininess) {
    double worst = 0;
    for (const double away : {3.0, 1e25})  // the second in the scaled form of the shader
        for (const double degrees : {0.0, 20.0, 45.0, 70.0, 85.0}) {
            CloseUp closeUp(model, shininess, degrees, away);
            const support::ShadingError e =
                support::shadingError(closeUp.scene, closeUp.camera, closeUp.options);
            EXPECT_GT(e.pixels, 4000);
            worst = std::max(worst, e.worst);
        }
    for (const lighting::Space space : {lighting::Space::world, lighting::Space::view}) {
        GlossyStage stage(model, shininess);
        stage.scene.background = THREE::Color(0x000000);
        stage.options.settings.space = space;
        stage.place();
        worst = std::max(worst, support::shadingError(stage.scene, stage.camera, stage.options).worst);
    }
    return worst;
}

TEST(Shading, Highlights) {
    for (const MeasuredHighlight& row : measuredHighlights) {
        const double phong = worstHighlight(THREE::SpecularModel::phong, row.shininess);
        const double blinn = worstHighlight(THREE::SpecularModel::blinn, row.shininess);
        EXPECT_LE(phong, 4 * row.phong) << "s = " << row.shininess;
        EXPECT_LE(blinn, 4 * row.blinn) << "s = " << row.shininess;
        std::cout << "s = " << row.shininess << ": worst " << phong << " u S (phong), " << blinn
                  << " (blinn)\n";
    }
}

// A test of the test: what is measured is the rounding of floats, neither nothing nor something larger.
TEST(Shading, TheErrorIsThatOfFloats) {
    Stage stage;
    stage.bulb({2, 2.5, 2}, 4, 2);
    const double honest = expectBounded(stage, "honest");
    EXPECT_GT(honest, 0.5) << "float arithmetic rounds";
    EXPECT_LT(honest, 18) << "and not much";
}

}  // namespace
