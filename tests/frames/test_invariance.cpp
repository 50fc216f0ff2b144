// Frames that must not change, whatever else does: far from the origin, scaled, mirrored, with nothing skipped.
// SPDX-License-Identifier: MIT
#include "support/draw.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using support::DrawOptions;

// A posed knot above a floor under the lecture's lights, at a place, in a size.
struct Lecture {
    THREE::Scene scene;
    THREE::Group all;
    THREE::TorusKnotGeometry knotGeometry{1, 0.35, 120, 24};
    THREE::MeshLambertMaterial orange{THREE::Color(0xFF8855)};
    THREE::Mesh knot{knotGeometry, orange};
    THREE::PlaneGeometry floorGeometry{8, 8};
    THREE::MeshLambertMaterial blue{THREE::Color(0x7788AA)};
    THREE::Mesh floor{floorGeometry, blue};
    THREE::DirectionalLight sun;
    THREE::PointLight bulb{THREE::Color(0xDD6666)};
    THREE::AmbientLight ambient{THREE::Color(0x101010)};
    THREE::PerspectiveCamera camera{40, 1, 0.1, 100};
    DrawOptions options;

    explicit Lecture(const THREE::Vector3& offset = {}, double size = 1) {
        scene.background = THREE::Color(0x203040);
        scene.add(all, sun, ambient);
        all.add(knot, floor, bulb);
        all.position = offset;
        all.scale.setScalar(size);
        knot.position.set(0, 1.6, 0);
        knot.rotation.set(0.5, 0.3, 0.2);
        knot.scale.set(1, 0.8, 1.1);
        floor.rotation.x = -std::acos(0.0);
        sun.position.set(0, 3, -2);
        bulb.position.set(2, 1.5, 5);
        const THREE::Vector3 target = THREE::Vector3(0, 1.25, 0).multiplyScalar(size).add(offset);
        camera.position = THREE::Vector3(2, 2.5, 6).multiplyScalar(size).add(offset);
        camera.near *= size;
        camera.far *= size;
        camera.lookAt(target);
        options.width = options.height = 160;
        options.settings.focus = target;
        options.settings.focusDistance = THREE::Vector3(2, 1.25, 6).length() * size;
    }
    support::Drawn draw() { return support::draw(scene, camera, options); }
};

// Largest difference, in 8-bit codes.
double codes(const support::Drawn& a, const support::Drawn& b) {
    return support::largestDifference(a, b) * 255;
}

// The share of values that differ by more than `bound` codes: where an edge falls on another pixel.
double shareAbove(double bound, const support::Drawn& a, const support::Drawn& b) {
    double count = 0;
    for (std::size_t i = 0; i < a.floats().size(); ++i)
        count += std::abs(static_cast<double>(a.floats()[i]) - b.floats()[i]) * 255 > bound ? 1 : 0;
    return count / static_cast<double>(a.floats().size());
}

TEST(Invariance, TheSceneShowsSomething) {
    Lecture here;
    const support::Drawn drawn = here.draw();
    EXPECT_EQ(drawn.stats.meshesDrawn, 2);
    EXPECT_GT(codes(drawn,
                    [&] {
                        here.sun.intensity = 0.5;
                        return here.draw();
                    }()),
              20);
}

// Offsets that the grid divides leave the same bytes: every number that reaches the GPU is the same.
TEST(Invariance, FarFromTheOriginTheSameBytes) {
    Lecture here;
    const support::Drawn expected = here.draw();
    for (const double offset : {0x1p14, 0x1p20, 0x1p27}) {
        Lecture far({offset, -offset, 2 * offset});
        EXPECT_EQ(codes(expected, far.draw()), 0) << "offset " << offset;
    }
}

// Other offsets round the scene's own doubles first (1e8: 1.5e-8), no more than that: accuracy.md, row C7.
TEST(Invariance, FarFromTheOriginTheSamePicture) {
    Lecture here;
    const support::Drawn expected = here.draw();
    for (const double offset : {1e3, 1e5, 1e7, 1e8}) {
        Lecture far({offset, 0.3 * offset, -offset});
        const support::Drawn found = far.draw();
        EXPECT_LT(shareAbove(1e-3, expected, found), 1e-3) << "offset " << offset;
    }
}

TEST(Invariance, ScaledByAPowerOfTwoTheSameBytes) {
    Lecture here;
    const support::Drawn expected = here.draw();
    for (const double size : {0x1p-40, 0x1p-10, 0x1p10, 0x1p40, 0x1p50}) {
        Lecture scaled({}, size);
        EXPECT_EQ(codes(expected, scaled.draw()), 0) << "scale " << size;
    }
}

TEST(Invariance, NothingSkippedTheSameBytes) {
    Lecture here;
    THREE::PointLight dead(THREE::Color(0xFFFFFF), 0, 0, 2);
    THREE::PointLight black(THREE::Color(0x000000), 5, 0, 1.3);
    THREE::Mesh behind(here.knotGeometry, here.orange);
    behind.position.set(0, 0, 40);
    here.scene.add(dead, black, behind);
    here.draw();  // uploads what the next frame finds there
    const support::Drawn skipped = here.draw();
    here.options.settings.skip = false;
    const support::Drawn all = here.draw();
    EXPECT_EQ(codes(skipped, all), 0);
    EXPECT_EQ(skipped.plan.lightsSkipped, 2);
    EXPECT_EQ(skipped.plan.meshesSkipped, 1);
    EXPECT_EQ(all.plan.lightsSkipped, 0);
    EXPECT_EQ(all.plan.meshesSkipped, 0);
    EXPECT_EQ(all.stats.drawCalls, 3);
    EXPECT_EQ(skipped.stats.drawCalls, 2);
    EXPECT_EQ(skipped.stats.uploadedBytes, 0U) << "nothing is uploaded twice";
    EXPECT_GT(all.stats.uploadedBytes, 100'000U);
}

// Each term off, skipped or kept in the shader, is the same picture; and each that can matter changes it.
TEST(Invariance, EveryTermOffSkippedOrNot) {
    Lecture here;
    const support::Drawn whole = here.draw();
    for (const lighting::TermInfo& row : lighting::terms()) {
        here.options.settings.terms = lighting::TermSet::all().without(row.term);
        here.options.settings.skip = true;
        const support::Drawn skipped = here.draw();
        here.options.settings.skip = false;
        EXPECT_EQ(codes(skipped, here.draw()), 0) << row.name;
        const bool idle = lighting::idleReason(row.term, whole.plan).en != nullptr;
        EXPECT_EQ(codes(skipped, whole) == 0, idle) << row.name << " off";
    }
}

TEST(Invariance, DirectionalPointAndAmbientOffIsBlack) {
    Lecture here;
    here.scene.background = THREE::Color(0x000000);
    here.options.settings.terms =
        lighting::parseTerms("-directional,-point,-ambient", lighting::TermSet::all());
    const support::Drawn dark = here.draw();
    for (const float value : dark.floats())
        ASSERT_EQ(value, 0.0F);
}

// A mirrored knot in a mirrored world is the picture mirrored: normals point outwards, front faces stay in front.
TEST(Invariance, AMirroredWorldIsTheMirroredPicture) {
    Lecture here;
    Lecture mirrored;
    here.camera.position.set(0, 2.5, 6);
    here.camera.lookAt(0, 1.25, 0);
    mirrored.camera.position.set(0, 2.5, 6);
    mirrored.camera.lookAt(0, 1.25, 0);
    mirrored.all.scale.x = -1;
    const support::Drawn a = here.draw();
    const support::Drawn b = mirrored.draw();
    int different = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x)
            for (int c = 0; c < 3; ++c)
                different += std::abs(a.at(x, y)[c] - b.at(159 - x, y)[c]) * 255 > 0.01 ? 1 : 0;
    EXPECT_LT(different, 160) << "only where an edge runs exactly through a pixel's centre";
}

TEST(Invariance, BothSidesAndFlatShading) {
    Lecture here;
    here.orange.side = THREE::BackSide;
    const support::Drawn back = here.draw();
    here.orange.side = THREE::FrontSide;
    const support::Drawn front = here.draw();
    here.orange.side = THREE::DoubleSide;
    const support::Drawn both = here.draw();
    EXPECT_GT(codes(back, front), 5);
    EXPECT_LT(shareAbove(0.01, both, front), 1e-3) << "of a closed mesh one sees only the front";
    here.orange.flatShading = true;
    const support::Drawn flat = here.draw();
    const double share = shareAbove(1, flat, both);
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.9);
}

}  // namespace
