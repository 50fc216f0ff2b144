// What must hold between frames, whatever the truth is: sums, orders, places, strengths (slides 28-31, 38).
// SPDX-License-Identifier: MIT
#include "support/stage.hpp"

#include <gtest/gtest.h>

namespace {

using lighting::Term;
using lighting::TermSet;
using support::Stage;
using support::u;
using THREE::Vector3;

// Six lights of all exponents; `order` says in which order they join the scene.
struct Lights : Stage {
    explicit Lights(const std::vector<int>& order = {0, 1, 2, 3, 4, 5}) {
        scene.background = THREE::Color(0x000000);
        const struct {
            Vector3 place;
            double intensity, k;
        } table[] = {{{2, 2.5, 2}, 4, 2}, {{-1.5, 0.4, 1}, 0.7, 1}, {{0, 4, 0}, 0.5, 0},
                     {{3, 1, -1}, 1, 1},  {{-3, 2, 3}, 2, 2},       {{1, 5, 1}, 0.3, 0}};
        for (const int i : order)
            bulb(table[i].place, table[i].intensity, table[i].k);
    }
    support::Drawn drawn() {
        place();
        return support::draw(scene, camera, options);
    }
    // S of every value: the strength with all cosines 1.
    image::Floats strength() {
        const TermSet terms = options.settings.terms;
        options.settings.terms = terms.without(Term::cosine);
        const support::Drawn d = drawn();
        options.settings.terms = terms;
        return d.floats();
    }
};

// (18 + N) u S for each of the two frames.
void expectWithinTheBound(const image::Floats& a, const image::Floats& b, const image::Floats& S,
                          int lights) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_NEAR(a[i], b[i], 2 * (18 + lights) * u * static_cast<double>(S[i]) + 1e-30) << "value " << i;
}

TEST(Metamorphic, TheOrderOfTheLightsDoesNotMatter) {
    Lights forward;
    Lights backward({5, 4, 3, 2, 1, 0});
    Lights mixed({3, 0, 5, 1, 4, 2});
    const image::Floats S = forward.strength(), a = forward.drawn().floats();
    expectWithinTheBound(a, backward.drawn().floats(), S, 7);
    expectWithinTheBound(a, mixed.drawn().floats(), S, 7);
}

TEST(Metamorphic, TheWholeIsTheSumOfTheSingles) {
    Lights all;
    const image::Floats S = all.strength(), whole = all.drawn().floats();
    std::vector<double> sum(whole.size(), 0);
    const auto add = [&sum](Lights& stage) {
        const support::Drawn drawn = stage.drawn();
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += static_cast<double>(drawn.floats()[i]);
    };
    for (int i = 0; i < 6; ++i) {
        Lights one(std::vector<int>{i});
        one.sun.intensity = one.ambient.intensity = 0;
        add(one);
    }
    Lights others(std::vector<int>{});
    add(others);
    expectWithinTheBound(whole, image::Floats(sum.begin(), sum.end()), S, 7);
}

TEST(Metamorphic, TwiceTheLightIsTwiceThePixelToTheLastBit) {
    Lights once, twice;
    for (const auto& bulb : twice.bulbs)
        bulb->intensity *= 2;
    twice.sun.intensity *= 2;
    twice.ambient.intensity *= 2;
    const support::Drawn a = once.drawn(), b = twice.drawn();
    for (std::size_t i = 0; i < a.floats().size(); ++i)
        ASSERT_EQ(2 * a.floats()[i], b.floats()[i]) << "value " << i;
}

// Without attenuation nothing has a size; with it, intensities that grow as d^k make up for it.
TEST(Metamorphic, ScaledByPowersOfTwoTheSameBytes) {
    for (const bool attenuated : {false, true}) {
        Lights here;
        if (!attenuated)
            for (const auto& bulb : here.bulbs)
                bulb->decay = 0;
        const support::Drawn expected = here.drawn();
        for (const int power : {-100, -60, -40, -10, 10, 40, 56}) {
            Lights scaled;
            const double size = std::ldexp(1.0, power);
            scaled.all.scale.setScalar(size);
            scaled.camera.near *= size;
            scaled.camera.far *= size;
            for (const auto& bulb : scaled.bulbs) {
                bulb->decay = attenuated ? bulb->decay : 0;
                bulb->intensity *= std::pow(size, bulb->decay);
            }
            EXPECT_EQ(expected.floats(), scaled.drawn().floats()) << "2^" << power;
        }
    }
}

TEST(Metamorphic, SceneAndCameraMovedTogether) {
    Lights here;
    const support::Drawn expected = here.drawn();
    for (const double offset : {3.0, 1e4, 1e7}) {
        Lights moved;
        moved.all.position.set(offset, 2 * offset, -offset);
        const support::Drawn found = moved.drawn();
        int different = 0;
        for (std::size_t i = 0; i < expected.floats().size(); ++i)
            different += std::abs(expected.floats()[i] - found.floats()[i]) > 1e-4F ? 1 : 0;
        EXPECT_LE(different, 60) << "offset " << offset
                                 << ": only where an edge runs through a pixel's centre";
    }
}

TEST(Metamorphic, WithoutAnyAddendAllIsBlack) {
    Lights stage;
    stage.options.settings.terms =
        TermSet::all().without(Term::directional).without(Term::point).without(Term::ambient);
    const support::Drawn dark = stage.drawn();
    for (const float value : dark.floats())
        ASSERT_EQ(value, 0.0F);
    stage.orange.emissive = THREE::Color(0x00FF00);
    float brightest = 0;
    const support::Drawn glowing = stage.drawn();
    for (const float value : glowing.floats())
        brightest = std::max(brightest, value);
    EXPECT_EQ(brightest, 1.0F) << "what gives off light of its own is no addend";
}

// Slide 28: the same radiance goes to every direction. Points of the floor and of the box's top, each in the middle of the picture.
TEST(Metamorphic, TheColourOfAPointDoesNotDependOnTheCamera) {
    const std::vector<Vector3> points{{2, 0, 2.5}, {-1, 0, 3}, {-2, 2.2, 0.5}};
    const std::vector<Vector3> eyes{{5, 6, 8}, {0.3, 9, 3}, {3, 3, 6}, {-1.5, 40, 4}};
    for (const Vector3& point : points) {
        glm::vec3 first{-1};
        for (const Vector3& eye : eyes) {
            Lights stage;
            stage.options.width = stage.options.height = 33;
            stage.eye = eye;
            stage.target = point;
            const glm::vec3 seen = stage.drawn().at(16, 16);
            if (first.r < 0)
                first = seen;
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(seen[c], first[c], 1e-5 * first[c])
                    << "from " << eye.x << ',' << eye.y << ',' << eye.z;
        }
        EXPECT_GT(first.r, 0.05F);
    }
}

}  // namespace
