// Frames lit per vertex against frames lit per fragment, and against the reference.
// SPDX-License-Identifier: MIT
#include "stability/gouraud.hpp"

#include "lighting/reference/reference.hpp"
#include "support/strict_glsl.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace stability {

namespace {

using Real = long double;
using Reference = lighting::reference::Reference<Real>;
using Vec = glm::vec<3, Real>;

constexpr double driverCodes = 1.3e-4;  // measured, of a picture of 255

double codes(const Vec& a, const Vec& b) {
    const Vec off = glm::abs(a - b);
    return static_cast<double>(255 * std::max({off.x, off.y, off.z}));
}

// gouraud.vert at the corners of the reference's triangle, gouraud.frag at its weights.
support::StrictFragment between(const support::Drawn& drawn, const lighting::reference::Surface<Real>& s) {
    const lighting::Draw& draw = drawn.plan.draws.at(0);
    const THREE::BufferGeometry& geometry = *draw.mesh->geometry;
    std::uint32_t corners[3];
    geometry.triangle(s.triangle, corners);
    support::StrictGouraudVertex sum{};
    for (int i = 0; i < 3; ++i) {
        const support::StrictGouraudVertex vertex = support::strictGouraudVertex(
            drawn.plan, draw, geometry.getAttribute("position")->getXYZ(corners[i]),
            geometry.getAttribute("normal")->getXYZ(corners[i]));
        const auto weight = static_cast<float>(s.weights[i]);
        sum.frontColor += weight * vertex.frontColor;
        sum.backColor += weight * vertex.backColor;
        sum.metNonfinite += weight * vertex.metNonfinite;
    }
    return support::strictGouraudFragment(draw, sum, s.front);
}

}  // namespace

PerVertex perVertex(THREE::Scene& scene, THREE::PerspectiveCamera& camera,
                    const support::DrawOptions& options, Outcome& outcome) {
    support::DrawOptions vertices = options, view = options;
    vertices.settings.shading = view.settings.shading = lighting::Shading::vertex;
    view.settings.space = lighting::Space::view;
    const support::Drawn fragments = support::draw(scene, camera, options),
                         drawn = support::draw(scene, camera, vertices),
                         inView = support::draw(scene, camera, view);
    lighting::Switches strong = vertices.settings;
    strong.terms = strong.terms.without(lighting::Term::cosine);
    const Reference reference(scene, camera, vertices.settings, options.width, options.height),
        strength(scene, camera, strong, options.width, options.height);
    PerVertex result;
    for (int y = 0; y < options.height; ++y)
        for (int x = 0; x < options.width; ++x) {
            const auto surface = reference.surface(x, y);
            require(outcome, surface.has_value(), "a pixel without a surface");
            if (!surface)
                return result;
            const support::StrictFragment twin = between(drawn, *surface);
            require(outcome, !twin.nonfinite, "strict IEEE met NaN or infinity");
            const Vec truth = reference.shade(*surface), S = strength.shade(*surface);
            const Vec perFragment(fragments.at(x, y)), gl(drawn.at(x, y)), strict(twin.P);
            result.fromFragments = std::max(result.fromFragments, codes(gl, perFragment));
            result.twin = std::max(result.twin, codes(strict, perFragment));
            result.gl = std::max(result.gl, codes(gl, truth));
            result.spaces = std::max(result.spaces, codes(gl, Vec(inView.at(x, y))));
            for (int c = 0; c < 3; ++c)
                result.units = std::max(
                    result.units, static_cast<double>(std::abs(strict[c] - truth[c]) / S[c]) / support::u);
        }
    return result;
}

void requireAsReference(const PerVertex& found, Outcome& outcome) {
    require(outcome, found.units <= 16, "per vertex, strict IEEE is off by " + number(found.units) + " u S");
    require(outcome, found.gl <= 4 * driverCodes, "per vertex, GL is off by " + number(found.gl) + " codes");
    require(outcome, found.spaces <= 4 * driverCodes,
            "per vertex, view space makes a difference of " + number(found.spaces) + " codes");
}

void terminator(Outcome& outcome) {
    THREE::Scene scene;
    THREE::SphereGeometry geometry(1, 64, 32);
    THREE::MeshLambertMaterial material;
    THREE::Mesh mesh(geometry, material);
    THREE::AmbientLight ambient(THREE::Color(0x101010));
    THREE::DirectionalLight sun(THREE::Color(0xFFFFFF), 0.9);
    THREE::PerspectiveCamera camera(18, 1, 0.1, 10);
    scene.add(mesh, ambient, sun);
    sun.position.set(-0.6, 3, -1);
    camera.position.set(0, 0, 4);
    support::DrawOptions options{96, 96, true, {}};
    options.settings.focusDistance = 4;
    const PerVertex found = perVertex(scene, camera, options, outcome);
    requireAsReference(found, outcome);
    for (const double off : {found.fromFragments, found.twin})
        require(outcome, off > 3 && off <= 7.8,
                "off from the frame per fragment by " + number(off) + " codes");
    outcome.expected = "per fragment";
    outcome.bound = "7.8 codes, 16 u S";
    outcome.twin = number(found.twin) + " codes";
    outcome.gl = number(found.fromFragments) + " codes";
    outcome.error = found.units;
    outcome.spaces = found.spaces / 255;
}

}  // namespace stability
