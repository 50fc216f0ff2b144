// Rows P1 to P22: highlights, and lighting at vertices.
// SPDX-License-Identifier: MIT
#include "stability/rows.hpp"

#include "support/strict_glsl.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace stability {

namespace {

constexpr double brightest = std::numeric_limits<float>::max();
constexpr double half = std::numbers::sqrt2 / 2;
constexpr THREE::SpecularModel blinn = THREE::SpecularModel::blinn;

// Four times what tests/frames/test_shading.cpp measures for the exponent.
constexpr Bound steep30{Bound::uS, 63}, steep200{Bound::uS, 114}, steep1000{Bound::uS, 200},
    steep100000{Bound::uS, 3240};

Setup shiny(Lamp lamp, double shininess, double specular = 1) {
    Setup s{{lamp}};
    s.gloss = Gloss{glm::dvec3(specular), shininess, THREE::SpecularModel::phong};
    return s;
}

Setup expecting(Setup s, double expected, Bound bound = {}) {
    s.expected = expected;
    s.bound = bound;
    return s;
}

Setup seenFrom(const glm::dvec3& eye, Setup s) {
    s.eye = eye;
    return s;
}

Setup perVertex(Setup s) {
    s.perVertex = true;
    return s;
}

Setup inBlinns(Setup s) {
    s.gloss->model = blinn;
    return s;
}

Setup sized(double size, Setup s) {
    s.size = size;
    for (Lamp& lamp : s.lamps)
        lamp.place *= lamp.kind == Lamp::bulb ? size : 1;
    return s;
}

// A tilted plane from straight above; the light is so far aside that the highlight is e^-x.
Setup onTheSlope(double shininess, double x, Bound bound) {
    const double angle = std::acos(std::exp(-x / shininess));
    Setup s = shiny(sun({0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle)}), shininess);
    s.turn = THREE::Quaternion().setFromAxisAngle({1, -2, 0.3}, 0.6);
    s.lamps[0].place = glm::dquat(s.turn) * s.lamps[0].place;
    s.bound = bound;
    return s;
}

// Light and eye on opposite sides, both just above the surface.
Setup grazing() {
    constexpr double low = 1e-3;
    Setup s = seenFrom({-2 * std::cos(low), 0, 2 * std::sin(low)},
                       shiny(sun({std::cos(low), 0, std::sin(low)}), 30));
    s.bound = steep30;
    return s;
}

// The eye is where light of this direction would be mirrored to, were it not in the plane or below.
Setup unlit(Lamp lamp) {
    Setup s = expecting(seenFrom({-1.6, 0, 1.2}, shiny(lamp, 1)), A, exactly);
    s.jumps = true;
    return s;
}

// The eye on the light's side: R points away from it.
Setup turnedAway(double shininess) {
    return expecting(seenFrom({1.6, 0, 1.2}, shiny(sun({0.8, 0, 0.6}), shininess)), A + 0.6);
}

Setup tooShiny(double light, double specular, double shininess, Bound bound) {
    Setup s = shiny(sun({0, 0, 1}, light), shininess);
    s.gloss->specular = {specular, 1, 0};
    s.bound = bound;
    return s;
}

// Near the highlight's middle, with neither light nor eye on an axis; all numbers are exact.
Setup aside(double shininess, double k) {
    Setup s = seenFrom({-0.75, 0.5, 1},
                       shiny({Lamp::bulb, {0.8125, -0.5, 1}, 1, k, 0, {1, 0.5, 0.25}}, shininess, 0.75));
    s.bound = steep200;
    return s;
}

Setup farFromTheOrigin(Setup s) {
    s.centre = {1e8, -3e8, 2e8};
    return s;
}

Setup withoutNormals(Setup s) {
    s.normals.fill(glm::dvec3(0));
    return expecting(s, A, exactly);
}

// three.js's highlight where n, w and v are one.
double blinnStraight(double specular, double shininess) {
    const double grazing = std::exp2(-5.55473 - 6.98316);
    return (specular * (1 - grazing) + grazing) * 0.25 * (shininess / 2 + 1);
}

Setup tooBright() {
    Setup s = expecting(perVertex(shiny(sun({0, 0, 1}, 1e36), 30)), brightest, exactly);
    s.albedo = glm::dvec3(300);
    s.gloss->specular = glm::dvec3(1e36);
    s.ambient = 0;
    return s;
}

// A triangle that hangs from the eye itself is seen from its edge, so that it covers no pixel; its vertices are run.
void vertexInTheEye(Outcome& outcome) {
    for (const THREE::SpecularModel model : {THREE::SpecularModel::phong, blinn}) {
        THREE::Scene scene;
        THREE::BufferGeometry geometry;
        geometry.setAttribute("position", {0, 0, 2, -1, -1, 0, 1, -1, 0}, 3)
            .setAttribute("normal", {0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
        THREE::MeshPhongMaterial material;
        material.side = THREE::DoubleSide;
        material.specularModel = model;
        THREE::Mesh mesh(geometry, material);
        THREE::DirectionalLight light;
        THREE::PerspectiveCamera camera(90, 1, 0.1, 10);
        scene.add(mesh, light);
        light.position.set(0.2, 0, 1);
        camera.position.set(0, 0, 2);
        support::DrawOptions options{33, 33, true, {}};
        options.settings.shading = lighting::Shading::vertex;
        const support::Drawn drawn = support::draw(scene, camera, options);  // counts what is not finite
        for (const float value : drawn.floats())
            require(outcome, std::isfinite(value), "a pixel is " + number(value));
        const support::StrictGouraudVertex vertex =
            support::strictGouraudVertex(drawn.plan, drawn.plan.draws.at(0), {0, 0, 2}, {0, 0, 1});
        require(outcome, vertex.metNonfinite == 0, "strict IEEE met NaN or infinity at the eye");
    }
    outcome.naive = {"NaN", Peer::notFinite};  // normalize(0)
    outcome.expected = outcome.twin = outcome.gl = outcome.bound = "finite";
}

std::vector<Row> exponentRows() {
    return {
        {"P1",
         "exponent 0",
         "s = 0",
         Kind::shading,
         {expecting(shiny(sun({1, 0, 1}), 0, 0.5), A + half + 0.5)}},
        {"P2",
         "R . v = 1 exactly",
         "s = 30, 1e5, 1e36",
         Kind::shading,
         {expecting(shiny(sun({0, 0, 1}), 1e36), A + 2, {Bound::uS, 4}),
          expecting(shiny(bulb(1, 0), 1e5), A + 2, {Bound::uS, 4}),
          expecting(shiny(bulb(1, 2), 30), A + 2, {Bound::uS, 4})}},
        {"P3",
         "huge exponent, beside the mirror",
         "s = 1e36",
         Kind::shading,
         {expecting(shiny(sun({1e-3, 0, 1}), 1e36), A + 1 / std::sqrt(1 + 1e-6))}},
        {"P4",
         "where the highlight is steepest",
         "s = 1e5, 1000, 200, 30",
         Kind::shading,
         {onTheSlope(1e5, 0.5, steep100000), onTheSlope(1e5, 5, steep100000),
          onTheSlope(1000, 0.5, steep1000), onTheSlope(200, 0.5, steep200), onTheSlope(30, 0.5, steep30)}},
        {"P5",
         "grazing highlight",
         "light and eye 1e-3 above the plane",
         Kind::shading,
         {grazing(), inBlinns(grazing())}},
        {"P6",
         "highlight without light",
         "n . w = 0 and -1e-8, R . v = 0.8",
         Kind::shading,
         {unlit(sun({1, 0, 0})), unlit({Lamp::bulb, {1, 0, 0}, 1, 2, 0, glm::dvec3(1)}),
          unlit(sun({1, 0, -1e-8}))}},
        {"P7",
         "negative base",
         "R . v = -0.28, s = 0, 1, 2.5",
         Kind::shading,
         {turnedAway(0), turnedAway(1), turnedAway(2.5)}},
    };
}

std::vector<Row> strengthRows() {
    return {
        {"P8", "huge K_S", "1e36", Kind::shading, {expecting(tooShiny(1, 1e36, 30, {}), 1e36)}},
        {"P9",
         "highlight overflows",
         "K_S = 1e36, L = 1e36; s = 1e36",
         Kind::shading,
         {expecting(tooShiny(1e36, 1e36, 30, exactly), brightest),
          expecting(inBlinns(tooShiny(1, 1e36, 1e36, {})), brightest)}},
        {"P10",
         "highlight far from the origin",
         "3e8",
         Kind::shading,
         {farFromTheOrigin(aside(200, 2)), inBlinns(farFromTheOrigin(aside(200, 2)))}},
        {"P11",
         "highlight in a tiny scene",
         "sizes 1e-20, 1e-9",
         Kind::shading,
         {sized(1e-20, aside(200, 0)), sized(1e-9, aside(200, 1))}},
        {"P12",
         "highlight in a huge scene",
         "sizes 1e17, 1e9",
         Kind::shading,
         {sized(1e17, aside(200, 0)), sized(1e9, aside(200, 1))}},
        {"P13",
         "highlight of a far light",
         "d = 1e25, k = 0; d = 1e18, k = 2",
         Kind::shading,
         {expecting(shiny(bulb(1e25, 0), 200), A + 2), expecting(shiny(bulb(1e18, 2, 1e36), 200), A + 2)}},
        {"P14",
         "highlight of a near light",
         "d = 1e-13, 1e-3, k = 2",
         Kind::shading,
         {sized(1e-13, expecting(shiny(bulb(1, 2), 200), 2e26)),
          expecting(shiny(bulb(1e-3, 2), 200), 2e6 + A)}},
        {"P15",
         "highlight of a light on the point",
         "P = Q, k = 0, 2",
         Kind::shading,
         {expecting(shiny(bulb(0, 2), 30), A, exactly),
          expecting(inBlinns(shiny(bulb(0, 0), 30)), A, exactly)}},
        {"P16",
         "highlight without a normal",
         "zero normals",
         Kind::shading,
         {withoutNormals(shiny(bulb(1, 0), 30)), inBlinns(withoutNormals(shiny(bulb(1, 0), 0)))}},
        {"P17",
         "three.js's highlight",
         "Blinn's h, s = 30, 0, 1e5",
         Kind::shading,
         {expecting(inBlinns(shiny(sun({0, 0, 1}), 30, 0.5)), A + 1 + blinnStraight(0.5, 30)),
          expecting(inBlinns(shiny(sun({0, 0, 1}), 0, 0.5)), A + 1 + blinnStraight(0.5, 1e-4)),
          expecting(inBlinns(shiny(sun({0, 0, 1}), 1e5, 0.5)), A + 1 + blinnStraight(0.5, 1e5)),
          inBlinns(aside(200, 2))}},
    };
}

std::vector<Row> vertexRows() {
    return {
        {"P18",
         "highlight between vertices",
         "per vertex",
         Kind::shading,
         {perVertex(shiny(sun({0, 0, 1}), 30)), perVertex(inBlinns(shiny(bulb(1, 2), 5)))}},
        {"P19",
         "per vertex, scaled",
         "d = 1e25; sizes 1e-20, 1e17; 3e8 away",
         Kind::shading,
         {perVertex(shiny({Lamp::bulb, {1e25, 1e24, 1e25}, 1, 0, 0, {1, 0.5, 0.25}}, 5)),
          perVertex(sized(1e-20, aside(5, 0))), perVertex(sized(1e17, aside(5, 0))),
          perVertex(farFromTheOrigin(aside(5, 2)))}},
        {"P20",
         "per vertex, overflowing",
         "D = 300, K_S = 1e36, L = 1e36",
         Kind::shading,
         {tooBright(), sized(0.1, tooBright())}},
        {"P21",
         "per vertex, light in a vertex",
         "P = Q; zero normals",
         Kind::shading,
         {expecting(perVertex(shiny({Lamp::bulb, {3, 3, 0}, 1, 2, 0, glm::dvec3(1)}, 30)), A, exactly),
          perVertex(withoutNormals(shiny(bulb(1, 0), 30)))}},
        {"P22", "per vertex, the eye in a vertex", "v = 0", Kind::shading, {}, {}, vertexInTheEye},
    };
}

}  // namespace

std::vector<Row> phongRows() {
    std::vector<Row> all = exponentRows();
    for (const auto& part : {strengthRows(), vertexRows()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace stability
