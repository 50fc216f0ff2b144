// Samples of three functions of one number.
// SPDX-License-Identifier: MIT
#include "lab/live/curves.hpp"

#include "lab/live/numbered_lights.hpp"
#include "lab/live/numbers.hpp"
#include "lab/live/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

namespace lab {

using lighting::Term;
using lighting::reference::Equation;

namespace {

constexpr int samples = 120;

// A function from `first` to `last`, shown from `low` to `high`.
struct Diagram {
    double first, last, low, high;
    std::function<double(double)> function;

    PanelPoint at(double x, double y) const {
        const auto share = [](double value, double from, double to) {
            return to > from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : 0.0;
        };
        return {share(x, first, last), share(y, low, high)};
    }
    void draw(PanelCurve& curve, double x, double y) const {
        for (int i = 0; i <= samples; ++i) {
            const double here = first + (last - first) * i / samples;
            curve.line.push_back(at(here, function(here)));
        }
        curve.dot = at(x, y);
    }
};

std::string of(const std::string& name, double x, const std::string& unit, double y) {
    return name + "(" + significant(x, 3) + unit + ") = " + significant(y, 3);
}

PanelCurve cosineCurve(const ProbeReport& report, const ProbeLight& light, Language language) {
    const bool clamps = report.on(Term::clamp), isOff = !report.on(Term::cosine);
    const auto cosine = [clamps, isOff](double degrees) {
        const double c = isOff ? 1 : std::cos(degrees * std::numbers::pi / 180);
        return clamps ? std::max(0.0, c) : c;
    };
    PanelCurve curve;
    curve.title = std::string(clamps ? "max(0, cos α)" : "cos α") + "   ω" + subscript(light.number);
    if (isOff)
        curve.title += say({"   (spento: 1)", "   (off: 1)"}, language);
    curve.across = say({"α: da 0° a 180°", "α: 0° ... 180°"}, language);
    const double degrees = degreesBetween(report.probe.n, light.addend.w);
    const Diagram diagram{0, 180, clamps ? 0.0 : -1.0, 1, cosine};
    diagram.draw(curve, degrees, light.addend.clamped);
    const std::string angle = "cos " + significant(degrees, 3) + "°";
    curve.dotText = (clamps ? "max(0, " + angle + ")" : angle) + " = " + significant(light.addend.clamped, 3);
    return curve;
}

PanelCurve distanceCurve(const ProbeReport& report, const ProbeLight& light, Language language) {
    const bool isOff = !report.on(Term::attenuation);
    Equation<double> equation;  // the one place that knows f
    const lighting::reference::Light<double> bulb{nullptr, glm::dvec3(0), glm::dvec3(1),
                                                  1,       light.decay,   light.distance};
    const auto f = [&](double d) { return isOff ? 1 : equation.attenuation(d, d > 0 ? 1 / d : 1e300, bulb); };
    const double d = light.addend.d;
    const double last = light.distance > 0 ? std::max(1.2 * light.distance, d) : d > 0 ? 2 * d : 1;
    PanelCurve curve;
    curve.title = light.decay == 0 ? "f(d) = 1" : "f(d) = 1 / d^" + significant(light.decay, 3);
    if (light.distance > 0)
        curve.title += say({"  con finestra fino a ", "  with a window up to "}, language) +
                       significant(light.distance, 3);
    curve.title += isOff ? say({"   (spento: 1)", "   (off: 1)"}, language) : "";
    curve.across = say({"d: da 0 a ", "d: 0 ... "}, language) + significant(last, 3);
    // High enough for the point in the upper third; without attenuation f is 1 everywhere.
    const double high = std::clamp(1.5 * light.addend.f, 1e-300, 1e300);
    const double top = light.addend.f > 0 ? high : std::clamp(f(last / 4), 1e-300, 1e300);
    const Diagram diagram{0, last, 0, top, f};
    diagram.draw(curve, d, light.addend.f);
    curve.dotText = of("f", d, "", light.addend.f);
    return curve;
}

PanelCurve lobeCurve(const ProbeReport& report, const ProbeLight& light, Language language) {
    const auto& gloss = report.probe.gloss;
    const bool blinn = gloss.model == THREE::SpecularModel::blinn;
    const glm::dvec3 between = light.addend.w + report.probe.v;
    const double size = glm::length(between);
    const glm::dvec3 axis = !blinn     ? mirrored(report.probe.n, light.addend.w)
                            : size > 0 ? between / size
                                       : report.probe.n;
    const double degrees = degreesBetween(axis, blinn ? report.probe.n : report.probe.v);
    const auto lobe = [&gloss](double angle) {
        return std::pow(std::max(0.0, std::cos(angle * std::numbers::pi / 180)), gloss.shininess);
    };
    PanelCurve curve;
    curve.title = std::string(blinn ? "max(0, n·h)^" : "max(0, R·v)^") + significant(gloss.shininess, 3) +
                  (blinn ? "" : "   R" + subscript(light.number));
    if (!report.on(Term::specular))
        curve.title += say({"   (spento: 0)", "   (off: 0)"}, language);
    curve.across = say(blinn ? lighting::Text{"tra n e h: da 0° a 90°", "n to h: 0° ... 90°"}
                             : lighting::Text{"tra R e v: da 0° a 90°", "R to v: 0° ... 90°"},
                       language);
    const Diagram diagram{0, 90, 0, 1, lobe};
    // Behind the surface nothing shines, whatever the angle.
    const double value = glm::dot(report.probe.n, light.addend.w) > 0 ? lobe(std::min(degrees, 90.0)) : 0;
    diagram.draw(curve, degrees, value);
    curve.dotText = significant(degrees, 3) + "°: " + significant(value, 3);
    return curve;
}

}  // namespace

std::vector<PanelCurve> pointCurves(const ProbeReport& report, std::optional<int> chosen, Language language) {
    std::vector<PanelCurve> curves;
    const ProbeLight* const light = chosenLight(report, chosen);
    if (light == nullptr || light->addend.w == glm::dvec3(0) || report.probe.n == glm::dvec3(0))
        return curves;
    curves.push_back(cosineCurve(report, *light, language));
    if (!light->directional)
        curves.push_back(distanceCurve(report, *light, language));
    if (report.shines())
        curves.push_back(lobeCurve(report, *light, language));
    return curves;
}

}  // namespace lab
