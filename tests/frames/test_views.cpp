// The views of the equation: the driver's pictures are the reference's, and nothing that a plan leaves out shows in them.
// SPDX-License-Identifier: MIT
#include "lighting/reference/reference.hpp"
#include "lighting/views.hpp"
#include "render/reference_renderer.hpp"
#include "support/both_ways.hpp"
#include "support/stage.hpp"

#include <gtest/gtest.h>

namespace {

using lighting::Shading;
using lighting::Term;
using lighting::TermSet;
using lighting::ViewMode;
using lighting::reference::Reference;
using lighting::reference::Vec3;

// Scenes as the lessons have them: no light; a sun; all kinds of lights, with an unlit mesh, light of its own and highlights.
struct Scene : support::Stage {
    THREE::SphereGeometry ballGeometry{0.3, 24, 16};
    THREE::MeshBasicMaterial plain{THREE::Color(0xEECC44)};
    THREE::Mesh lamp{ballGeometry, plain};

    explicit Scene(const std::string& kind) {
        options.width = 120;
        options.height = 90;
        if (kind == "dark" || kind == "points")
            sun.visible = false;
        if (kind == "dark" || kind == "sun")
            ambient.visible = false;
        if (kind == "full" || kind == "points") {
            bulb({2, 2.5, 2}, 2.5, 2);
            bulb({-2, 3, -1}, 3, 1, 5);
            bulb({0.5, 1.6, 2}, 1.5, 0);
            lamp.position.set(1.6, 0.5, 1);
            all.add(lamp);
        }
        if (kind == "full") {
            orange.specular.set(0x808080);
            green.emissive.set(0x102040);
            box.scale.set(1, 0.4, 1.5);
            floor.visible = false;
            orange.side = THREE::DoubleSide;
        }
        place();
    }
};

struct Case {
    const char* scene;
    ViewMode view;
};

std::string nameOf(const testing::TestParamInfo<Case>& test) {
    return std::string(test.param.scene) + "_" + lighting::info(test.param.view).name;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const char* scene : {"dark", "sun", "points", "full"})
        for (const lighting::ViewInfo& row : lighting::views())
            all.push_back({scene, row.view});
    return all;
}

// 1 where a view has steps that a rounding may shift: there the two pictures may differ by a step.
std::vector<bool> steps(Scene& s, const lighting::Settings& settings) {
    lighting::reference::Look look{settings.view, settings.only};
    look.view = look.view == ViewMode::bands ? ViewMode::cosine : ViewMode::final;
    const Reference<double> reference(s.scene, s.camera, settings, s.options.width, s.options.height, look);
    std::vector<Vec3<double>> pixels(static_cast<std::size_t>(s.options.width * s.options.height));
    reference.draw([&](int x, int y, const Vec3<double>& P) {
        pixels[static_cast<std::size_t>(y * s.options.width + x)] = P;
    });
    std::vector<bool> out;
    for (const Vec3<double>& P : pixels) {
        const double tenths = 10 * (P.x == P.z ? P.z : P.z * 255 / 233);  // of n . w, its sign apart
        bool close =
            settings.view == ViewMode::bands && P.z != 1 && std::abs(tenths - std::round(tenths)) < 1e-4;
        for (int i = 0; i < 3; ++i)
            close |=
                settings.view == ViewMode::overexposed && std::abs(P[i] - lighting::overexposedFrom) < 1e-4;
        out.push_back(close);
    }
    return out;
}

// Draws by the driver and by the reference, and compares codes away from edges.
void expectTheReferences(Scene& s, const std::string& what) {
    support::makeReady(s.scene, s.camera, s.options);
    const render::FrameRequest request{s.options.width, s.options.height, false};
    const image::Frame driver = support::renderer().render(s.scene, s.camera, s.options.settings, request);
    const image::Frame truth =
        render::ReferenceRenderer().render(s.scene, s.camera, s.options.settings, request);
    const auto &a = std::get<image::Bytes>(driver.pixels), &b = std::get<image::Bytes>(truth.pixels);
    const std::vector<std::uint8_t> edges =
        Reference<double>(s.scene, s.camera, s.options.settings, request.width, request.height).edges();
    const std::vector<bool> step = steps(s, s.options.settings);
    int judged = 0, wrong = 0;
    std::string first;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i] != 0 || step[i])
            continue;
        ++judged;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
            if (std::abs(a[c] - b[c]) > 1 && wrong++ == 0)
                first = std::to_string(i % 120) + "," + std::to_string(i / 120) + " channel " +
                        std::to_string(c % 3) + ": " + std::to_string(a[c]) + ", reference " +
                        std::to_string(b[c]);
    }
    EXPECT_EQ(wrong, 0) << what << ": " << first;
    EXPECT_GT(judged, static_cast<int>(edges.size()) / 2) << what;
}

class EachView : public testing::TestWithParam<Case> {
  protected:
    Scene s{GetParam().scene};
    EachView() {
        support::renderer();
        s.options.settings.view = GetParam().view;
    }
};

TEST_P(EachView, IsTheReferences) {
    expectTheReferences(s, "all terms");
    for (const lighting::TermInfo& row : lighting::terms())
        if (!lighting::hides(GetParam().view, row.term)) {
            s.options.settings.terms = TermSet::all().without(row.term);
            expectTheReferences(s, std::string("without ") + row.name);
        }
    s.options.settings.terms = TermSet::all();
    for (const Shading shading : {Shading::vertex, Shading::flat}) {
        s.options.settings.shading = shading;
        expectTheReferences(s, shading == Shading::vertex ? "per vertex" : "flat");
    }
    s.options.settings.shading = Shading::pixel;
    for (const auto& bulb : s.bulbs) {
        s.options.settings.only = bulb.get();
        expectTheReferences(s, "one bulb");
    }
    s.options.settings.only = &s.ambient;
    expectTheReferences(s, "ambient light alone");
}

TEST_P(EachView, NothingSkippedTheSameBytes) {
    support::drawBothWays(s.scene, s.camera, s.options);
    s.orange.color.set(
        0x000000);  // black surfaces, black lights and lights without strength are what plans like to skip
    support::drawBothWays(s.scene, s.camera, s.options);
    s.sun.intensity = 0;
    s.sun.visible = true;
    if (!s.bulbs.empty())
        s.bulbs[0]->color.set(0x000000);
    support::drawBothWays(s.scene, s.camera, s.options);
    s.options.settings.terms = TermSet::none().with(Term::cosine);
    support::drawBothWays(s.scene, s.camera, s.options);
    for (const auto& bulb : s.bulbs) {
        s.options.settings.only = bulb.get();
        support::drawBothWays(s.scene, s.camera, s.options);
    }
}

TEST_P(EachView, MeetsNoNaNAndIsTheSameInAnyFormOfTheProgram) {
    support::draw(s.scene, s.camera, s.options);
    const support::Drawn world = support::draw(s.scene, s.camera, s.options);
    s.options.settings.space = lighting::Space::view;
    const support::Drawn view = support::draw(s.scene, s.camera, s.options);
    EXPECT_TRUE(!lighting::isData(GetParam().view) || world.frame.pixels == view.frame.pixels);
}

INSTANTIATE_TEST_SUITE_P(Views, EachView, testing::ValuesIn(cases()), nameOf);

// Whatever is hidden changes nothing, and is told so.
TEST_P(EachView, WhatItHidesChangesNothing) {
    const support::Drawn before = support::draw(s.scene, s.camera, s.options);
    for (const lighting::TermInfo& row : lighting::terms()) {
        if (!lighting::hides(GetParam().view, row.term))
            continue;
        s.options.settings.terms = TermSet::all().without(row.term);
        support::makeReady(s.scene, s.camera, s.options);
        const support::Frames after = support::drawFrames(s.scene, s.camera, s.options);
        EXPECT_EQ(support::difference(before.frame, after.floats), "") << row.name;
        EXPECT_NE(lighting::idleReason(row.term, after.plan).en, nullptr) << row.name;
    }
}

// One light alone is the scene from which the others were taken.
TEST(OneLight, IsTheSceneWithoutTheOthers) {
    support::renderer();
    for (const lighting::ViewInfo& row : lighting::views()) {
        Scene s("full");
        s.options.settings.view = row.view;
        s.options.settings.only = s.bulbs[1].get();
        support::makeReady(s.scene, s.camera, s.options);
        const support::Frames alone = support::drawFrames(s.scene, s.camera, s.options);
        s.options.settings.only = nullptr;
        s.sun.visible = s.ambient.visible = s.bulbs[0]->visible = s.bulbs[2]->visible = false;
        const support::Frames without = support::drawFrames(s.scene, s.camera, s.options);
        EXPECT_EQ(support::difference(alone, without), "") << row.name;
    }
}

// In a data view a light may move, change and be exchanged without a new program.
TEST(DataViews, OneProgramServesAllPointLights) {
    support::renderer();
    for (const lighting::ViewInfo& row : lighting::views()) {
        if (!lighting::isData(row.view))
            continue;
        Scene s("points");
        s.options.settings.view = row.view;
        std::set<lighting::Variant> variants;
        for (const auto& bulb : s.bulbs) {
            if (bulb->distance > 0)
                continue;
            s.options.settings.only = bulb.get();
            support::makeReady(s.scene, s.camera, s.options);
            for (const lighting::Draw& draw :
                 lighting::planFrame(s.scene, s.camera, s.options.settings).draws)
                if (draw.variant.lit) {
                    EXPECT_NE(draw.variant.storage, lighting::LightStorage::constants);
                    variants.insert(draw.variant);
                }
        }
        EXPECT_EQ(variants.size(), 1U) << row.name;
    }
}

}  // namespace
