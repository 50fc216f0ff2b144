// Runs a setup in both spaces, on the CPU and on the graphics driver, against the truth.
// SPDX-License-Identifier: MIT
#include "stability/setup.hpp"

#include "lighting/reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>

namespace stability {

using support::u;

namespace {

constexpr long double largestFloat = std::numeric_limits<float>::max();

// World and view space differ by no more, relative to a frame's brightest pixel: 4 times what was measured on Mesa 22.3.6 llvmpipe.
constexpr double spacesAllowed = 4 * 2.3e-6;

double ulp(long double x) {
    const double size = std::max(static_cast<double>(std::abs(x)), 0x1p-126);
    return std::ldexp(1.0, std::ilogb(size) - 23);
}

}  // namespace

std::string Bound::text() const {
    std::ostringstream out;
    out << value;
    switch (unit) {
    case uS:
        return out.str() + " u S";
    case ulp:
        return out.str() + " ULP";
    case code:
        return out.str() + " code";
    case exact:
        break;
    }
    return "exact";
}

double Bound::tolerance(long double truth, long double S) const {
    switch (unit) {
    case uS:
        return value * u * static_cast<double>(std::min(S, largestFloat));
    case ulp:
        return value * stability::ulp(truth);
    case code:
        return value / 255;
    case exact:
        break;
    }
    return 0;
}

namespace {

// In view space positions are rounded where they stand as seen from the eye. What that may cost, in u S, where a light is much
// nearer to the point than the eye is; 0 for all other setups. (In world space the point of these setups is the anchor.)
double viewSpaceCosts(const Setup& setup, double size) {
    double most = 0;
    for (const Lamp& lamp : setup.lamps) {
        const double away = glm::length(setup.eye) * size, d = glm::length(lamp.place);
        if (lamp.kind == Lamp::bulb && d > 0 && d < 0.5 * away)
            most = std::max(most, 2 * (lamp.decay + 1) * away / d);
    }
    return most;
}

// Notes the error of three channels, and what misses the bound by more than `extra` u S.
void judge(const Setup& setup, const Truth& truth, const glm::vec3& found, const std::string& who,
           Measured& into, double extra = 0) {
    const bool exact = setup.bound.unit == Bound::exact;
    for (int c = 0; c < 3; ++c) {
        // Exact means: the float that is nearest to the truth.
        const long double expected =
            exact ? static_cast<long double>(static_cast<float>(truth.P[c])) : truth.P[c];
        const double off = static_cast<double>(std::abs(static_cast<long double>(found[c]) - expected));
        const double S = static_cast<double>(std::min(truth.S[c], largestFloat));
        if (setup.bound.unit != Bound::code && extra == 0)
            into.error = std::max(into.error, off > 0 ? off / (u * S) : 0);
        if (off <= setup.bound.tolerance(truth.P[c], truth.S[c]) + extra * u * S)  // false for NaN
            continue;
        std::ostringstream out;
        out.precision(10);
        out << who << ": channel " << c << " is " << found[c] << ", expected " << expected << " within "
            << setup.bound.text() << ", S " << S << ", off by " << off << " = " << off / (u * S) << " u S";
        into.failures.push_back(out.str());
    }
}

// The reference's whole way from the camera's ray to the middle pixel ends where its equation does.
void expectSeenByReference(const Setup& setup, Stage& stage, const Truth& t, const std::string& where,
                           Measured& into) {
    const lighting::reference::Reference<long double> reference(
        stage.scene, stage.camera, stage.options.settings, setup.pixels, setup.pixels);
    const auto seen = reference.probe(stage.middle(), stage.middle()).P;
    for (int c = 0; c < 3; ++c) {
        const long double held = std::clamp(seen[c], -largestFloat, largestFloat);
        if (!(std::abs(held - t.P[c]) <= 1e-12L * std::min(t.S[c], largestFloat)))
            into.failures.push_back("the reference sees " + std::to_string(held) +
                                    " in the middle pixel, its equation says " + std::to_string(t.P[c]) +
                                    where);
    }
}

// Both spaces on the driver: the middle pixel within the bound, and all others as each other.
void draw(const Setup& setup, Stage& stage, const Truth& t, const std::string& where, double extra,
          Measured& into) {
    stage.options.settings.space = lighting::Space::view;
    const support::Drawn view = support::draw(stage.scene, stage.camera, stage.options);
    stage.options.settings.space = lighting::Space::world;
    const support::Drawn world = support::draw(stage.scene, stage.camera, stage.options);
    const glm::vec3 pixel = world.at(stage.middle(), stage.middle());
    into.gl = pixel[setup.channel];
    judge(setup, t, pixel, "GL" + where, into);
    if (setup.jumps)
        return;
    judge(setup, t, view.at(stage.middle(), stage.middle()), "GL, view space" + where, into, extra);
    double brightest = 0, differ = 0;
    for (std::size_t i = 0; i < world.floats().size(); ++i) {
        const double a = world.floats()[i], b = view.floats()[i];
        brightest = std::max(brightest, std::abs(a));
        differ = std::max(differ, std::abs(a - b));
    }
    if (differ > 0 && extra == 0)
        into.spaces = std::max(into.spaces, differ / brightest);
}

void runOnce(const Setup& setup, double size, double focusDistance, bool draws, Measured& into) {
    Stage stage(setup, size);
    stage.options.settings.focusDistance = focusDistance;
    std::ostringstream where;
    where << " (plane of size " << size << ", focus " << focusDistance << " away)";
    if (const std::string refusal = stage.refusal(); !refusal.empty()) {
        into.failures.push_back("refused" + where.str() + ": " + refusal);
        return;
    }
    const Truth t = truth(stage);
    const double extra = viewSpaceCosts(setup, size);
    into.expected = static_cast<double>(t.P[setup.channel]);
    if (setup.expected && !(std::abs(into.expected - *setup.expected) <= 1e-12 * std::abs(*setup.expected)))
        into.failures.push_back("the reference says " + std::to_string(into.expected) +
                                ", the closed value is " + std::to_string(*setup.expected) + where.str());
    for (const lighting::Space space : {lighting::Space::view, lighting::Space::world}) {
        if (setup.jumps && space == lighting::Space::view)
            continue;
        stage.options.settings.space = space;
        const bool view = space == lighting::Space::view;
        const std::string who = std::string("strict IEEE") + (view ? ", view space" : "");
        const Twin strict = twin(stage);
        into.twin = strict.P[setup.channel];
        judge(setup, t, strict.P, who + where.str(), into, view ? extra : 0);
        if (strict.nonfinite)
            into.failures.push_back(who + where.str() + " met NaN or infinity before a clamp");
    }
    if (draws) {
        expectSeenByReference(setup, stage, t, where.str(), into);
        draw(setup, stage, t, where.str(), extra, into);
    }
}

}  // namespace

Measured measure(const Setup& setup) {
    Measured into;
    if (!setup.refused.empty()) {
        Stage stage(setup, setup.size);
        const std::string refusal = stage.refusal();
        for (const std::string& word : setup.refused)
            if (refusal.find(word) == std::string::npos)
                into.failures.push_back("expected a refusal with '" + word + "', found '" + refusal + "'");
        return into;
    }
    if (setup.size != 1 && setup.centre == glm::dvec3(0)) {
        runOnce(setup, 1, 2, false, into);
        runOnce(setup, setup.size, 1, true, into);
    }
    runOnce(setup, setup.size, 2 * setup.size, true, into);
    if (!(into.spaces <= spacesAllowed))
        into.failures.push_back("view space makes a difference of " + std::to_string(into.spaces) +
                                " of the brightest pixel");
    return into;
}

}  // namespace stability
