// From a surface of the reference to a report.
// SPDX-License-Identifier: MIT
#include "lab/live/probe.hpp"

#include "image/frame.hpp"
#include "lab/live/numbered_lights.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace lab {

using lighting::Term;
using lighting::reference::Addend;
using lighting::reference::Sight;

namespace {

// As a screen shows it, and its code as frames have it.
void encode(ProbeReport& report) {
    image::Floats floats;
    for (int c = 0; c < 3; ++c) {
        report.clamped[c] = std::isfinite(report.probe.P[c]) ? std::clamp(report.probe.P[c], 0.0, 1.0) : 0.0;
        floats.push_back(static_cast<float>(report.clamped[c]));
    }
    const image::Bytes codes = image::toBytes(image::Frame{1, 1, floats});
    std::copy(codes.begin(), codes.end(), report.code.begin());
}

}  // namespace

const ProbeLight* ProbeReport::light(int number) const {
    const auto found = std::find_if(lights.begin(), lights.end(),
                                    [number](const ProbeLight& row) { return row.number == number; });
    return found == lights.end() ? nullptr : &*found;
}

void Prober::see(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                 const lighting::Switches& switches, int width, int height) {
    scene_ = &scene;
    camera_ = &camera;
    switches_ = switches;
    width_ = width;
    height_ = height;
    reference_.reset();
}

const Prober::Reference* Prober::reference() {
    if (scene_ == nullptr || width_ < 1 || height_ < 1)
        return nullptr;
    if (!reference_)
        reference_.emplace(*scene_, *camera_, switches_, width_, height_);
    return &*reference_;
}

std::optional<SurfacePoint> Prober::point(int x, int y) {
    const Reference* const seen = inside(x, y) ? reference() : nullptr;
    const std::optional<Surface> surface = seen != nullptr ? seen->surface(x, y) : std::nullopt;
    if (!surface)
        return std::nullopt;
    return SurfacePoint{seen->bodies()[surface->body].mesh, surface->triangle, surface->weights};
}

std::optional<ProbeReport> Prober::at(int x, int y) {
    const Reference* const seen = inside(x, y) ? reference() : nullptr;
    if (seen == nullptr)
        return std::nullopt;
    ProbeReport result;
    if (const std::optional<Surface> surface = seen->surface(x, y)) {
        result = report(*surface);
    } else {
        result.probe = seen->probe(x, y);
        result.switches = switches_;
        encode(result);
    }
    result.pixel = {x, y};
    result.place = PanelPoint{(x + 0.5) / width_, (y + 0.5) / height_};
    return result;
}

std::optional<ProbeReport> Prober::at(const SurfacePoint& point) {
    const Reference* const seen = reference();
    const std::optional<Surface> surface =
        seen != nullptr ? seen->surfaceAt(point.mesh, point.triangle, point.weights) : std::nullopt;
    if (!surface)
        return std::nullopt;
    ProbeReport result = report(*surface);
    result.point = point;
    result.centre = false;
    result.sight = seen->sight(*surface);
    if (const std::optional<glm::dvec3> place = seen->picture(*surface)) {
        result.place = PanelPoint{place->x / width_, place->y / height_};
        if (result.sight == Sight::visible)
            result.pixel = {static_cast<int>(place->x), static_cast<int>(place->y)};
    }
    return result;
}

ProbeReport Prober::report(const Surface& surface) {
    ProbeReport result;
    result.probe = reference_->probe(surface);
    result.point = SurfacePoint{result.probe.mesh, surface.triangle, surface.weights};
    result.mesh = THREE::describe(*result.probe.mesh);
    result.switches = switches_;
    result.ambientLight = reference_->equation().ambientLight;
    encode(result);
    if (result.probe.lit)
        addLights(surface, result);
    return result;
}

void Prober::addLights(const Surface& surface, ProbeReport& report) {
    lighting::reference::Equation<double> all = reference_->equation();
    all.terms = all.terms.with(Term::directional).with(Term::point);
    std::unordered_map<const THREE::Light*, Addend<double>> addends;
    all.lighting(reference_->lit(surface),
                 [&addends](const Addend<double>& addend) { addends.emplace(addend.light, addend); });
    const glm::dvec3 D = all.albedo(report.probe.D);
    for (const NumberedLight& numbered : numberedLights(*scene_)) {
        if (!numbered.visible)
            continue;
        if (dynamic_cast<const THREE::AmbientLight*>(numbered.light) != nullptr)
            report.ambientLights.push_back(numbered.number);
        const auto found = addends.find(numbered.light);
        if (found == addends.end())
            continue;
        const Addend<double>& addend = found->second;
        ProbeLight row;
        row.number = numbered.number;
        row.name = numbered.light->name;
        row.addend = addend;
        row.diffuse = (addend.clamped * addend.f) * (D * addend.L);
        row.highlight = addend.f * (addend.specular * addend.L);
        const auto* const bulb = dynamic_cast<const THREE::PointLight*>(numbered.light);
        row.directional = bulb == nullptr;
        row.counted = report.on(row.directional ? Term::directional : Term::point);
        if (bulb != nullptr) {
            row.decay = bulb->decay;
            row.distance = bulb->distance;
        }
        report.lights.push_back(row);
    }
}

}  // namespace lab
