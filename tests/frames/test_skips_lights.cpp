// Lights as constants of a shader, as uniforms and in a texture: the same bytes, also while some of them move.
// SPDX-License-Identifier: MIT
#include "support/both_ways.hpp"
#include "support/stage.hpp"

#include <gtest/gtest.h>

namespace {

using lighting::LightStorage;

// A knot and a floor under many lamps, in a small picture.
struct Lamps : testing::Test, support::Stage {
    Lamps() {
        all.remove(box);
        options.width = 44;
        options.height = 36;
        orange.specular.set(0x282828);
        place();
    }
    // Lamps of all exponents around the stage; those in odd places of the list end somewhere if `windows`.
    void addLamps(int count, bool windows) {
        static constexpr double exponents[] = {0, 1, 2, 0.5, 1.5, 3, 4, 8, 2, 1, 0, 6};
        for (int i = 0; i < count; ++i) {
            THREE::PointLight& lamp = bulb({4 * std::cos(2.4 * i), 0.5 + 0.05 * i, 4 * std::sin(2.4 * i)},
                                           3.0 / count, exponents[i % 12], windows ? 2.0 + 0.3 * i : 0);
            lamp.color = THREE::Color(1, i % 3 * 0.5, i % 4 == 0 ? 0 : 0.7);
        }
    }
    support::Frames draw(int constantLights, int uniformLights) {
        support::makeReady(scene, camera, options);
        options.settings.constantLights = constantLights;
        options.settings.uniformLights = uniformLights;
        const auto fresh = support::freshRenderer();
        const lighting::FramePlan plan = lighting::planFrame(scene, camera, options.settings);
        for (int i = 0; i < 20 && plan.point.size() >= 64;
             ++i)  // so many are compiled in when they have lasted
            fresh->render(plan, options.settings, {8, 8, false});
        return support::drawFrames(plan, options, *fresh);
    }
    // All three forms of the lights, as they are now.
    void expectTheSame() {
        const support::Frames constants = draw(1000, 1000), uniforms = draw(0, 1000), texture = draw(0, 0);
        const auto storage = [](const support::Frames& f) { return f.stats.variants.begin()->storage; };
        EXPECT_EQ(storage(constants), LightStorage::constants);
        EXPECT_EQ(storage(uniforms), LightStorage::uniforms);
        EXPECT_EQ(storage(texture), LightStorage::texture);
        EXPECT_EQ(support::difference(constants, uniforms), "");
        EXPECT_EQ(support::difference(uniforms, texture), "");
    }
};

TEST_F(Lamps, AnyNumberOfThem) {
    for (const int count : {1, 3, 16, 63, 64}) {
        SCOPED_TRACE(count);
        addLamps(count, false);
        expectTheSame();
        const LightStorage byDefault =
            draw(64, 256).stats.variants.begin()->storage;  // with the sun, 64 are 65
        EXPECT_EQ(byDefault, count < 64 ? LightStorage::constants : LightStorage::uniforms);
        bulbs.clear();
    }
}

TEST_F(Lamps, InEveryKindOfShader) {
    addLamps(12, true);
    sun.visible = false;  // so that all end: clusters keep their order
    for (const auto model : {THREE::SpecularModel::phong, THREE::SpecularModel::blinn})
        for (const auto shading :
             {lighting::Shading::pixel, lighting::Shading::vertex, lighting::Shading::flat})
            for (const auto space : {lighting::Space::world, lighting::Space::view}) {
                SCOPED_TRACE(testing::Message() << "model " << static_cast<int>(model) << ", shading "
                                                << static_cast<int>(shading));
                orange.specularModel = model;
                options.settings.shading = shading;
                options.settings.space = space;
                expectTheSame();
            }
}

TEST_F(Lamps, WhereNumbersAreScaled) {
    addLamps(12, false);
    bulbs[3]->position.set(1e14, 2e14, 1e14);
    bulbs[4]->position.set(1e25, 0, -1e24);
    bulbs[6]->intensity = 1e33;
    expectTheSame();
    EXPECT_TRUE(draw(64, 256).stats.variants.begin()->scaled);
}

// Compilers know pow(x, 2) and pow(x, 4) to be products, x * 0 to be 0 and x * 1 to be x.
TEST_F(Lamps, NumbersThatCompilersKnow) {
    for (const double k : {3.0, 4.0, 8.0, 0.5, 1e-30, 2.0 + 1e-9, 1 - 1e-9})
        for (const double distance : {0.0, 8.0}) {
            SCOPED_TRACE(testing::Message() << "k " << k << ", distance " << distance);
            bulb({0, 4, 0}, 1, k, distance).color = THREE::Color(0, 1, 0.5);
            bulb({4, 0, 0}, 2, k, distance).color = THREE::Color(1, 0, 0);
            bulb({0, 0, 4}, 0.5, k, distance).color = THREE::Color(1e-42, 2, 1);
            sun.visible = distance == 0;
            expectTheSame();
            bulbs.clear();
        }
}

// One lamp among others that stand still.
struct MovingLamp : Lamps {
    std::unique_ptr<render::GlRenderer> watched = support::freshRenderer();
    double compiled = 0;  // milliseconds

    MovingLamp() { addLamps(5, false); }
    // Draws a frame, compares it with a renderer that has seen none before, and returns its variant.
    lighting::Variant frame() {
        support::makeReady(scene, camera, options);
        const render::FrameRequest request{options.width, options.height, true};
        const image::Frame found = watched->render(scene, camera, options.settings, request);
        const lighting::Variant variant = *watched->stats().variants.begin();
        lighting::Settings plain = options.settings;
        plain.constantLights = 0;
        EXPECT_EQ(support::difference(found, support::renderer().render(scene, camera, plain, request)), "");
        return variant;
    }
    // Whether the last frame compiled anything.
    bool compiledMore() {
        const double before = compiled;
        compiled = watched->stats().compileMilliseconds;
        return compiled != before;
    }
    void move(int t) { bulbs[2]->position.set(3 * std::cos(0.1 * t), 2, 3 * std::sin(0.1 * t)); }
};

TEST_F(MovingLamp, LeavesTheConstantsAndComesBack) {
    EXPECT_EQ(frame().storage, LightStorage::constants) << "what has not been seen to move stands still";
    frame();
    EXPECT_EQ(watched->stats().uploadedBytes, 0U);
    compiledMore();
    int changes = 0, compilations = 0;
    LightStorage last = LightStorage::constants;
    for (int t = 1; t <= 60; ++t) {
        move(t);
        const LightStorage now = frame().storage;
        changes += now != last ? 1 : 0;
        compilations += compiledMore() ? 1 : 0;
        last = now;
        if (t == 1) {
            EXPECT_EQ(now, LightStorage::uniforms) << "at once, with shaders that serve wherever it goes";
        }
        if (t > 20) {
            EXPECT_EQ(now, LightStorage::constants) << "those that stand still";
            EXPECT_LE(watched->stats().uploadedBytes, 2 * 48U) << "one lamp for each of two shaders";
            EXPECT_GE(watched->stats().uploadedBytes, 48U);
        }
    }
    EXPECT_EQ(changes, 2);
    EXPECT_EQ(compilations, 2) << "all uniforms, and one uniform";
    for (int t = 0; t < 60; ++t) {
        last = frame().storage;
        compilations += compiledMore() ? 1 : 0;
    }
    EXPECT_EQ(last, LightStorage::constants);
    EXPECT_EQ(watched->stats().uploadedBytes, 0U) << "all of them";
    EXPECT_EQ(compilations, 3);
    bulbs[2]->color = THREE::Color(0x00FF00);
    EXPECT_EQ(frame().storage, LightStorage::uniforms) << "a colour moves as a place does";
}

// A lamp that flickers, off in every other frame, while another moves: no frame is a new scene.
TEST_F(MovingLamp, BesideOneThatFlickers) {
    int compilations = 0;
    for (int t = 0; t < 60; ++t) {
        move(t);
        bulbs[0]->intensity = t % 2 == 0 ? 0.5 : 0;
        frame();
        compilations += compiledMore() ? 1 : 0;
    }
    EXPECT_LE(compilations, 6);
}

// A lamp that is dragged, let go, and dragged again: what is compiled for each place is forgotten some day.
TEST_F(MovingLamp, AgainAndAgain) {
    int compilations = 0;
    options.width = options.height = 8;
    for (int t = 0; t < 200; ++t) {
        if (t % 45 < 4)
            move(t);
        frame();
        compilations += compiledMore() ? 1 : 0;
    }
    EXPECT_LE(compilations, 2 + 5) << "uniforms once, and each place where it rested";
}

// Another scene is drawn as if it were the first.
TEST_F(MovingLamp, AnotherSceneStandsStill) {
    for (int t = 0; t < 5; ++t) {
        move(t);
        frame();
    }
    bulb({1, 3, 2}, 0.3, 1);
    for (int t = 0; t < 60; ++t)
        frame();
    EXPECT_EQ(frame().storage, LightStorage::constants);
    EXPECT_EQ(watched->stats().uploadedBytes, 0U);
}

}  // namespace
