// A light close to a sphere, whose peak lies within a few triangles.
// SPDX-License-Identifier: MIT
#include "stability/sphere.hpp"

#include "lighting/reference/reference.hpp"
#include "stability/gouraud.hpp"
#include "stability/shader_text.hpp"
#include "support/strict_glsl.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace stability {

namespace {

using Real = long double;
using Vec = glm::vec<3, Real>;
constexpr int pixels = 48;

// Seen from close by, so that the peak covers the picture.
struct NearSphere {
    THREE::Scene scene;
    THREE::SphereGeometry geometry{1, 32, 16};
    THREE::MeshLambertMaterial material;
    THREE::Mesh mesh{geometry, material};
    THREE::AmbientLight ambient{THREE::Color(0x101010)};
    THREE::PointLight lamp{THREE::Color(0xFFFFFF), 0.05 * 0.05, 0, 2};
    THREE::PerspectiveCamera camera{20, 1, 0.1, 10};
    support::DrawOptions options{pixels, pixels, true, {}};
    Vec towards = glm::normalize(Vec(0, 3, -2));  // the lecture's miaLuce

    NearSphere() {
        scene.add(mesh, ambient, lamp);
        lamp.position = glm::dvec3(1.05L * towards);
        camera.position = glm::dvec3(2.2L * towards);
        camera.lookAt(0, 0, 0);
        options.settings.focusDistance = 2.2;
    }

    // The slides' equation by hand, for a light at P.
    Real shade(const Vec& P, const Vec& Q, const Vec& n, Real& S) const {
        const Vec v = P - Q;
        const Real d2 = glm::dot(v, v), L = static_cast<Real>(lamp.intensity) / d2;
        S = L + static_cast<Real>(A);
        return std::max<Real>(0, glm::dot(n, v) / std::sqrt(d2)) * L + static_cast<Real>(A);
    }

    // Where a ray from the eye meets the true sphere.
    std::optional<Vec> onTrueSphere(const Vec& through) const {
        const Vec eye(glm::dvec3(camera.position)), r = glm::normalize(through - eye);
        const Real b = glm::dot(eye, r), under = b * b - glm::dot(eye, eye) + 1;
        if (under < 0)
            return std::nullopt;
        return eye + r * (-b - std::sqrt(under));
    }
};

glm::vec3 at(const image::Floats& floats, std::size_t pixel) {
    return {floats[pixel * 3], floats[pixel * 3 + 1], floats[pixel * 3 + 2]};
}

}  // namespace

void nearSphere(Outcome& outcome) {
    NearSphere s;
    const support::Drawn drawn = support::draw(s.scene, s.camera, s.options);
    const image::Floats points = drawExpression(drawn.plan, s.options, "worldPosition");
    const image::Floats normals = drawExpression(drawn.plan, s.options, "worldNormal");
    const lighting::reference::Reference<Real> reference(s.scene, s.camera, s.options.settings.terms, pixels,
                                                         pixels);
    Real codes = 0, brightest = 0;
    double units = 0;
    for (std::size_t i = 0; i < pixels * pixels; ++i) {
        const glm::vec3 Q = at(points, i), n = at(normals, i);
        const Real found = drawn.floats()[i * 3];
        Real S = 0;
        // From the floats that the shader has: the light's place is one of them.
        const Real sameAsR1 =
            s.shade(Vec(glm::vec3(drawn.plan.point.at(0).position)), Vec(Q), glm::normalize(Vec(n)), S);
        const support::StrictFragment twin =
            support::strictFragment(drawn.plan, drawn.plan.draws.at(0), Q, n);
        for (const Real value : {found, static_cast<Real>(twin.P.r)})
            units = std::max(
                units, static_cast<double>(std::abs(value - sameAsR1) / (S * static_cast<Real>(support::u))));
        const auto surface = reference.surface(static_cast<int>(i) % pixels, static_cast<int>(i) / pixels);
        require(outcome, surface.has_value() && !twin.nonfinite, "a pixel without a surface, or not finite");
        if (!surface)
            return;
        const std::optional<Vec> truly = s.onTrueSphere(surface->Q + reference.eye());
        require(outcome, truly.has_value(), "a pixel beside the true sphere");
        if (!truly)
            return;
        const Real analytic = s.shade(Vec(glm::dvec3(s.lamp.position)), *truly, *truly, S);
        codes = std::max(codes, 255 * std::abs(found - analytic));
        brightest = std::max(brightest, analytic);
    }
    outcome.expected = "true sphere";
    outcome.bound = "41 codes, 16 u S";
    outcome.twin = outcome.gl = number(static_cast<double>(codes)) + " codes";
    const PerVertex vertices = perVertex(s.scene, s.camera, s.options, outcome);
    requireAsReference(vertices, outcome);
    for (const double off : {vertices.fromFragments, vertices.twin})
        require(outcome, off > 100 && off <= 225.5,
                "per vertex, off from the frame per fragment by " + number(off) + " codes");
    outcome.naive = {"per vertex: " + number(vertices.fromFragments) + " codes", Peer::wrong};
    outcome.legacy = outcome.physical = {"per fragment, too", Peer::none};
    outcome.error = std::max(units, vertices.units);
    require(outcome, brightest > 0.9L, "the picture misses the peak");
    require(outcome, codes <= 41,
            "off from the true sphere by " + number(static_cast<double>(codes)) + " codes");
    require(outcome, units <= 16, "off by " + number(units) + " u S at the same point and normal");
}

}  // namespace stability
