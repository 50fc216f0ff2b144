// Rows G1 to G17: normals and triangles.
// SPDX-License-Identifier: MIT
#include "stability/gouraud.hpp"
#include "stability/peers.hpp"
#include "stability/rows.hpp"
#include "stability/sphere.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace stability {

namespace {

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
using Normals = std::array<glm::dvec3, 4>;

Normals all(const glm::dvec3& n) { return {n, n, n, n}; }

// Unit normals, `degrees` apart between the left and the right corners of the plane.
Normals apart(double degrees) {
    const double half = degrees / 2 * std::numbers::pi / 180;
    const glm::dvec3 left(-std::sin(half), 0, std::cos(half)), right(std::sin(half), 0, std::cos(half));
    return {left, right, left, right};
}

// A light from the front, 45 degrees from the middle's normal, so that a tilt shows in its cosine.
Lamp slanting() { return sun({1, 0, 1}); }

// A row of G8's mesh: the plane's four corners and a fifth vertex on one of its edges, which makes a collinear triangle.
void collinear(Outcome& outcome) {
    THREE::BufferGeometry with, without;
    const std::vector<double> corners{-3, 3, 0, 3, 3, 1, -3, -3, 0.5, 3, -3, 2, 0, 3, 0.5};
    with.setAttribute("position", corners, 3).setIndex({0, 4, 1, 0, 2, 1, 2, 3, 1});
    without.setAttribute("position", corners, 3).setIndex({0, 2, 1, 2, 3, 1});
    with.computeVertexNormals();
    without.computeVertexNormals();
    for (std::size_t i = 0; i < 4; ++i)
        require(outcome, with.getAttribute("normal")->getXYZ(i) == without.getAttribute("normal")->getXYZ(i),
                "the collinear triangle changes the normal of vertex " + std::to_string(i));
    require(outcome, with.getAttribute("normal")->getXYZ(4) == THREE::Vector3(0, 0, 0),
            "the vertex of nothing but a collinear triangle has a normal that is not zero");
    const float naive = naiveTriangleNormal({-3, 3, 0}, {0, 3, 0.5F}, {3, 3, 1}).x;
    outcome.naive = {"normal " + number(naive), std::isfinite(naive) ? Peer::ok : Peer::notFinite};
}

constexpr double leaning = 0.5;  // radians, in G17

// The length of an axis after a million turns, each about z.
void incremental(Outcome& outcome) {
    constexpr int turns = 1'000'000;
    constexpr double step = 7 * 2 * std::numbers::pi / turns;
    THREE::Object3D object;
    for (int i = 0; i < turns; ++i)
        object.rotation.z += step;
    object.updateMatrixWorld();
    const double length = THREE::Vector3(glm::dvec3(object.matrixWorld.elements[0])).length();
    require(outcome, std::abs(length - 1) <= 16 * support::u,
            "an axis is " + std::to_string(length) + " long");
    const double right = std::cos(leaning);
    outcome.naive = peer(A + right * naiveSpunLength(turns, step), A + right);
    outcome.legacy = outcome.physical = peer(A + right * length, A + right);  // three.js keeps angles, too
}

Setup zeroNormals() {
    Setup s{{bulb(1, 0)}};
    s.normals = all({0, 0, 0});
    s.bound = exactly;
    s.expected = A;
    return s;
}

Setup oppositeNormals() {
    Setup s =
        zeroNormals();  // the light stands at right angles to both, so that rounding has no side to fall to
    s.normals = {{{-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0}}};
    return s;
}

Setup lengthOfNormals(double length) {
    Setup s{{bulb(1, 0)}};
    s.normals = all({0, 0, length});
    s.expected = A + 1;
    return s;
}

Setup badNormal() {
    Setup s = lengthOfNormals(1);
    s.normals[2].y = NaN;
    s.normals[1].y = NaN;
    s.refused = {"Mesh 'piano'", "geometry.attributes.normal"};
    return s;
}

Setup between(double degrees, Lamp lamp, Bound bound, double expected) {
    Setup s{{lamp}};
    s.normals = apart(degrees);
    s.bound = bound;
    s.expected = expected;
    return s;
}

Setup generated(double size) {
    Setup s{{sun({0, 0, 1})}};
    s.generatedNormals = true;
    s.size = size;
    s.expected = A + 1;
    return s;
}

// In coordinates of a map: 1e4 from the origin of the mesh's own space, a thousandth across.
Setup farSmall() {
    Setup s = generated(1e-3 / 6);
    s.turn = THREE::Quaternion().setFromAxisAngle({1, 2, -0.5}, 0.7);
    s.lamps = {sun(glm::dquat(s.turn) * glm::dvec3(1, 0, 1))};
    s.expected.reset();  // generated normals of such vertices are good for 9 digits only, in doubles
    s.centre = {1e4, -1.1e4, 1.3e4};
    s.placeInVertices = true;
    return s;
}

Setup grazing(Lamp lamp) {
    Setup s{{lamp}};
    s.bound = exactly;
    s.expected = A;
    return s;
}

// n . (P - Q) is the difference of two products of about 0.5.
Setup cancelling() {
    Setup s{{{Lamp::bulb, {0.8, -0.6 + 3.5e-8, 0}, 1, 0, 0, glm::dvec3(1)}}};
    s.normals = all({0.6, 0.8, 0});
    s.bound = {Bound::uS, 4};
    return s;
}

Setup turnedAMillionTimes() {
    Setup s{{sun({0, 0, 1})}};
    s.pose = [](THREE::Mesh& mesh) {  // the whole turns do nothing; their sum in doubles is off by 1e-9
        constexpr int turns = 1'000'000;
        for (int i = 0; i < turns; ++i)
            mesh.rotation.x += 7 * 2 * std::numbers::pi / turns;
        mesh.rotation.x += leaning;
    };
    s.expected.reset();
    return s;
}

std::vector<Row> normalRows() {
    const double half = std::numbers::sqrt2 / 2;
    return {
        {"G1",
         "zero normal",
         "opposite vertex normals meet",
         Kind::shading,
         {zeroNormals(), oppositeNormals()}},
        {"G2", "tiny normal", "(0, 0, 1e-23)", Kind::shading, {lengthOfNormals(1e-23)}},
        {"G3", "huge normal", "(0, 0, 1e20)", Kind::shading, {lengthOfNormals(1e20)}},
        {"G4", "denormal normal", "(0, 0, 1e-40)", Kind::shading, {lengthOfNormals(1e-40)}},
        {"G5", "NaN in a normal", "a bad file", Kind::refused, {badNormal()}},
        {"G6",
         "unnormalised interpolation",
         "45 degrees between normals",
         Kind::shading,
         {between(45, sun({0, 0, 1}), {Bound::uS, 4}, A + 1)},
         {},
         [](Outcome& o) { o.naive = peer(A + std::cos(22.5 * std::numbers::pi / 180), A + 1); }},
        {"G7",
         "almost opposite normals",
         "179.99 degrees between normals",
         Kind::shading,
         {between(179.99, slanting(), {Bound::code, 0.1}, A + half)}},
    };
}

std::vector<Row> triangleRows() {
    return {
        {"G8", "collinear triangle", "three points of a line", Kind::shading, {generated(1)}, {}, collinear},
        {"G9", "minute triangle", "edges of 1e-20", Kind::shading, {generated(1e-20 / 6)}},
        {"G10", "giant triangle", "edges of 1e13", Kind::shading, {generated(1e13 / 6)}},
        {"G11", "small triangle far away", "edges of 1e-3 at 1e4", Kind::shading, {farSmall()}},
    };
}

std::vector<Row> cosineRows() {
    return {
        {"G12",
         "exactly grazing",
         "n . w = 0",
         Kind::shading,
         {grazing(sun({1, 0, 0})), grazing({Lamp::bulb, {1, 0, 0}, 1, 0, 0, glm::dvec3(1)})}},
        {"G13",
         "just behind",
         "n . w = -1e-8",
         Kind::shading,
         {grazing(sun({1, 0, -1e-8})), grazing({Lamp::bulb, {1, 0, -1e-8}, 1, 2, 0, glm::dvec3(1)})}},
        {"G14", "cancelling dot product", "n . (P - Q) = 2.8e-8", Kind::shading, {cancelling()}},
        {"G15", "terminator, per vertex", "64 segments", Kind::shading, {}, {}, terminator},
        {"G16", "near light on a sphere", "1.05 R, 32 segments", Kind::shading, {}, {}, nearSphere},
        {"G17",
         "incremental rotation",
         "10^6 turns",
         Kind::shading,
         {turnedAMillionTimes()},
         {},
         incremental},
    };
}

}  // namespace

std::vector<Row> geometryRows() {
    std::vector<Row> all = normalRows();
    for (const auto& part : {triangleRows(), cosineRows()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace stability
