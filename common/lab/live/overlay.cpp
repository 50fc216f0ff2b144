// Arrows of the same size at any distance.
// SPDX-License-Identifier: MIT
#include "lab/live/overlay.hpp"

#include "lab/live/numbered_lights.hpp"
#include "lab/live/numbers.hpp"
#include "lab/live/probe_text.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace lab {

using lighting::reference::Sight;

namespace {

constexpr double strong = 3.5, usual = 2, thin = 1.5;  // widths
constexpr double tagAt = 1.15, arcAt = 0.4, arcTagAt = 0.55;  // of an arrow's length
constexpr int arcSteps = 24, ringSteps = 16;

// Any unit vector at right angles to a unit vector.
glm::dvec3 across(const glm::dvec3& n) {
    const glm::dvec3 other = std::abs(n.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    return glm::normalize(glm::cross(n, other));
}

class Arrows {
  public:
    Arrows(const ProbeReport& report, const THREE::PerspectiveCamera& camera, const OverlayOptions& options)
        : report_(report), projection_(camera), options_(options),
          length_(projection_.lengthAt(report.probe.Q, options.length)) {}

    Overlay draw() {
        const auto& probe = report_.probe;
        if (probe.mesh == nullptr || !(length_ > 0) || !std::isfinite(length_))
            return {};
        arrow(probe.n, "n", Ink::normal, strong);
        if (!report_.lights.empty())
            lights();
        return std::move(overlay_);
    }

  private:
    glm::dvec3 at(const glm::dvec3& direction, double lengths) const {
        return report_.probe.Q + direction * (length_ * lengths);
    }
    Ink seen(Ink ink) const { return report_.sight == Sight::visible ? ink : Ink::faint; }

    void line(const glm::dvec3& from, const glm::dvec3& to, Ink ink, bool head, double width) {
        if (const auto stroke = projection_.stroke(from, to, seen(ink), head, width))
            overlay_.strokes.push_back(*stroke);
    }
    void tag(const glm::dvec3& place, const std::string& text, Ink ink) {
        const std::optional<PanelPoint> there = projection_.point(place);
        if (there && inPicture(*there))
            overlay_.tags.push_back({*there, text, seen(ink)});
    }
    void arrow(const glm::dvec3& direction, const std::string& name, Ink ink, double width) {
        if (direction == glm::dvec3(0))
            return;
        line(report_.probe.Q, at(direction, 1), ink, true, width);
        tag(at(direction, tagAt), name, ink);
    }

    void lights() {
        const ProbeLight* const chosen = chosenLight(report_, options_.chosen);
        std::vector<int> told = brightestLights(report_, options_.lights);
        if (chosen != nullptr && std::find(told.begin(), told.end(), chosen->number) == told.end())
            told.push_back(chosen->number);
        const bool reflects = report_.shines() || options_.reflected;
        for (const int number : told) {
            const ProbeLight& light = *report_.light(number);
            const double cosine = glm::dot(report_.probe.n, light.addend.w);
            const bool faint = !(cosine > 0) || !light.counted;
            const double width = &light == chosen ? strong : usual;
            arrow(light.addend.w, "ω" + subscript(number), faint ? Ink::faint : Ink::light, width);
            if (reflects && cosine > 0)
                arrow(mirrored(report_.probe.n, light.addend.w), "R" + subscript(number),
                      faint ? Ink::faint : Ink::reflected, width);
        }
        if (chosen != nullptr)
            angle(report_.probe.n, chosen->addend.w);
        if (reflects)
            towardsTheEye();
    }

    // From n to w, on a circle about the point.
    void angle(const glm::dvec3& n, const glm::dvec3& w) {
        if (n == glm::dvec3(0) || w == glm::dvec3(0))
            return;
        const double degrees = degreesBetween(n, w), whole = degrees * std::numbers::pi / 180;
        const glm::dvec3 rest = w - n * glm::dot(n, w);
        const double size = glm::length(rest);
        const glm::dvec3 side = size > 1e-9 ? rest / size : across(n);
        const auto turned = [&](double share) {
            return n * std::cos(whole * share) + side * std::sin(whole * share);
        };
        for (int i = 0; i < arcSteps; ++i)
            line(at(turned(static_cast<double>(i) / arcSteps), arcAt),
                 at(turned((i + 1.0) / arcSteps), arcAt), Ink::chosen, false, thin);
        tag(at(turned(0.5), arcTagAt), significant(std::round(degrees * 10) / 10, 4) + "°", Ink::chosen);
    }

    // An arrow that one looks along is a ring about its point.
    void towardsTheEye() {
        const glm::dvec3 v = report_.probe.v;
        if (v == glm::dvec3(0))
            return;
        const glm::dvec3 right = across(v), up = glm::cross(v, right);
        const auto place = [&](int i) {
            const double angle = 2 * std::numbers::pi * (i % ringSteps) / ringSteps;
            return at(right * std::cos(angle) + up * std::sin(angle), 0.1);
        };
        for (int i = 0; i < ringSteps; ++i)
            line(place(i), place(i + 1), Ink::view, false, usual);
        tag(place(ringSteps / 8), "v", Ink::view);
    }

    const ProbeReport& report_;
    Projection projection_;
    const OverlayOptions& options_;
    double length_;
    Overlay overlay_;
};

}  // namespace

const ProbeLight* chosenLight(const ProbeReport& report, std::optional<int> chosen) {
    if (const ProbeLight* const light = chosen ? report.light(*chosen) : nullptr)
        return light;
    const std::vector<int> brightest = brightestLights(report, 1);
    return brightest.empty() ? nullptr : report.light(brightest.front());
}

glm::dvec3 mirrored(const glm::dvec3& n, const glm::dvec3& w) { return 2 * glm::dot(n, w) * n - w; }

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

Overlay pointOverlay(const ProbeReport& report, const THREE::PerspectiveCamera& camera,
                     const OverlayOptions& options) {
    return Arrows(report, camera, options).draw();
}

}  // namespace lab
