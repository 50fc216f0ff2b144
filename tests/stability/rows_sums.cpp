// Rows S1 to S7: many lights, and what they add up to.
// SPDX-License-Identifier: MIT
#include "stability/peers.hpp"
#include "stability/rows.hpp"

#include <algorithm>
#include <cmath>

namespace stability {

namespace {

// N bulbs in all directions above the plane, together 1 - A at its middle. `decades`: how far their terms spread.
Setup many(int count, double decades) {
    Setup s;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double d = std::pow(10.0, decades / 2 * std::fmod(0.618034 * i, 1.0));
        const double height = 0.2 + 0.8 * std::fmod(0.7548777 * i + 0.1, 1.0), around = 2.4 * i;
        const double across = std::sqrt(1 - height * height);
        s.lamps.push_back({Lamp::bulb,
                           glm::dvec3(across * std::cos(around), across * std::sin(around), height) * d, 1, 2,
                           0, glm::dvec3(1)});
        sum += height / (d * d);
    }
    for (Lamp& lamp : s.lamps)
        lamp.intensity = (1 - A) / sum;
    s.bound.value = 18.0 + count;
    s.pixels = count > 1000 ? 3 : 17;
    return s;
}

// One addend after the other into an accumulator that `store` rounds.
template <class Store>
Peer accumulated(const Setup& setup, const Store& store, double expected) {
    Setup one = setup;
    float sum = store(static_cast<float>(setup.ambient));
    one.ambient = 0;
    for (const Lamp& lamp : setup.lamps) {
        one.lamps = {lamp};
        sum = store(sum + naiveGlsl(one).r);
    }
    return peer(sum, expected);
}

float code(float x) { return std::nearbyint(std::clamp(x, 0.0F, 1.0F) * 255) / 255; }

// The float frame in single precision, in one draw, whatever the number of lights.
void singlePass(const Setup& setup, Outcome& outcome) {
    Stage stage(setup, 1);
    const support::Drawn drawn = support::draw(stage.scene, stage.camera, stage.options);
    require(outcome, drawn.stats.drawCalls == 1,
            std::to_string(drawn.stats.drawCalls) + " draw calls, expected 1");
    stage.options.floats = false;
    const auto codes =
        std::get<image::Bytes>(support::draw(stage.scene, stage.camera, stage.options).frame.pixels);
    require(outcome, codes == image::toBytes(drawn.frame),
            "the 8-bit frame is not the float frame, rounded once");
}

// (18 + N) u S says little where N is so large; a naive sum was measured to be off by less than this.
void requireCodes(Outcome& outcome, double off) {
    require(outcome, 255 * off <= 0.026, "the sum is off by " + number(255 * off) + " codes");
}

// More than a driver's shader would turn a loop: four lights are added a turn.
void tenToTheFive(Outcome& outcome) {
    requireCodes(outcome, outcome.error * support::u * 1.7);  // S is below 1.7
}

void reversed(Outcome& outcome) {
    Setup forwards = many(8, 0.3), backwards = forwards;
    forwards.pixels = backwards.pixels = 65;
    std::reverse(backwards.lamps.begin(), backwards.lamps.end());
    std::vector<support::Drawn> floats, codes;
    for (const Setup* setup : {&forwards, &forwards, &backwards}) {
        Stage stage(*setup, 1);
        floats.push_back(support::draw(stage.scene, stage.camera, stage.options));
        stage.options.floats = false;
        codes.push_back(support::draw(stage.scene, stage.camera, stage.options));
    }
    require(outcome, floats[0].floats() == floats[1].floats(), "the same order gives other bytes");
    int differ = 0, most = 0;
    double ulps = 0;
    for (std::size_t i = 0; i < floats[0].floats().size(); ++i) {
        const int difference = std::abs(std::get<image::Bytes>(codes[0].frame.pixels)[i] -
                                        std::get<image::Bytes>(codes[2].frame.pixels)[i]);
        differ += difference > 0 ? 1 : 0;
        most = std::max(most, difference);
        const float a = floats[0].floats()[i], b = floats[2].floats()[i];
        ulps = std::max(ulps, std::abs(a - b) / Bound{Bound::ulp, 1}.tolerance(a, 0));
    }
    require(outcome, ulps > 0, "the reversed order gives the same bytes: it was not reversed");
    require(outcome, ulps <= 4, "reversed, a value is off by " + number(ulps) + " ULP");
    require(outcome, most <= 1 && differ <= 2,
            "reversed, " + std::to_string(differ) + " codes differ, by up to " + std::to_string(most));
}

Setup bright() {
    Setup s{{sun({0, 0, 1})}};
    s.ambient = 2;
    s.expected = 3;
    return s;
}

// Red beyond 1, green at 0.4, blue dark: each channel for itself.
void saturates(Outcome& outcome) {
    Setup s{{sun({0, 0, 1})}};
    s.ambient = 0.2;
    s.lamps[0].color = {2.8, 0.2, 0};
    s.albedo = {1, 1, 0};
    for (const bool eightBits : {false, true}) {
        Stage stage(eightBits ? s : bright(), 1);
        stage.options.floats = false;
        const auto codes =
            std::get<image::Bytes>(support::draw(stage.scene, stage.camera, stage.options).frame.pixels);
        const std::size_t middle = codes.size() / 2 - 1;
        const glm::ivec3 found(codes[middle], codes[middle + 1], codes[middle + 2]);
        const glm::ivec3 expected = eightBits ? glm::ivec3(255, 102, 0) : glm::ivec3(255);
        require(outcome, found == expected,
                "the codes are " + std::to_string(found.r) + ", " + std::to_string(found.g) + ", " +
                    std::to_string(found.b));
    }
}

Setup whiterThanWhite() {
    Setup s{{sun({0, 0, 1})}};
    s.albedo = glm::dvec3(2);
    s.expected = 2 * (A + 1);
    return s;
}

}  // namespace

std::vector<Row> sumRows() {
    return {
        {"S1", "10^5 lights", "over six decades", Kind::sum, {many(100'000, 6)}, {}, tenToTheFive},
        {"S2",
         "half accumulator",
         "1,000 lights",
         Kind::sum,
         {many(1000, 0.3)},
         {},
         [](Outcome& o) { o.naive = accumulated(many(1000, 0.3), half, 1); }},
        {"S3",
         "additive RGBA16F",
         "64 passes",
         Kind::sum,
         {many(64, 0.3)},
         {},
         [](Outcome& o) {
             singlePass(many(64, 0.3), o);
             o.naive = accumulated(many(64, 0.3), halfTruncated, 1);
         }},
        {"S4",
         "additive RGBA8",
         "4 passes",
         Kind::sum,
         {many(4, 0.3)},
         {},
         [](Outcome& o) {
             singlePass(many(4, 0.3), o);
             o.naive = accumulated(many(4, 0.3), code, 1);
         }},
        {"S5", "light order", "8 lights, reversed", Kind::sum, {many(8, 0.3)}, {}, reversed},
        {"S6", "saturation", "L_A = 2, one light of 1", Kind::sum, {bright()}, {}, saturates},
        {"S7", "albedo above 1", "D = 2", Kind::sum, {whiterThanWhite()}},
    };
}

}  // namespace stability
