// Pictures of two parts, and the window's picture: drawn when its programs are there, kept as it was when they are not.
// SPDX-License-Identifier: MIT
#include "lighting/views.hpp"
#include "render/compile_aside.hpp"
#include "render/error.hpp"
#include "render/reference_renderer.hpp"
#include "render/shader_source.hpp"
#include "support/both_ways.hpp"
#include "support/program.hpp"
#include "support/stage.hpp"

#include <atomic>
#include <filesystem>
#include <future>
#include <gtest/gtest.h>
#include <thread>

namespace {

using lighting::Term;
using lighting::TermSet;
using lighting::ViewMode;
using render::Part;

constexpr int width = 64, height = 48;

// A scene and two ways to look at it.
struct Look {
    lighting::FramePlan plan;
    lighting::Settings settings;
    Part part(int first, int end) const { return {&plan, &settings, first, end}; }
};

struct Picture : testing::Test, support::Stage {
    Picture() {
        support::renderer();  // its context is the one that all here share
        bulb({2, 3, 2}, 2, 2);
        bulb({-1, 2, 3}, 1, 0, 4);
        orange.specular.set(0x808080);
        options.width = width;
        options.height = height;
        place();
    }
    Look look(const lighting::Settings& changed) {
        support::makeReady(scene, camera, options);
        return {lighting::planFrame(scene, camera, changed), changed};
    }
    Look without(Term term) {
        lighting::Settings settings = options.settings;
        settings.terms = settings.terms.without(term);
        return look(settings);
    }
    static bool drawPicture(render::GlRenderer& renderer, const Look& look, int columns = width) {
        const Part all = look.part(0, columns);
        return renderer.drawPicture({&all, 1}, columns, height);
    }
    static image::Frame atOnce(const Look& look) {
        return support::renderer().render(look.plan, look.settings, {width, height, false});
    }
};

using Parts = Picture;

TEST_F(Parts, HaveTheBytesOfTheTwoPictures) {
    std::vector<Look> looks{look(options.settings), without(Term::clamp), without(Term::point)};
    for (const ViewMode view : {ViewMode::overexposed, ViewMode::bands, ViewMode::red}) {
        lighting::Settings settings = options.settings;
        settings.view = view;
        looks.push_back(look(settings));
    }
    bulbs[0]->position.x = 1.5;  // a light that moved between the two
    scene.background = THREE::Color(0x805030);
    looks.push_back(look(options.settings));
    for (const bool floats : {false, true})
        for (std::size_t i = 0; i < looks.size(); ++i)
            for (const int column : {0, 1, 31, 63, 64}) {
                const render::FrameRequest request{width, height, floats};
                const Look &left = looks[i], &right = looks[(i + 1) % looks.size()];
                const Part parts[] = {left.part(0, column), right.part(column, width)};
                const image::Frame both = support::renderer().render(parts, request);
                const image::Frame expected = render::sideBySide(
                    support::renderer().render(left.plan, left.settings, request),
                    support::renderer().render(right.plan, right.settings, request), column);
                EXPECT_EQ(support::difference(both, expected), "") << i << " split at " << column;
            }
}

TEST_F(Parts, SideBySideTakesColumns) {
    using image::Bytes;
    const image::Frame a{2, 2, Bytes(12, 1)}, b{2, 2, Bytes(12, 2)};
    EXPECT_EQ(std::get<Bytes>(render::sideBySide(a, b, 1).pixels),
              (Bytes{1, 1, 1, 2, 2, 2, 1, 1, 1, 2, 2, 2}));
    EXPECT_TRUE(render::sideBySide(a, b, 0).pixels == b.pixels);
    EXPECT_TRUE(render::sideBySide(a, b, 2).pixels == a.pixels);
    EXPECT_THROW(render::sideBySide(a, b, 3), image::Error);
    EXPECT_THROW(render::sideBySide(a, {4, 1, Bytes(12, 2)}, 1), image::Error);
    EXPECT_THROW(render::sideBySide(a, {2, 2, image::Floats(12)}, 1), image::Error);
}

TEST_F(Parts, AreOneOrTwo) {
    const Look one = look(options.settings);
    const Part three[] = {one.part(0, 1), one.part(1, 2), one.part(2, width)};
    EXPECT_THROW(support::renderer().render(std::span<const Part>{}, {width, height, false}),
                 std::invalid_argument);
    EXPECT_THROW(support::renderer().render(three, {width, height, false}), std::invalid_argument);
    EXPECT_THROW(support::renderer().drawPicture(three, width, height), std::invalid_argument);
}

// Two plans in turn are no light that moves.
TEST_F(Parts, NoLightSeemsToMoveFromOneToTheOther) {
    const std::unique_ptr<render::GlRenderer> fresh = support::freshRenderer();
    const Look left = look(options.settings);
    bulbs[0]->position.x = 1;
    const Look right = look(options.settings);
    const Part parts[] = {left.part(0, 32), right.part(32, width)};
    for (int i = 0; i < 40; ++i)
        fresh->render(parts, {width, height, false});
    const std::set<lighting::Variant> variants = fresh->stats().variants;
    EXPECT_EQ(std::count_if(variants.begin(), variants.end(),
                            [](const auto& v) { return v.storage == lighting::LightStorage::uniforms; }),
              0);
}

TEST_F(Picture, TheFirstIsDrawnAtOnceAndTheNextWhenItsProgramsAreThere) {
    render::GlRenderer window(render::findShaderDirectory(""), render::Compile::aside);
    EXPECT_THROW(window.picture(), std::logic_error);
    const Look whole = look(options.settings), noClamp = without(Term::clamp);
    ASSERT_TRUE(drawPicture(window, whole));
    EXPECT_EQ(support::difference(window.picture(), atOnce(whole)), "");
    const double compiled = window.stats().compileMilliseconds;
    std::atomic<int> calls = 0;
    window.onCompiled([&calls] { ++calls; });
    ASSERT_FALSE(drawPicture(window, noClamp));
    EXPECT_EQ(support::difference(window.picture(), atOnce(whole)), "") << "the old picture stays";
    for (int i = 0; i < 1000 && calls == 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_GT(calls, 0) << "nobody was told";
    for (int i = 0; i < 1000 && !drawPicture(window, noClamp); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(window.compiling());
    EXPECT_EQ(support::difference(window.picture(), atOnce(noClamp)), "");
    EXPECT_EQ(window.stats().compileMilliseconds, compiled) << "the thread that draws compiled something";
    ASSERT_TRUE(drawPicture(window, whole)) << "what was drawn once is there";
    const Look wide = look(options.settings);
    ASSERT_TRUE(drawPicture(window, wide, 2 * width)) << "another size is drawn at once";
    EXPECT_EQ(window.picture().width, 2 * width);
}

TEST_F(Picture, WhatWasPreparedIsDrawnAtOnce) {
    render::GlRenderer window(render::findShaderDirectory(""), render::Compile::aside);
    ASSERT_TRUE(drawPicture(window, look(options.settings)));
    for (const lighting::TermInfo& row : lighting::terms())
        window.prepare(without(row.term).plan);
    EXPECT_FALSE(window.compiling()) << "no picture waits";
    window.finishCompiling();
    for (const lighting::TermInfo& row : lighting::terms()) {
        EXPECT_TRUE(drawPicture(window, without(row.term))) << row.name;
        EXPECT_EQ(support::difference(window.picture(), atOnce(without(row.term))), "") << row.name;
    }
}

// What is more urgent comes first, nothing is compiled twice, and what waits ahead is bounded.
TEST_F(Picture, UrgentProgramsOvertakeOthers) {
    using render::Urgency;
    render::CompileAside aside;
    ASSERT_TRUE(aside.usable());
    std::promise<void> go;
    std::vector<int> order;  // written by the thread alone until everything is done
    std::atomic<int> calls = 0;
    aside.onWanted([&calls] { ++calls; });
    const auto ask = [&](Urgency urgency, int number) {
        render::ProgramKey key;
        key.second = {static_cast<float>(number)};
        aside.ask(urgency, key, [&order, number] {
            order.push_back(number);
            return render::Program{};
        });
    };
    aside.ask(Urgency::better, {}, [gate = go.get_future().share()] {
        gate.wait();
        return render::Program{};
    });
    for (int i = 0; i < 70; ++i)
        ask(Urgency::ahead, i);
    ask(Urgency::better, 100);
    EXPECT_FALSE(aside.isWanted());
    ask(Urgency::wanted, 200);
    ask(Urgency::wanted, 50);  // was only ahead
    ask(Urgency::ahead, 200);  // stays as it was
    EXPECT_TRUE(aside.isWanted());
    go.set_value();
    aside.wait();
    std::vector<int> expected{200, 50, 100};
    for (int i = 70 - 64; i < 70; ++i)
        if (i != 50)
            expected.push_back(i);
    EXPECT_EQ(order, expected);
    EXPECT_EQ(calls, 2);
    EXPECT_EQ(aside.take().size(), expected.size() + 1);
    EXPECT_FALSE(aside.isWanted());
}

TEST_F(Picture, TwoPartsWaitForBoth) {
    render::GlRenderer window(render::findShaderDirectory(""), render::Compile::aside);
    const Look before = look(options.settings), after = without(Term::cosine);
    ASSERT_TRUE(drawPicture(window, before));
    const Part parts[] = {before.part(0, 20), after.part(20, width)};
    EXPECT_FALSE(window.drawPicture(parts, width, height));
    window.finishCompiling();
    ASSERT_TRUE(window.drawPicture(parts, width, height));
    EXPECT_EQ(support::difference(window.picture(), render::sideBySide(atOnce(before), atOnce(after), 20)),
              "");
}

TEST_F(Picture, OfAnotherRenderer) {
    render::GlRenderer window(render::findShaderDirectory(""), render::Compile::aside);
    support::makeReady(scene, camera, options);
    const image::Frame frame =
        render::ReferenceRenderer().render(scene, camera, options.settings, {33, 21, false});
    window.setPicture(frame);
    EXPECT_EQ(support::difference(window.picture(), frame), "");
}

// While lights move by hand, every picture is drawn, and is what it would be at once.
TEST_F(Picture, ADraggedLightNeverWaits) {
    render::GlRenderer window(render::findShaderDirectory(""), render::Compile::aside);
    for (int i = 0; i < 60; ++i) {
        bulbs[0]->position.x = 2 - 0.02 * i;
        bulbs[0]->intensity = 2 + 0.01 * i;
        bulbs[1]->color.setRGB(1, 0.01 * i, 0.5);
        const Look now = look(options.settings);
        ASSERT_TRUE(drawPicture(window, now)) << i;
        EXPECT_EQ(support::difference(window.picture(), atOnce(now)), "") << i;
    }
}

// Shader files that change under a window.
struct Reload : Picture {
    support::TemporaryDirectory directory;
    std::filesystem::path cosine = directory.path() / "terms/cosine.glsl",
                          view = directory.path() / "view.frag";
    std::string error;
    Reload() {
        std::filesystem::create_directory(directory.path() / "terms");
        const std::filesystem::path own = render::findShaderDirectory("");
        std::filesystem::copy(own / "terms/cosine.glsl", cosine);
        std::filesystem::copy(own / "view.frag", view);
    }
    static void replace(const std::filesystem::path& file, const std::string& from, const std::string& to) {
        std::string text = support::readFile(file);
        ASSERT_NE(text.find(from), std::string::npos);
        support::writeFile(file, text.replace(text.find(from), from.size(), to));
    }
};

TEST_F(Reload, DrawsWithTheFilesAsTheyAre) {
    render::GlRenderer window(directory.path().string(), render::Compile::aside);
    const Look whole = look(options.settings);
    ASSERT_TRUE(drawPicture(window, whole));
    const image::Frame before = window.picture();
    replace(cosine, "return dot(n, v);", "return 0.5 * dot(n, v);");
    ASSERT_TRUE(drawPicture(window, whole));
    EXPECT_EQ(support::difference(window.picture(), before), "") << "not before reload()";
    ASSERT_TRUE(window.reload(error)) << error;
    EXPECT_EQ(support::difference(window.picture(), before), "") << "the picture stays until it is drawn";
    for (int i = 0; i < 1000 && !drawPicture(window, whole); ++i)
        window.finishCompiling();
    EXPECT_GT(support::differingPixels(window.picture(), before), 100);
}

TEST_F(Reload, AnErrorKeepsTheOldProgramsAndNamesTheLine) {
    render::GlRenderer window(directory.path().string(), render::Compile::aside);
    const Look whole = look(options.settings);
    ASSERT_TRUE(drawPicture(window, whole));
    const image::Frame before = window.picture();
    replace(cosine, "return dot(n, v);", "return dot(n);");
    EXPECT_FALSE(window.reload(error));
    EXPECT_NE(error.find("terms/cosine.glsl:7"), std::string::npos) << error;
    EXPECT_NE(error.find("> 7 | float cosine"), std::string::npos) << error;
    ASSERT_TRUE(drawPicture(window, whole));
    EXPECT_EQ(support::difference(window.picture(), before), "");
    replace(cosine, "return dot(n);", "return dot(n, v);");
    EXPECT_TRUE(window.reload(error));
}

TEST_F(Reload, AnErrorInAnotherVariantShowsWhenThatIsWanted) {
    render::GlRenderer window(directory.path().string(), render::Compile::aside);
    const Look whole = look(options.settings);
    lighting::Settings settings = options.settings;
    settings.view = ViewMode::cosine;
    const Look data = look(settings);
    ASSERT_TRUE(drawPicture(window, whole));
    const image::Frame before = window.picture();
    replace(view, "void main()", "void main(");
    EXPECT_TRUE(window.reload(error)) << "nothing that is on the screen has it: " << error;
    window.prepare(data.plan);
    EXPECT_FALSE(drawPicture(window, whole));
    window.finishCompiling();
    ASSERT_TRUE(drawPicture(window, whole));
    for (int i = 0; i < 2; ++i) {
        try {
            EXPECT_FALSE(drawPicture(window, data)) << "it cannot be compiled";
            window.finishCompiling();
            drawPicture(window, data);
            FAIL() << "expected an error";
        } catch (const render::ShaderError& failure) {
            EXPECT_NE(std::string(failure.what()).find("view.frag:"), std::string::npos) << failure.what();
        }
    }
    EXPECT_EQ(support::difference(window.picture(), before), "");
    ASSERT_TRUE(drawPicture(window, whole)) << "the old one can be drawn again";
    replace(view, "void main(", "void main()");
    ASSERT_TRUE(window.reload(error)) << error;
    for (int i = 0; i < 1000 && !drawPicture(window, data); ++i)
        window.finishCompiling();
    EXPECT_EQ(support::difference(window.picture(), atOnce(data)), "");
}

}  // namespace
