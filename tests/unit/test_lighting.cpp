// The table of terms, the option that switches them, and what a frame plan decides.
// SPDX-License-Identifier: MIT
#include "lighting/frame_plan.hpp"
#include "three/three.hpp"

#include <gtest/gtest.h>
#include <set>

namespace {

using lighting::parseTerms;
using lighting::Term;
using lighting::TermSet;

TEST(Terms, TheTableIsInOrderAndItsNamesDiffer) {
    std::set<std::string> names, defines, symbols;
    int number = 0;
    for (const lighting::TermInfo& row : lighting::terms()) {
        EXPECT_EQ(static_cast<int>(row.term), number++);
        EXPECT_EQ(&lighting::info(row.term), &row);
        names.insert(row.name);
        defines.insert(row.define);
        symbols.insert(row.symbol);
        EXPECT_STRNE(row.meaning.it, row.meaning.en);
    }
    EXPECT_EQ(names.size(), 9U);
    EXPECT_EQ(defines.size(), 9U);
    EXPECT_EQ(symbols.size(), 9U);
}

TEST(Terms, Lists) {
    EXPECT_EQ(parseTerms("all", TermSet::none()), TermSet::all());
    EXPECT_EQ(parseTerms("none", TermSet::all()), TermSet::none());
    EXPECT_EQ(parseTerms("cosine,albedo", TermSet::all()),
              TermSet::none().with(Term::albedo).with(Term::cosine));
    EXPECT_EQ(parseTerms("-clamp", TermSet::all()), TermSet::all().without(Term::clamp));
    EXPECT_EQ(parseTerms("-clamp,+clamp,-ambient", TermSet::all()), TermSet::all().without(Term::ambient));
    EXPECT_EQ(parseTerms("+point", TermSet::none()), TermSet::none().with(Term::point));
    for (const char* bad :
         {"", "cosine,", ",cosine", "cosin", "cosine,-clamp", "+", "-", "All", "cosine albedo"})
        EXPECT_THROW(parseTerms(bad, TermSet::all()), std::invalid_argument) << bad;
}

TEST(Terms, TextReadsBack) {
    for (unsigned bits = 0; bits < 1U << 9; ++bits) {
        TermSet set = TermSet::none();
        for (const lighting::TermInfo& row : lighting::terms())
            if ((bits >> static_cast<unsigned>(row.term) & 1U) != 0)
                set = set.with(row.term);
        EXPECT_EQ(parseTerms(set.text(), TermSet::none()), set);
    }
}

struct Plan : testing::Test {
    THREE::Scene scene;
    THREE::SphereGeometry geometry;
    THREE::MeshLambertMaterial material{THREE::Color(0xFF8855)};
    THREE::Mesh ball{geometry, material};
    THREE::PerspectiveCamera camera;
    lighting::Settings settings;

    Plan() {
        scene.add(ball);
        camera.position.set(0, 0, 5);
    }
    lighting::FramePlan plan() {
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
        return lighting::planFrame(scene, camera, settings);
    }
};

TEST_F(Plan, DropsMeshesOutsideTheView) {
    for (const THREE::Vector3& place :
         {THREE::Vector3(0, 0, 7), THREE::Vector3(5, 0, 0), THREE::Vector3(-5, 0, 0), THREE::Vector3(0, 5, 0),
          THREE::Vector3(0, -5, 0), THREE::Vector3(0, 0, -2100)}) {
        ball.position = place;
        const lighting::FramePlan p = plan();
        EXPECT_TRUE(p.draws.empty());
        ASSERT_EQ(p.skipped.size(), 1U);
        EXPECT_NE(std::string(p.skipped[0].why.en).find("outside"), std::string::npos);
    }
    for (const THREE::Vector3& place :
         {THREE::Vector3(0, 0, 5.5), THREE::Vector3(3, 0, 0), THREE::Vector3(0, -3, 0)}) {
        ball.position = place;
        EXPECT_EQ(plan().draws.size(), 1U) << "a part of it is in view";
    }
}

TEST_F(Plan, DrawsFrontToBack) {
    THREE::Mesh back(geometry, material), front(geometry, material);
    back.position.z = -4;
    front.position.z = 1.5;
    scene.add(back, front);
    const lighting::FramePlan p = plan();
    ASSERT_EQ(p.draws.size(), 3U);
    EXPECT_EQ(p.draws[0].mesh, &front);
    EXPECT_EQ(p.draws[1].mesh, &ball);
    EXPECT_EQ(p.draws[2].mesh, &back);
}

TEST_F(Plan, SortsPointLightsByExponentAndCountsThem) {
    std::vector<std::unique_ptr<THREE::PointLight>> lights;
    for (const double k : {2.0, 0.0, 1.5, 1.0, 0.0, 2.0}) {
        lights.push_back(std::make_unique<THREE::PointLight>(THREE::Color(0xFFFFFF), 1, 0, k));
        scene.add(*lights.back());
    }
    const lighting::FramePlan p = plan();
    const lighting::Variant& v = p.draws.at(0).variant;
    EXPECT_EQ(v.decay0, 2);
    EXPECT_EQ(v.decay1, 1);
    EXPECT_EQ(v.decay2, 2);
    EXPECT_EQ(v.decayOther, 1);
    EXPECT_EQ(p.point.back().decay, 1.5);
}

TEST_F(Plan, ShadersHaveOnlyTheTermsThatTheSceneHas) {
    const auto has = [this](Term term) {
        return (plan().draws.at(0).variant.terms >> static_cast<unsigned>(term) & 1U) != 0;
    };
    EXPECT_FALSE(has(Term::cosine));
    THREE::DirectionalLight sun;
    scene.add(sun);
    EXPECT_TRUE(has(Term::cosine));
    EXPECT_TRUE(has(Term::directional));
    EXPECT_FALSE(has(Term::point));
    EXPECT_FALSE(has(Term::ambient));
    THREE::PointLight bulb;
    scene.add(bulb);
    EXPECT_FALSE(has(Term::attenuation)) << "k = 0 and no distance";
    bulb.distance = 3;
    EXPECT_TRUE(has(Term::attenuation));
    sun.visible = false;
    EXPECT_FALSE(has(Term::directional));
    settings.skip = false;
    EXPECT_TRUE(has(Term::directional));
}

TEST_F(Plan, TheAnchorIsOnAGridNearTheFocus) {
    settings.focusDistance = 6;
    EXPECT_EQ(plan().anchor, glm::dvec3(0)) << "near the origin it is the origin";
    settings.focus = {1e8 + 3, -5e7, 12};
    const glm::dvec3 anchor = plan().anchor;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(std::fmod(anchor[i], 16), 0);
        EXPECT_LE(std::abs(anchor[i] - settings.focus[i]), 8);
    }
}

TEST_F(Plan, SaysWhyATermIsIdle) {
    const auto why = [this](Term term) {
        return std::string(lighting::idleReason(term, plan()).en ? lighting::idleReason(term, plan()).en
                                                                 : "");
    };
    EXPECT_NE(why(Term::albedo), "") << "no light at all";
    THREE::DirectionalLight sun;
    scene.add(sun);
    EXPECT_EQ(why(Term::albedo), "");
    EXPECT_EQ(why(Term::cosine), "");
    EXPECT_NE(why(Term::clamp), "") << "with one light a negative sum is black anyway";
    EXPECT_NE(why(Term::lightColor), "") << "a white light";
    THREE::PointLight bulb(THREE::Color(0xDD6666));
    scene.add(bulb);
    EXPECT_EQ(why(Term::clamp), "");
    EXPECT_EQ(why(Term::lightColor), "");
    EXPECT_NE(why(Term::attenuation).find("k = 0"), std::string::npos);
    EXPECT_NE(why(Term::ambient), "");
    bulb.decay = 2;
    EXPECT_EQ(why(Term::attenuation), "");
    scene.remove(bulb);
    material.emissive.set(0x202020);
    EXPECT_EQ(why(Term::clamp), "") << "what is negative is subtracted from the emitted light";
    sun.color.set(0x808080);
    EXPECT_EQ(why(Term::lightColor), "") << "off, a grey light is white";
    sun.color.set(0x000000);
    EXPECT_EQ(why(Term::lightColor), "") << "off, a black light is white, though on it is skipped";
}

}  // namespace
