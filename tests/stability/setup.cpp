// Builds the scenes of the stability suite and runs them three ways.
// SPDX-License-Identifier: MIT
#include "stability/setup.hpp"

#include "lighting/reference/reference.hpp"
#include "support/strict_glsl.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>

namespace stability {

using support::u;

namespace {

constexpr long double largestFloat = std::numeric_limits<float>::max();

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

Stage::Stage(const Setup& setup, double size) : options{setup.pixels, setup.pixels, true, {}} {
    scene.name = "scena";
    camera.name = "occhio";
    mesh.name = "piano";
    material.color.set(setup.albedo.r, setup.albedo.g, setup.albedo.b);
    addPlane(setup, size);
    if (setup.pose)
        setup.pose(mesh);
    if (setup.ambient > 0) {
        ambient_.color.set(setup.ambient, setup.ambient, setup.ambient);
        scene.add(ambient_);
    }
    for (std::size_t i = 0; i < setup.lamps.size(); ++i)
        addLamp(setup.lamps[i], setup.centre, i);
    camera.near = 0.1 * size;
    camera.far = 10 * size;
    const glm::dvec3 away = glm::dmat3(glm::mat3_cast(glm::dquat(setup.turn)))[2] * (2 * size);
    camera.position = setup.centre + away;
    if (away.x != 0 || away.y != 0)
        camera.quaternion = setup.turn;
    options.settings.focus = setup.focus.value_or(setup.centre);
    options.settings.focusDistance = 2 * size;
}

// The vertices and triangles of a PlaneGeometry; its type would be written to JSON without the normals.
void Stage::addPlane(const Setup& setup, double size) {
    const glm::dmat3 turn = glm::mat3_cast(glm::dquat(setup.turn));
    std::vector<double> positions, normals;
    const auto push = [](std::vector<double>& to, const glm::dvec3& v) {
        to.insert(to.end(), {v.x, v.y, v.z});
    };
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 corner(i % 2 == 0 ? -3 * size : 3 * size, i < 2 ? 3 * size : -3 * size, 0);
        push(positions, setup.placeInVertices ? turn * corner + setup.centre : corner);
        push(normals, setup.placeInVertices ? turn * setup.normals[i] : setup.normals[i]);
    }
    geometry.setAttribute("position", positions, 3).setIndex({0, 2, 1, 2, 3, 1});
    if (setup.generatedNormals)
        geometry.computeVertexNormals();
    else
        geometry.setAttribute("normal", normals, 3);
    if (!setup.placeInVertices) {
        mesh.position = setup.centre;
        mesh.quaternion = setup.turn;
    }
    scene.add(mesh);
}

void Stage::addLamp(const Lamp& lamp, const glm::dvec3& centre, std::size_t number) {
    const THREE::Color color(lamp.color.r, lamp.color.g, lamp.color.b);
    if (lamp.kind == Lamp::sun) {
        lights_.push_back(std::make_unique<THREE::DirectionalLight>(color, lamp.intensity));
        lights_.back()->name = "sole" + std::to_string(number);
        lights_.back()->position = lamp.place;
    } else {
        lights_.push_back(
            std::make_unique<THREE::PointLight>(color, lamp.intensity, lamp.distance, lamp.decay));
        lights_.back()->name = "lampada" + std::to_string(number);
        lights_.back()->position = centre + lamp.place;
    }
    scene.add(*lights_.back());
}

std::string Stage::refusal() {
    camera.aspect = 1;
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    try {
        THREE::validate(scene, camera);
    } catch (const THREE::SceneError& error) {
        return error.what();
    }
    return "";
}

lighting::FramePlan Stage::plan() {
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    return lighting::planFrame(scene, camera, options.settings);
}

namespace {

glm::vec<3, long double> held(const glm::vec<3, long double>& v) {
    return glm::clamp(v, -largestFloat, largestFloat);
}

// Halfway between two opposite corners, object space.
THREE::Vector3 middleOf(const THREE::BufferGeometry& geometry) {
    const THREE::BufferAttribute& position = *geometry.getAttribute("position");
    return position.getXYZ(1).add(position.getXYZ(2)).multiplyScalar(0.5);
}

}  // namespace

Truth truth(Stage& stage) {
    using namespace lighting::reference;
    using Vec = Vec3<long double>;
    const auto place = placeOf<long double>(stage.mesh);
    const Planes<long double> planes(place);
    const auto normal = [&](std::size_t i) {
        return planes.normal(unit(toVec<long double>(stage.geometry.getAttribute("normal")->getXYZ(i))));
    };
    // About the point itself: near lights would lose digits about anything else.
    const Vec Q = place.direction(toVec<long double>(middleOf(stage.geometry))) + place.origin;
    const Vec n = unit(normal(1) + normal(2)), D = toVec<long double>(stage.material.color);
    const auto at = [&](const lighting::TermSet& terms) {
        return makeEquation<long double>(stage.scene, terms, Q).lighting(n, Vec(0), D);
    };
    const lighting::TermSet terms = stage.options.settings.terms;
    return {held(at(terms)), at(terms.without(lighting::Term::cosine))};
}

Twin twin(Stage& stage) {
    const lighting::FramePlan plan = stage.plan();
    if (plan.draws.size() != 1)
        return {glm::vec3(std::numeric_limits<float>::quiet_NaN()), true};
    const lighting::Draw& draw = plan.draws[0];
    const THREE::BufferGeometry& geometry = *draw.mesh->geometry;
    const auto corner = [&](std::size_t i) {
        return support::strictVertex(draw, geometry.getAttribute("position")->getXYZ(i),
                                     geometry.getAttribute("normal")->getXYZ(i));
    };
    const glm::vec3 Q = support::strictVertex(draw, middleOf(geometry), {0, 0, 1}).worldPosition;
    const glm::vec3 n = 0.5F * corner(1).worldNormal + 0.5F * corner(2).worldNormal;
    const support::StrictFragment fragment = support::strictFragment(plan, draw, Q, n);
    return {fragment.P, fragment.nonfinite};
}

namespace {

// Notes the error of three channels, and what misses the bound.
void judge(const Setup& setup, const Truth& truth, const glm::vec3& found, const std::string& who,
           Measured& into) {
    const bool exact = setup.bound.unit == Bound::exact;
    for (int c = 0; c < 3; ++c) {
        // Exact means: the float that is nearest to the truth.
        const long double expected =
            exact ? static_cast<long double>(static_cast<float>(truth.P[c])) : truth.P[c];
        const double off = static_cast<double>(std::abs(static_cast<long double>(found[c]) - expected));
        const double S = static_cast<double>(std::min(truth.S[c], largestFloat));
        if (setup.bound.unit != Bound::code)
            into.error = std::max(into.error, off > 0 ? off / (u * S) : 0);
        if (off <= setup.bound.tolerance(truth.P[c], truth.S[c]))  // false for NaN
            continue;
        std::ostringstream out;
        out.precision(10);
        out << who << ": channel " << c << " is " << found[c] << ", expected " << expected << " within "
            << setup.bound.text() << ", S " << S << ", off by " << off << " = " << off / (u * S) << " u S";
        into.failures.push_back(out.str());
    }
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
    into.expected = static_cast<double>(t.P[setup.channel]);
    if (setup.expected && !(std::abs(into.expected - *setup.expected) <= 1e-12 * std::abs(*setup.expected)))
        into.failures.push_back("the reference says " + std::to_string(into.expected) +
                                ", the closed value is " + std::to_string(*setup.expected) + where.str());
    const Twin strict = twin(stage);
    into.twin = strict.P[setup.channel];
    judge(setup, t, strict.P, "strict IEEE" + where.str(), into);
    if (strict.nonfinite)
        into.failures.push_back("strict IEEE" + where.str() + " met NaN or infinity before a clamp");
    if (draws) {
        const lighting::reference::Reference<long double> reference(
            stage.scene, stage.camera, stage.options.settings.terms, setup.pixels, setup.pixels);
        const glm::vec<3, long double> seen = held(reference.probe(stage.middle(), stage.middle()).P);
        for (int c = 0; c < 3; ++c)
            if (!(std::abs(seen[c] - t.P[c]) <= 1e-12L * std::min(t.S[c], largestFloat)))
                into.failures.push_back("the reference sees " + std::to_string(seen[c]) +
                                        " in the middle pixel, its equation says " + std::to_string(t.P[c]) +
                                        where.str());
        const glm::vec3 pixel =
            support::draw(stage.scene, stage.camera, stage.options).at(stage.middle(), stage.middle());
        into.gl = pixel[setup.channel];
        judge(setup, t, pixel, "GL" + where.str(), into);
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
    return into;
}

}  // namespace stability
