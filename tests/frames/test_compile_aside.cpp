// A window's renderer, which compiles aside: the same frames, whatever is ready.
// SPDX-License-Identifier: MIT
#include "render/error.hpp"
#include "render/shader_source.hpp"
#include "support/program.hpp"
#include "support/stage.hpp"

#include <filesystem>
#include <gtest/gtest.h>

namespace {

using lighting::LightStorage;

struct CompileAside : testing::Test, support::Stage {
    THREE::PointLight lamp{THREE::Color(0xDD6666), 2, 0, 2}, other{THREE::Color(0x66AADD), 2, 0, 1};
    CompileAside() {
        support::renderer();  // its context is the one that all here share
        lamp.position.set(2, 3, 2);
        other.position.set(-2, 2, 1);
        scene.add(lamp);
        scene.add(other);
        place();
    }
    image::Frame frame(render::GlRenderer& renderer) {
        camera.aspect = 1;
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
        return renderer.render(scene, camera, options.settings, {64, 64, true});
    }
    static LightStorage storage(const render::GlRenderer& renderer) {
        return renderer.stats().variants.begin()->storage;
    }
};

TEST_F(CompileAside, EveryFrameIsWhatItWouldBeAtOnce) {
    render::GlRenderer& atOnce = support::renderer();
    render::GlRenderer aside(render::findShaderDirectory(""), render::Compile::aside);
    for (int i = 0; i < 120; ++i) {
        lamp.position.x = 2 + 0.01 * std::min(i, 60);  // moves, then stands still
        ASSERT_TRUE(frame(aside).pixels == frame(atOnce).pixels) << "frame " << i;
    }
    aside.finishCompiling();
    frame(aside);
    EXPECT_EQ(storage(aside), LightStorage::constants);
    lamp.color.set(0x00FF00);
    frame(aside);
    EXPECT_EQ(storage(aside), LightStorage::uniforms);
}

// Nobody waits for a program that another can stand in for: all that a frame compiles itself is the first one.
TEST_F(CompileAside, OnlyTheFirstFrameCompiles) {
    render::GlRenderer aside(render::findShaderDirectory(""), render::Compile::aside);
    frame(aside);
    const double first = aside.stats().compileMilliseconds;
    EXPECT_GT(first, 0);
    aside.finishCompiling();
    for (int i = 0; i < 120; ++i) {
        lamp.position.x = 2 + 0.01 * std::min(i, 60);
        frame(aside);
        EXPECT_EQ(aside.stats().compileMilliseconds, first) << "frame " << i;
    }
}

// A file that somebody is writing does not end the lecture as long as what is compiled already draws.
TEST_F(CompileAside, ABrokenFileKeepsTheStandIn) {
    const support::TemporaryDirectory directory;
    std::filesystem::create_directory(directory.path() / "terms");
    const std::filesystem::path file = directory.path() / "terms/cosine.glsl";
    std::filesystem::copy(std::filesystem::path(render::findShaderDirectory("")) / "terms/cosine.glsl", file);
    render::GlRenderer aside(directory.path().string(), render::Compile::aside);
    frame(aside);
    aside.finishCompiling();
    support::writeFile(file, "float cosine(vec3 n, vec3 v) { return ;\n");
    for (int i = 0; i < 80; ++i) {
        lamp.position.x = i < 20 ? 2 + 0.01 * i : 2.2;
        ASSERT_NO_THROW(frame(aside)) << "frame " << i;
        aside.finishCompiling();
    }
    EXPECT_EQ(storage(aside), LightStorage::constants) << "it is wanted, though the loop over uniforms draws";
    options.settings.terms = lighting::TermSet::all().without(lighting::Term::albedo);
    EXPECT_THROW(frame(aside), render::ShaderError) << "no program stands in for this one";
}

}  // namespace
