// Rows A1 to A10: f(d) = 1 / d^k and three.js's window.
// SPDX-License-Identifier: MIT
#include "stability/peers.hpp"
#include "stability/rows.hpp"
#include "stability/shader_text.hpp"

#include <cmath>

namespace stability {

namespace {

constexpr Bound otherExponents{Bound::uS,
                               45};  // 44 and one per light: what is promised where k goes through pow

// The light alone, so that its own error shows.
Setup alone(double d, double k, Bound bound) {
    Setup s{{bulb(d, k)}};
    s.ambient = 0;
    s.bound = bound;
    s.size = std::min(d, 1.0);
    return s;
}

std::vector<Setup> atDistances(std::initializer_list<double> exponents, Bound bound) {
    std::vector<Setup> all;
    for (const double k : exponents)
        for (const double d : {0.3, 0.011, 0.13, 0.77, 0.999, 1.9, 7.1, 33.3, 260.0, 1e3, 54321.0})
            all.push_back(alone(d, k, bound));
    return all;
}

// A light in the point, beside one whose exponent needs pow, so that pow is in the shader.
Setup besidePow(double k) {
    Setup s{{bulb(0, k), bulb(2, 1.9)}};
    s.bound = {Bound::uS, 46};
    s.expected = A + std::pow(2.0, -1.9);
    return s;
}

Setup negativeDecay() {
    Setup s{{bulb(0, -1)}};
    s.refused = {"PointLight 'lampada0'", "decay"};
    return s;
}

// k = 0 has its own group of lights, whose factor is the constant 1.
void neverPow(Outcome& outcome) {
    Stage stage(besidePow(0), 1);
    const lighting::FramePlan plan = stage.plan();
    const lighting::Variant& variant = plan.draws.at(0).variant;
    require(outcome, variant.decay0 == 1 && variant.decayOther == 1, "k = 0 is not a group of its own");
}

// The CPU's pow is much better than a driver's may be: 3.2 ULP for f alone, and the division by d comes to it.
void twinWithin(double ulps, Outcome& outcome) {
    for (const Setup& setup : atDistances({1.9}, {Bound::ulp, ulps})) {
        Stage stage(setup, setup.size);
        const Truth t = truth(stage);
        const double off = std::abs(twin(stage).P.r - static_cast<double>(t.P.r));
        require(outcome, off <= setup.bound.tolerance(t.P.r, t.S.r),
                "strict IEEE is off by " + number(off / Bound{Bound::ulp, 1}.tolerance(t.P.r, t.S.r)) +
                    " ULP at d = " + number(setup.lamps[0].place.z));
    }
}

// Off the middle, from near to far, with everything that could be dropped kept.
void asWithoutAttenuation(Outcome& outcome) {
    for (const double d : {1e-3, 0.05, 1.0, 7.3, 1e3, 1e20}) {
        Setup setup{{{Lamp::bulb, {0.3 * d, -0.4 * d, d}, 1, 0, 0, {1, 0.5, 0.25}}}};
        Stage with(setup, 1), without(setup, 1);
        with.options.settings.skip = without.options.settings.skip = false;
        without.options.settings.terms = without.options.settings.terms.without(lighting::Term::attenuation);
        require(outcome,
                support::draw(with.scene, with.camera, with.options).floats() ==
                    support::draw(without.scene, without.camera, without.options).floats(),
                "k = 0 is not the shader without attenuation, d = " + number(d));
    }
}

// On the end of the window, and as near to it as shows on either side: what is 1.6e-11 more rounds to the same float.
std::vector<Setup> endOfWindow() {
    std::vector<Setup> all;
    for (const double d : {1.0, 1 - 1e-6, 1 + 1e-6}) {
        Setup s{{bulb(d, 0, 1, 1)}};
        s.bound = exactly;
        if (d >= 1)
            s.expected = A;
        all.push_back(s);
    }
    return all;
}

Setup minuteWindow() {
    Setup s{{bulb(1, 0, 1, 1e-20)}};
    s.bound = exactly;
    s.expected = A;
    return s;
}

void asMediump(double d, Outcome& outcome) {
    requireHighp(outcome);
    outcome.naive = peer(mediump(d, d * d), A + 1);
}

Setup ordinary(double d, double k) {
    Setup s{{bulb(d, k, std::pow(d, k))}};
    s.expected = A + 1;
    return s;
}

}  // namespace

std::vector<Row> attenuationRows() {
    return {
        {"A1", "pow(0, 0)", "d = 0, k = 0", Kind::shading, {besidePow(0)}, {}, neverPow},
        {"A2",
         "pow(0, -1)",
         "d = 0, k = 1.9 (k = -1: refused)",
         Kind::shading,
         {besidePow(1.9), negativeDecay()}},
        {"A3",
         "odd exponent",
         "k = 1.9",
         Kind::shading,
         atDistances({1.9}, {Bound::ulp, 26}),
         {},
         [](Outcome& o) { twinWithin(3.2 + 1, o); }},
        {"A4", "quarter exponents", "k = 0.5, 1.5", Kind::shading, atDistances({0.5, 1.5}, otherExponents)},
        {"A5", "k = 0", "any d", Kind::shading, {ordinary(7.3, 0)}, {}, asWithoutAttenuation},
        {"A6",
         "clamp at small exponent",
         "k = 0.5, d = 1e-6",
         Kind::shading,
         {alone(1e-6, 0.5, otherExponents)}},
        {"A7", "cut-off reached exactly", "d = distance, k = 0", Kind::shading, endOfWindow()},
        {"A8", "minute cut-off", "distance = 1e-20", Kind::shading, {minuteWindow()}},
        {"A9",
         "mediump distance",
         "d = 260, k = 2, L = 260^2",
         Kind::shading,
         {ordinary(260, 2)},
         {},
         [](Outcome& o) { asMediump(260, o); }},
        {"A10",
         "mediump near 1",
         "d = 1, k = 2",
         Kind::shading,
         {ordinary(1, 2)},
         {},
         [](Outcome& o) { asMediump(1, o); }},
    };
}

}  // namespace stability
