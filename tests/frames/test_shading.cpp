// The bound that is promised for the shading from the interpolated position and normal (design: (18 + N) u S), everywhere.
// SPDX-License-Identifier: MIT
#include "support/shading.hpp"
#include "support/stage.hpp"

#include <gtest/gtest.h>

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

// A test of the test: what is measured is the rounding of floats, neither nothing nor something larger.
TEST(Shading, TheErrorIsThatOfFloats) {
    Stage stage;
    stage.bulb({2, 2.5, 2}, 4, 2);
    const double honest = expectBounded(stage, "honest");
    EXPECT_GT(honest, 0.5) << "float arithmetic rounds";
    EXPECT_LT(honest, 18) << "and not much";
}

}  // namespace
