// The same scene moved away from the origin, judged at a grid of pixels.
// SPDX-License-Identifier: MIT
#include "stability/far_away.hpp"

#include "lighting/reference/reference.hpp"
#include "stability/peers.hpp"
#include "support/strict_glsl.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace stability {

namespace {

using Real = long double;
using Vec = glm::vec<3, Real>;
constexpr double codesAllowed = 2e-4;

const THREE::Quaternion tilt = THREE::Quaternion().setFromAxisAngle({1, -2, 0.3}, 0.6);

Setup scene(double offset) {
    Setup s{{{Lamp::bulb,
              {1.6, 1.2, std::sqrt(5.0)},
              9,
              2,
              0,
              glm::dvec3(1)}}};  // 3 away; L = 9 makes it 1 there
    s.turn = tilt;
    s.size = 0.5;
    s.centre = glm::dvec3(offset + 0.3, -offset - 0.7, 0.9 * offset);
    return s;
}

// The slides' equation at a point of the plane, relative to its centre.
Real byHand(const Setup& s, const Vec& Q, const Vec& n) {
    // Formed as the scene's own doubles are: the light's place is a rounded sum.
    const Vec P = Vec(s.centre + s.lamps[0].place) - Vec(s.centre);
    const Vec v = P - Q;
    const Real d2 = glm::dot(v, v);
    return static_cast<Real>(A) + 9 * std::max<Real>(0, glm::dot(n, v)) / (d2 * std::sqrt(d2));
}

struct Errors {
    Real twin = 0, gl = 0, naive = 0, three = 0;  // codes
};

// Float world coordinates, and three.js's: view space by matrices that were multiplied in double.
void others(const Setup& s, const glm::dmat4& model, const glm::dmat4& view, const glm::dvec3& local,
            Real truth, Errors& e) {
    const glm::vec3 p(local);
    const glm::dvec4 lamp(s.centre + s.lamps[0].place, 1);
    const auto shade = [&](const glm::mat4& place, const glm::vec3& light) {
        Setup at{
            {{Lamp::bulb, glm::dvec3(light - glm::vec3(place * glm::vec4(p, 1))), 9, 2, 0, glm::dvec3(1)}}};
        at.normals.fill(glm::dvec3(glm::vec3(place[2])));
        return static_cast<Real>(naiveGlsl(at).r);
    };
    e.naive = std::max(e.naive, 255 * std::abs(shade(glm::mat4(model), glm::vec3(lamp)) - truth));
    e.three =
        std::max(e.three, 255 * std::abs(shade(glm::mat4(view * model), glm::vec3(view * lamp)) - truth));
}

Errors at(double offset, lighting::Space space) {
    const Setup s = scene(offset);
    Stage stage(s, s.size);
    stage.options.settings.space = space;
    const support::Drawn drawn = support::draw(stage.scene, stage.camera, stage.options);
    const lighting::Draw& draw = drawn.plan.draws.at(0);
    const lighting::reference::Reference<Real> reference(
        stage.scene, stage.camera, stage.options.settings.terms, stage.options.width, stage.options.height);
    const auto place = lighting::reference::placeOf<Real>(stage.mesh);
    const lighting::reference::Planes<Real> planes(place);
    Errors e;
    for (int i = 0; i < 25; ++i) {
        const int x = 8 + i % 5 * 12, y = 8 + i / 5 * 12;
        e.gl = std::max(e.gl, 255 * std::abs(drawn.at(x, y).r - reference.probe(x, y).P.r));
        const glm::dvec3 local(0.25 * (i % 5 - 2), 0.25 * (i / 5 - 2), 0);
        const Real truth = byHand(s, place.direction(Vec(local)), planes.normal({0, 0, 1}));
        const support::StrictVertex vertex = support::strictVertex(draw, local, {0, 0, 1});
        const support::StrictFragment twin =
            support::strictFragment(drawn.plan, draw, vertex.worldPosition, vertex.worldNormal);
        e.twin = std::max(e.twin, 255 * std::abs(twin.P.r - truth));
        others(s, stage.mesh.matrixWorld, stage.camera.matrixWorldInverse(), local, truth, e);
    }
    return e;
}

std::string codes(Real x) { return number(static_cast<double>(x)) + " codes"; }

}  // namespace

void farAway(Outcome& outcome) {
    for (const double offset : {1e5, 1e7, 1e8}) {
        const Errors e = at(offset, lighting::Space::world), view = at(offset, lighting::Space::view);
        require(outcome, std::max(e.twin, view.twin) <= codesAllowed,
                "strict IEEE at " + number(offset) + ": off by " + codes(e.twin) + ", in view space by " +
                    codes(view.twin));
        require(outcome, std::max(e.gl, view.gl) <= codesAllowed,
                "GL at " + number(offset) + ": off by " + codes(e.gl) + ", in view space by " +
                    codes(view.gl));
        if (offset != 1e7)
            continue;
        outcome.twin = codes(e.twin);
        outcome.gl = codes(e.gl);
        outcome.naive = {codes(e.naive), e.naive > 1 ? Peer::wrong : Peer::ok};
        outcome.legacy = outcome.physical = {codes(e.three), e.three > 1 ? Peer::wrong : Peer::ok};
    }
    outcome.expected = "0 codes";
    outcome.bound = "2e-4 code";
}

}  // namespace stability
