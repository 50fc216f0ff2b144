// --light-cut: what a frame may lack, and that it lacks no more.
// SPDX-License-Identifier: MIT
#include "support/both_ways.hpp"
#include "support/random_lab.hpp"
#include "support/stage.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace {

using lighting::Term;
using lighting::TermSet;
using support::Frames;

// The most that a pixel's sum can be: what roundings are relative to.
double strongest(const lighting::FramePlan& plan, const Frames& whole) {
    double sum = 0;
    for (const float value : std::get<image::Floats>(whole.floats.pixels))
        sum = std::max(sum, std::abs(static_cast<double>(value)));
    const auto lights = static_cast<double>(plan.directional.size() + plan.point.size());
    return 2 * (18 + lights) * support::u * std::max(sum, 1.0);
}

// Empty if the frame keeps its promise, else what it lacks. Without the clamp, addends of both signs may be larger than their
// sum: `rounding` allows for that.
std::string broken(const Frames& cut, const Frames& whole, double asked, double rounding) {
    const double bound = cut.plan.cutCodes / 255 + rounding;
    const auto& a = std::get<image::Floats>(cut.floats.pixels);
    const auto& b = std::get<image::Floats>(whole.floats.pixels);
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(a[i]) - b[i]));
    int codes = 0;
    const auto& x = std::get<image::Bytes>(cut.codes.pixels);
    const auto& y = std::get<image::Bytes>(whole.codes.pixels);
    for (std::size_t i = 0; i < x.size(); ++i)
        codes = std::max(codes, std::abs(x[i] - y[i]));
    if (most > bound || cut.plan.cutCodes > asked || codes > std::ceil(asked))
        return std::to_string(most * 255) + " codes missing, " + std::to_string(codes) +
               " in 8 bits; promised " + std::to_string(cut.plan.cutCodes) + ", allowed " +
               std::to_string(asked);
    return "";
}

// The stage under bulbs that fall off.
struct LightCut : testing::Test, support::Stage {
    LightCut() {
        options.settings.constantLights = 0;  // which would take longer to compile
        options.width = 60;
        options.height = 44;
        orange.specular.set(0x404040);
        static constexpr double exponents[] = {2, 1, 3, 2, 0.5, 0};
        for (int i = 0; i < 14; ++i)
            bulb({5 * std::cos(2.4 * i), 0.3 + 0.3 * i, 5 * std::sin(2.4 * i)}, 0.02 * (1 + i % 7),
                 exponents[i % 6]);
    }
    Frames draw(double codes) {
        place();
        support::makeReady(scene, camera, options);
        options.settings.lightCut = codes;
        return support::drawFrames(scene, camera, options);
    }
    void expectPromiseKept(double codes) {
        const Frames whole = draw(0), cut = draw(codes);
        EXPECT_EQ(broken(cut, whole, codes, strongest(whole.plan, whole)), "");
    }
};

TEST_F(LightCut, OfNothingIsNothing) {
    const Frames whole = draw(0);
    EXPECT_EQ(whole.plan.cutCodes, 0);
    for (const lighting::PointAddend& light : whole.plan.point)
        EXPECT_FALSE(std::isfinite(light.reach));
    options.settings.skip = false;
    const Frames cut = draw(5);
    EXPECT_EQ(cut.plan.cutCodes, 0) << "--no-skip leaves nothing out";
    EXPECT_EQ(support::difference(cut, whole), "");
}

TEST_F(LightCut, DropsLightsAndSaysSo) {
    for (int i = 0; i < 10; ++i)
        bulb({200.0 + i, 0, 0}, 0.02, 2);
    THREE::PointLight& faint = bulb({0, 3, 0}, 1e-7, 0);
    THREE::DirectionalLight moon(THREE::Color(0x8080FF), 1e-7);
    scene.add(moon);
    const Frames whole = draw(0), cut = draw(20);
    EXPECT_GT(cut.plan.cutCodes, 0);
    EXPECT_LE(cut.plan.cutCodes, 20);
    EXPECT_GE(cut.stats.lightsSkipped, 12) << "ten far away and two that are faint";
    EXPECT_EQ(cut.stats.lightsUsed, whole.stats.lightsUsed - cut.stats.lightsSkipped);
    EXPECT_EQ(cut.stats.cutCodes, cut.plan.cutCodes);
    for (const THREE::Light* const light : std::initializer_list<const THREE::Light*>{&faint, &moon})
        EXPECT_TRUE(std::any_of(cut.plan.skipped.begin(), cut.plan.skipped.end(), [&](const auto& s) {
            return s.object == light && std::string(s.why.en).find("--light-cut") != std::string::npos;
        }));
    int lights = 0;
    for (const lighting::Draw& draw : cut.plan.draws)
        lights += draw.variant.point() + draw.variant.directional;
    EXPECT_LT(lights, 3 * 27);
    EXPECT_NE(support::difference(cut, whole), "") << "it is not exact";
    EXPECT_EQ(broken(cut, whole, 20, strongest(whole.plan, whole)), "");
}

TEST_F(LightCut, KeepsItsPromiseWithEveryTermOff) {
    for (int i = -1; i < lighting::termCount; ++i)
        for (const auto model : {THREE::SpecularModel::phong, THREE::SpecularModel::blinn}) {
            if (i >= 0 && i % 2 == static_cast<int>(model))
                continue;  // each term with one of the two
            const auto term = static_cast<Term>(std::max(i, 0));
            SCOPED_TRACE(testing::Message() << (i < 0 ? "all" : lighting::info(term).name) << ", model "
                                            << static_cast<int>(model));
            options.settings.terms = i < 0 ? TermSet::all() : TermSet::all().without(term);
            options.settings.specular = model;
            expectPromiseKept(2);
        }
}

TEST_F(LightCut, KeepsItsPromiseInOtherSpacesShadingsAndSizes) {
    blue.color = THREE::Color(3, 2, 1);  // more than all light comes back
    expectPromiseKept(3);
    options.settings.space = lighting::Space::view;
    expectPromiseKept(3);
    options.settings.space = lighting::Space::world;
    for (const auto shading : {lighting::Shading::vertex, lighting::Shading::flat}) {
        options.settings.shading = shading;
        expectPromiseKept(3);
    }
    options.settings.shading = lighting::Shading::pixel;
    for (const double size : {1e-5, 1e5, 0x1p-30}) {
        SCOPED_TRACE(size);
        all.scale.setScalar(size);
        camera.near = 0.1 * size;
        camera.far = 100 * size;
        for (std::size_t i = 0; i < bulbs.size(); ++i)
            bulbs[i]->intensity = 0.02 * (1.0 + static_cast<double>(i % 7)) * std::pow(size, bulbs[i]->decay);
        expectPromiseKept(3);
        EXPECT_GT(draw(3).plan.cutCodes, 0);
    }
}

// With more lights than a shader has sums for, the cut bounds clusters.
TEST_F(LightCut, OfManyLightsMakesClusters) {
    for (int i = 0; i < 400; ++i)
        bulb({9 * std::cos(2.4 * i), 0.2 + 0.01 * i, 9 * std::sin(1.7 * i)}, 0.002, 2);
    const Frames whole = draw(0), cut = draw(4);
    EXPECT_EQ(whole.stats.clusters, 0U) << "nothing ends";
    EXPECT_GT(cut.stats.clusters, 1U);
    EXPECT_LT(cut.stats.clusterEntries, cut.stats.clusters * 200);
    EXPECT_EQ(broken(cut, whole, 4, strongest(whole.plan, whole)), "");
}

RC_GTEST_PROP(RandomLightCut, KeepsItsPromise, ()) {
    support::RandomLab lab({.lights = 30});
    support::makeReady(lab.scene, lab.camera, lab.options);
    const double codes = support::octaves(0.01, 100);
    RC_LOG() << codes << " codes\n" << lab.text();
    if (*rc::gen::arbitrary<bool>())
        lab.options.settings.uniformLights = 0;
    lab.options.settings.terms = lab.options.settings.terms.with(Term::clamp);  // see broken()
    const Frames whole = support::drawFrames(lab.scene, lab.camera, lab.options);
    lab.options.settings.lightCut = codes;
    const Frames cut = support::drawFrames(lab.scene, lab.camera, lab.options);
    RC_CLASSIFY(cut.plan.cutCodes > 0, "something is cut");
    RC_CLASSIFY(cut.stats.lightsSkipped > whole.stats.lightsSkipped, "lights are dropped");
    RC_CLASSIFY(cut.stats.clusters > whole.stats.clusters, "clusters");
    const std::string found = broken(cut, whole, codes, strongest(whole.plan, whole));
    RC_LOG() << '\n' << found;
    RC_ASSERT(found.empty());
}

}  // namespace
