// What a frame leaves out of the equation: lights that are off, terms that the scene does not have, exponents that are known. Each
// time the same bytes as with --no-skip, a counter that says so, and the work gone from the shader.
// SPDX-License-Identifier: MIT
#include "render/program.hpp"
#include "render/shader_source.hpp"
#include "support/both_ways.hpp"
#include "support/stage.hpp"

#include <gtest/gtest.h>

namespace {

using lighting::Term;
using lighting::TermSet;
using support::BothWays;

// The stage in a small picture.
struct Skips : testing::Test, support::Stage {
    Skips() {
        options.width = 60;
        options.height = 52;
    }
    BothWays bothWays() {
        place();
        return support::drawBothWays(scene, camera, options);
    }
};

bool has(const lighting::Draw& draw, Term term) {
    return (draw.variant.terms >> static_cast<unsigned>(term) & 1U) != 0;
}

// The terms of every draw of a plan that has the same ones in all.
std::string termsOf(const lighting::FramePlan& plan) {
    TermSet on = TermSet::none();
    for (const lighting::TermInfo& row : lighting::terms())
        if (has(plan.draws.at(0), row.term))
            on = on.with(row.term);
    for (const lighting::Draw& draw : plan.draws)
        EXPECT_EQ(draw.variant.terms, on.bits());
    return on.text();
}

std::string shaders(const lighting::FramePlan& plan, std::size_t draw = 0) {
    return render::dumpShaders(render::findShaderDirectory(""), plan, plan.draws.at(draw));
}

int count(const std::string& text, const std::string& what) {
    int n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++n;
    return n;
}

TEST_F(Skips, LightsOfIntensityZeroAndBlackOnes) {
    THREE::DirectionalLight offSun(THREE::Color(0xFFFFFF), 0), blackSun(THREE::Color(0x000000), 3);
    THREE::AmbientLight offAmbient(THREE::Color(0xFFFFFF), 0), blackAmbient(THREE::Color(0x000000), 3);
    scene.add(offSun, blackSun, offAmbient, blackAmbient);
    bulb({2, 3, 2}, 3, 1);
    THREE::PointLight& off = bulb({1, 1, 2}, 0, 2, 4);
    THREE::PointLight& black = bulb({-1, 2, 2}, 5, 1.5);
    black.color = THREE::Color(0x000000);
    const BothWays both = bothWays();
    for (const THREE::Light* const light :
         std::initializer_list<const THREE::Light*>{&offSun, &offAmbient, &off})
        EXPECT_TRUE(both.tells(*light, "its intensity is 0"));
    for (const THREE::Light* const light :
         std::initializer_list<const THREE::Light*>{&blackSun, &blackAmbient, &black})
        EXPECT_TRUE(both.tells(*light, "its colour is black"));
    EXPECT_EQ(both.skipped.stats.lightsSkipped, 6);
    EXPECT_EQ(both.skipped.stats.lightsUsed, 3);
    EXPECT_EQ(both.whole.stats.lightsSkipped, 0);
    EXPECT_EQ(both.whole.stats.lightsUsed, 9);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(both.skipped.plan.draws.at(i).variant.point(), 1);
        EXPECT_EQ(both.skipped.plan.draws.at(i).variant.directional, 1);
        EXPECT_EQ(both.whole.plan.draws.at(i).variant.point(), 3);
        EXPECT_EQ(both.whole.plan.draws.at(i).variant.directional, 3);
    }
    EXPECT_EQ(count(shaders(both.skipped.plan), "P = add(P, point_light("), 1 + 4)
        << "a light and four lists";
    EXPECT_EQ(count(shaders(both.whole.plan), "P = add(P, point_light("), 3 + 4);
}

// Off, the term is white light of the same intensity: a black lamp shines then.
TEST_F(Skips, BlackLightsShineWithoutTheirColour) {
    THREE::PointLight& black = bulb({-1, 2, 2}, 0.5, 1);
    black.color = THREE::Color(0x000000);
    options.settings.terms = TermSet::all().without(Term::lightColor);
    const BothWays both = bothWays();
    EXPECT_FALSE(both.tells(black, ""));
    EXPECT_EQ(both.skipped.stats.lightsSkipped, 0);
    black.intensity = 0;
    EXPECT_NE(support::difference(both.skipped, bothWays().skipped), "");
}

TEST_F(Skips, TermsOfWhatTheSceneDoesNotHave) {
    EXPECT_EQ(termsOf(bothWays().skipped.plan), "albedo,cosine,clamp,light_color,directional,ambient");
    EXPECT_EQ(termsOf(bothWays().whole.plan), "all");
    sun.intensity = 0;
    EXPECT_EQ(termsOf(bothWays().skipped.plan), "none") << "D (x) L_A is one colour";
    ambient.intensity = 0;
    const BothWays dark = bothWays();
    EXPECT_EQ(termsOf(dark.skipped.plan), "none");
    EXPECT_EQ(dark.skipped.stats.lightsUsed, 0);
    bulb({2, 3, 2}, 1, 0);
    EXPECT_EQ(termsOf(bothWays().skipped.plan), "albedo,cosine,clamp,light_color,point")
        << "k = 0 drops the distance";
    bulbs[0]->decay = 1;
    EXPECT_EQ(termsOf(bothWays().skipped.plan), "albedo,cosine,clamp,light_color,attenuation,point");
    bulbs[0]->decay = 0;
    bulbs[0]->distance = 20;
    const BothWays window = bothWays();
    EXPECT_EQ(termsOf(window.skipped.plan), "albedo,cosine,clamp,light_color,attenuation,point");
    const std::string text = shaders(window.skipped.plan);
    for (const char* const line : {"#define TERM_DIRECTIONAL 0\n", "#define TERM_AMBIENT 0\n",
                                   "#define TERM_SPECULAR 0\n", "#define TERM_ATTENUATION 1\n"})
        EXPECT_EQ(count(text, line), 2) << line << " in both stages";
    for (const lighting::TermInfo& row : lighting::terms())
        EXPECT_EQ(count(shaders(window.whole.plan), std::string("#define ") + row.define + " 1\n"), 2)
            << row.name;
}

// Every set of terms, so that no combination of #ifs is only right when nothing is dropped.
TEST_F(Skips, EveryTermOff) {
    orange.specular.set(0x404040);
    bulb({2, 3, 2}, 3, 1);
    bulb({-2, 2, 2}, 3, 0);
    bulb({0, 3, 3}, 2, 1.5, 7);
    for (int i = 0; i < lighting::termCount; ++i) {
        SCOPED_TRACE(lighting::info(static_cast<Term>(i)).name);
        options.settings.terms = TermSet::all().without(static_cast<Term>(i));
        const BothWays both = bothWays();
        EXPECT_EQ(both.tells(*bulbs[0], "its term is off"), i == static_cast<int>(Term::point));
        EXPECT_EQ(both.tells(sun, "its term is off"), i == static_cast<int>(Term::directional));
        EXPECT_EQ(both.tells(ambient, "its term is off"), i == static_cast<int>(Term::ambient));
    }
}

TEST_F(Skips, ExponentsAreCompiledIn) {
    bulb({2, 3, 2}, 1, 0);
    bulb({-2, 2, 2}, 2, 1);
    bulb({0, 3, 3}, 3, 2);
    const BothWays both = bothWays();
    const lighting::Variant& v = both.skipped.plan.draws.at(0).variant;
    EXPECT_EQ(v.decay0 * 100 + v.decay1 * 10 + v.decay2, 111);
    EXPECT_EQ(v.decayOther, 0);
    const char* const byPow =
        "point_light(i, n, Q, v, D, point_decay(i))";  // the one loop whose exponent goes through pow
    EXPECT_EQ(count(shaders(both.skipped.plan), byPow), 0) << "no turn of it is left";
    EXPECT_EQ(count(shaders(both.skipped.plan), "point_light(i, n, Q, v, D, 2.0)"), 1);
    bulbs[1]->decay = 1.5;
    EXPECT_EQ(count(shaders(bothWays().skipped.plan), byPow), 1);
}

// Highlights that no material has.
TEST_F(Skips, HighlightsOfDullMaterials) {
    EXPECT_FALSE(has(bothWays().skipped.plan.draws.at(0), Term::specular));
    const THREE::Color shine(0x444444);
    orange.specular = shine;
    const BothWays both = bothWays();
    for (const lighting::Draw& draw : both.skipped.plan.draws)
        EXPECT_EQ(has(draw, Term::specular), draw.mesh == &knot) << "the others do not shine";
    for (const lighting::Draw& draw : both.whole.plan.draws)
        EXPECT_TRUE(has(draw, Term::specular));
}

}  // namespace
