// Evaluates the references on all cores, and compares.
// SPDX-License-Identifier: MIT
#include "bench/error/truth.hpp"

#include "lighting/reference/reference.hpp"
#include "render/reference_renderer.hpp"
#include "support/shading.hpp"

#include <algorithm>
#include <cmath>

namespace bench::error {

namespace {

using Real = long double;
using Vec = Truth::Vec;
using lighting::reference::Equation;
using lighting::reference::Light;
using lighting::reference::Lit;
using lighting::reference::onAllCores;

Truth emptyTruth(int size) {
    const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    return {std::vector<std::uint8_t>(pixels), std::vector<Vec>(pixels), std::vector<Vec>(pixels)};
}

// The equation at the points of a frame, each moved by `move` first.
template <class Move>
Truth atPoints(const support::ShadingPoints& at, int size, const Move& move) {
    Truth truth = emptyTruth(size);
    onAllCores(size, [&](int row) {
        const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(size);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(size); ++i) {
            if (!at.points[i])
                continue;
            const support::Shade shade = support::shade(at.equation, move(*at.points[i]));
            truth.judged[i] = 1;
            truth.P[i] = shade.P;
            truth.S[i] = shade.S;
        }
    });
    return truth;
}

// From the scene alone: no driver, no frame plan.
Truth fromScene(const World& world, int size) {
    using lighting::reference::Reference;
    const lighting::Switches switches = world.settings;
    lighting::Switches cosinesOne = switches;
    cosinesOne.terms = switches.terms.without(lighting::Term::cosine);
    const Reference<Real> reference(world.scene, world.camera, switches, size, size);
    const Reference<Real> strength(world.scene, world.camera, cosinesOne, size, size);
    const std::vector<std::uint8_t> edges = reference.edges();
    Truth truth = emptyTruth(size);
    reference.surfaces([&](int x, int y, const std::optional<lighting::reference::Surface<Real>>& surface) {
        const auto i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
        if (!surface || edges[i] != 0)
            return;
        truth.judged[i] = 1;
        truth.P[i] = reference.shade(*surface);
        truth.S[i] = strength.shade(*surface);
    });
    return truth;
}

std::vector<Light<double>> inDouble(const std::vector<Light<Real>>& lights) {
    std::vector<Light<double>> result;
    for (const Light<Real>& light : lights)
        result.push_back({light.source, glm::dvec3(light.place), glm::dvec3(light.L),
                          static_cast<double>(light.intensity), static_cast<double>(light.decay),
                          static_cast<double>(light.distance)});
    return result;
}

image::Floats doublesAt(const support::ShadingPoints& at) {
    Equation<double> equation;
    equation.terms = at.equation.terms;
    equation.directionalLights = inDouble(at.equation.directionalLights);
    equation.pointLights = inDouble(at.equation.pointLights);
    equation.ambientLight = glm::dvec3(at.equation.ambientLight);
    image::Floats floats(at.points.size() * 3);
    for (std::size_t i = 0; i < at.points.size(); ++i) {
        if (!at.points[i])
            continue;
        const Lit<Real>& point = *at.points[i];
        const glm::dvec3 P = equation.lighting(glm::dvec3(point.n), glm::dvec3(point.Q), glm::dvec3(point.D));
        for (int channel = 0; channel < 3; ++channel)
            floats[i * 3 + static_cast<std::size_t>(channel)] = static_cast<float>(P[channel]);
    }
    return floats;
}

image::Floats doublesFromScene(const World& world, int size) {
    render::ReferenceRenderer renderer;
    const image::Frame frame = renderer.render(world.scene, world.camera, world.settings, {size, size, true});
    return std::get<image::Floats>(frame.pixels);
}

}  // namespace

Truths makeTruths(const Case& which, World& world, int size) {
    const lighting::FramePlan plan = lighting::planFrame(world.scene, world.camera, world.settings);
    const support::ShadingPoints at = support::shadingPoints(plan, world.settings, size, size);
    Truths truths;
    truths.bound = at.bound;
    truths.shading = atPoints(at, size, [](const Lit<Real>& point) { return point; });
    switch (which.reference) {
    case Reference::shading:
        truths.own = truths.shading;
        break;
    case Reference::surface: {
        const THREE::Vector3 eye = glm::dvec3(glm::vec3(plan.eye));
        truths.own = atPoints(at, size, [&](const Lit<Real>& point) { return which.surface(point, eye); });
        break;
    }
    case Reference::scene:
        truths.own = fromScene(world, size);
    }
    truths.doubles = which.reference == Reference::scene ? doublesFromScene(world, size) : doublesAt(at);
    return truths;
}

Error floatError(const Truth& truth, const image::Floats& frame) {
    constexpr double worst = 1e30;
    std::vector<double> errors;
    for (std::size_t i = 0; i < truth.judged.size(); ++i)
        for (int channel = 0; channel < 3 && truth.judged[i] != 0; ++channel) {
            const Real found = frame[i * 3 + static_cast<std::size_t>(channel)];
            // Half of the smallest float is always allowed.
            const auto error = static_cast<double>(std::abs(found - truth.P[i][channel]) /
                                                   (truth.S[i][channel] * 0x1p-24L + 0x1p-150L));
            errors.push_back(error <= worst ? error : worst);
        }
    if (errors.empty())
        return {};
    const auto last = static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), errors.begin() + last, errors.end());
    const double p999 = errors[static_cast<std::size_t>(last)];
    return {*std::max_element(errors.begin(), errors.end()), p999, static_cast<long long>(errors.size())};
}

CodeError codeError(const Truth& truth, const image::Bytes& frame) {
    CodeError result;
    long long values = 0, wrong = 0, sum = 0;
    for (std::size_t i = 0; i < truth.judged.size(); ++i)
        for (int channel = 0; channel < 3 && truth.judged[i] != 0; ++channel) {
            const Real right = std::nearbyint(255 * std::clamp<Real>(truth.P[i][channel], 0, 1));
            const int off =
                std::abs(frame[i * 3 + static_cast<std::size_t>(channel)] - static_cast<int>(right));
            result.max = std::max(result.max, off);
            sum += off;
            wrong += off != 0;
            ++values;
        }
    if (values > 0) {
        result.mean = static_cast<double>(sum) / static_cast<double>(values);
        result.wrong = static_cast<double>(wrong) / static_cast<double>(values);
    }
    return result;
}

}  // namespace bench::error
