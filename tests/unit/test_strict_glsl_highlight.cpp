// The text of terms/specular.glsl on the CPU in strict IEEE float, against the reference's equation in long double.
// SPDX-License-Identifier: MIT
#include "support/shading.hpp"
#include "support/strict_glsl.hpp"
#include "support/strict_glsl_room.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace {

using Real = long double;
using Vec = lighting::reference::Vec3<Real>;
using support::u;
using THREE::SpecularModel;

constexpr Real largestFloat = std::numeric_limits<float>::max();
constexpr SpecularModel models[] = {SpecularModel::phong, SpecularModel::blinn};
constexpr double speculars[] = {1, 1e-3, 1e36};

const char* name(SpecularModel model) { return model == SpecularModel::phong ? "phong" : "blinn"; }

// Directions towards light and eye, and a normal; floats, of length 1 as nearly as floats are.
struct Directions {
    glm::vec3 n, w, v;
};

class Random {
  public:
    glm::vec3 direction() {
        glm::dvec3 p;
        do
            p = {number_(bits_), number_(bits_), number_(bits_)};
        while (glm::dot(p, p) > 1 || glm::dot(p, p) < 1e-4);
        return glm::vec3(glm::normalize(p));
    }
    // From 10^-9 to 1.
    double small() { return std::pow(10.0, 4.5 * (number_(bits_) - 1)); }
    Directions any() {
        Directions d{direction(), direction(), direction()};
        if (glm::dot(d.n, d.w) < 0)  // the other half is black
            d.w = -d.w;
        return d;
    }
    // The eye near where the light is mirrored to.
    Directions nearMirror() {
        Directions d = any();
        const glm::dvec3 n = glm::normalize(glm::dvec3(d.n)), w = glm::normalize(glm::dvec3(d.w));
        d.v = glm::vec3(glm::normalize(2 * glm::dot(n, w) * n - w + small() * glm::dvec3(direction())));
        return d;
    }

  private:
    std::mt19937 bits_{2026};
    std::uniform_real_distribution<double> number_{-1, 1};
};

// One point, black but for its highlight, in white light of 1.
class Shine {
  public:
    Shine(SpecularModel model, double shininess, double specular) {
        room_.sun({0, 0, 1}, 0xFFFFFF);
        room_.plane.material = material_;
        material_.specular.set(specular, specular, specular);
        material_.shininess = shininess;
        material_.specularModel = model;
        plan_ = room_.plan();
        needsScaling = draw().variant.scaled;
        gloss_ = {Vec(glm::vec3(draw().specular)), static_cast<float>(draw().shininess), model};
    }

    bool needsScaling;  // as the planner sees it

    lighting::Draw& draw() { return plan_.draws.at(0); }

    support::StrictFragment found(const Directions& d) {
        plan_.eye = d.v;
        plan_.directional.at(0).w = d.w;
        return support::strictFragment(plan_, draw(), glm::vec3(0), d.n);
    }
    // What the reference says of vectors of length 1, and the most that it could.
    struct Truth {
        Real P, S;
    };
    Truth truth(const Directions& d) const {
        const Vec w = glm::normalize(Vec(d.w));
        const lighting::reference::Lit<Real> at{glm::normalize(Vec(d.n)), -Vec(d.v), Vec(0), gloss_};
        return {std::min(lighting::reference::Equation<Real>::highlight(at, w).r, largestFloat),
                std::min(support::highlightStrength(at, w).r, largestFloat)};
    }
    // The error in units of u S; the half vector of directions that are almost opposite is known less well.
    double error(const Directions& d) {
        const support::StrictFragment is = found(d);
        const Truth t = truth(d);
        EXPECT_FALSE(is.nonfinite);
        EXPECT_GE(is.P.r, 0);
        EXPECT_LE(is.P.r, t.S * (1 + 20 * u));
        const bool blinn = gloss_.model == SpecularModel::blinn;
        const double unknown = blinn ? 2 / glm::length(glm::dvec3(d.w) + glm::dvec3(d.v)) : 1;
        return static_cast<double>(std::abs(is.P.r - t.P) / (u * t.S + 0x1p-150L)) / unknown;
    }

  private:
    lighting::reference::Gloss<Real> gloss_;
    THREE::MeshPhongMaterial material_{THREE::Color(0x000000)};
    support::Room room_;
    lighting::FramePlan plan_;
};

// Both texts, but the plain one only where the planner takes it.
void inBothTexts(Shine& shine, const std::function<void()>& check) {
    for (const bool scaled : {false, true}) {
        if (shine.needsScaling && !scaled)
            continue;
        SCOPED_TRACE(scaled ? "scaled text" : "plain text");
        shine.draw().variant.scaled = scaled;
        check();
    }
}

// The worst of many directions, half of them around the mirrored one.
double worst(SpecularModel model, double shininess) {
    double most = 0;
    for (const double specular : speculars) {
        Shine shine(model, shininess, specular);
        inBothTexts(shine, [&] {
            Random random;
            for (int i = 0; i < 10'000; ++i)
                most = std::max({most, shine.error(random.any()), shine.error(random.nearMirror())});
        });
    }
    return most;
}

TEST(StrictHighlight, IsTheEquationOverAllDirections) {
    // Gates are 4 times the measured figures; rounded vectors cost sqrt(s) u where (R . v)^s is steepest.
    const struct {
        double shininess, phong, blinn;
    } measured[] = {{0, 0, 16.8},     {1e-4, 1.5, 16.8}, {1, 10.9, 15.4}, {5, 8.7, 15.7},
                    {30, 14.7, 13.1}, {1000, 87.1, 15},  {1e5, 810, 384}};
    for (const auto& row : measured) {
        const double phong = worst(SpecularModel::phong, row.shininess);
        const double blinn = worst(SpecularModel::blinn, row.shininess);
        EXPECT_LE(phong, 4 * row.phong) << "s = " << row.shininess;
        EXPECT_LE(blinn, 4 * row.blinn) << "s = " << row.shininess;
        std::cout << "s = " << row.shininess << ": " << phong << " u S (phong), " << blinn << " (blinn)\n";
    }
}

// No float is as near to the mirrored direction as this exponent asks, but for the direction itself.
TEST(StrictHighlight, OfAHugeExponentIsAPoint) {
    for (const SpecularModel model : models)
        for (const double specular : speculars) {
            SCOPED_TRACE(testing::Message() << name(model) << ", K_S " << specular);
            Shine shine(model, 1e36, specular);
            inBothTexts(shine, [&] {
                const glm::vec3 n(0, 0, 1), w(0.6F, 0, 0.8F), mirrored(-0.6F, 0, 0.8F);
                EXPECT_GT(shine.found({n, n, n}).P.r, 0.99F * shine.truth({n, n, n}).S);
                EXPECT_EQ(shine.found({n, w, glm::vec3(-0.6F, 1e-3F, 0.8F)}).P.r, 0);
                const support::StrictFragment found = shine.found({n, w, mirrored});
                EXPECT_FALSE(found.nonfinite);
                EXPECT_GE(found.P.r, 0);
                Random random;
                for (int i = 0; i < 1000; ++i)
                    EXPECT_GE(shine.error(random.nearMirror()), 0) << "finite and not above S";
            });
        }
}

TEST(StrictHighlight, IsAllOfItInTheMirroredDirection) {
    const glm::vec3 n(0, 0, 1);
    for (const double shininess : {0.0, 1.0, 30.0, 1e5, 1e36}) {
        Shine shine(SpecularModel::phong, shininess, 0.75);
        inBothTexts(shine, [&] { EXPECT_EQ(shine.found({n, n, n}).P.r, 0.75F) << "s = " << shininess; });
    }
}

TEST(StrictHighlight, IsNoneAtAll) {
    const glm::vec3 up(0, 0, 1), side(1, 0, 0), slanting(0.6F, 0, 0.8F);
    for (const SpecularModel model : models)
        for (const double shininess : {0.0, 1e-4, 1.0, 30.0, 1e36})
            for (const double specular : speculars) {
                SCOPED_TRACE(testing::Message()
                             << name(model) << ", s " << shininess << ", K_S " << specular);
                Shine shine(model, shininess, specular);
                const auto expectNone = [&](const Directions& d, const char* why) {
                    const support::StrictFragment found = shine.found(d);
                    EXPECT_EQ(found.P, glm::vec3(0)) << why;
                    EXPECT_FALSE(found.nonfinite) << why;
                };
                inBothTexts(shine, [&] {
                    expectNone({glm::vec3(0), slanting, up}, "no normal");
                    expectNone({up, side, slanting}, "n . w = 0");
                    expectNone({up, -slanting, slanting}, "light from behind, v = -w");
                    expectNone({up, -slanting, up}, "light from behind");
                    EXPECT_FALSE(shine.found({up, slanting, glm::vec3(0)}).nonfinite)
                        << "the eye in the very point";
                    if (model == SpecularModel::blinn) {
                        expectNone({slanting, up, -up}, "v = -w: no half vector");
                    } else {
                        expectNone({up, slanting, glm::vec3(0.8F, 0, 0.6F)}, "R . v = 0");
                        expectNone({up, slanting, -up}, "R . v < 0");
                    }
                });
            }
}

// At most 1 float apart on llvmpipe.
TEST(StrictHighlight, IsWhatTheDriverDraws) {
    for (const SpecularModel model : models)
        for (const double shininess : {0.0, 1.0, 30.0, 1000.0}) {
            support::Room room;
            THREE::MeshPhongMaterial material(THREE::Color(0x335577));
            material.specular.set(0xC08040);
            material.shininess = shininess;
            material.specularModel = model;
            room.plane.material = material;
            room.sun({0.1, -0.2, 2}, 0x8090A0);
            room.bulb({0.1, -0.1, 0.75}, 2);
            const support::Drawn drawn = support::draw(room.scene, room.camera, {17, 17, true, {}});
            const lighting::Draw& draw = drawn.plan.draws.at(0);
            const support::StrictVertex middle = support::strictVertex(draw, {0, 0, 0}, {0, 0, 1});
            const glm::vec3 strict =
                support::strictFragment(drawn.plan, draw, middle.worldPosition, middle.worldNormal).P;
            for (int c = 0; c < 3; ++c)
                EXPECT_LE(support::ulps(strict[c], drawn.at(8, 8)[c]), 4)
                    << name(model) << ", s = " << shininess << ", channel " << c;
        }
}

}  // namespace
