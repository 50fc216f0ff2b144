// Builds the scenes of the stability suite, and says what their middle pixel is.
// SPDX-License-Identifier: MIT
#include "stability/setup.hpp"

#include "lighting/reference/reference.hpp"
#include "support/shading.hpp"
#include "support/strict_glsl.hpp"
#include "three/validate.hpp"

#include <glm/geometric.hpp>
#include <limits>

namespace stability {

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
    look(setup, size);
    if (setup.gloss) {
        material.specular.set(setup.gloss->specular.r, setup.gloss->specular.g, setup.gloss->specular.b);
        material.shininess = setup.gloss->shininess;
        material.specularModel = setup.gloss->model;
    } else {
        material.specular.set(0x000000);
    }
    if (setup.perVertex)
        options.settings.shading = lighting::Shading::vertex;
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

void Stage::look(const Setup& setup, double size) {
    camera.near = 0.1 * size;
    camera.far = 10 * size;
    camera.position = setup.centre + glm::dquat(setup.turn) * (setup.eye * size);
    if (setup.eye.x != 0 || setup.eye.y != 0) {
        camera.up = glm::dquat(setup.turn) * glm::dvec3(0, 1, 0);
        camera.lookAt(setup.centre);
    } else {
        camera.quaternion = setup.turn;
    }
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

constexpr long double largestFloat = std::numeric_limits<float>::max();

glm::vec<3, long double> held(const glm::vec<3, long double>& v) {
    return glm::clamp(v, -largestFloat, largestFloat);
}

// Halfway between two opposite corners, object space.
THREE::Vector3 middleOf(const THREE::BufferGeometry& geometry) {
    const THREE::BufferAttribute& position = *geometry.getAttribute("position");
    return position.getXYZ(1).add(position.getXYZ(2)).multiplyScalar(0.5);
}

}  // namespace

namespace {

using namespace lighting::reference;
using Vec = Vec3<long double>;

// The equation at a point of the plane. About the point itself: near lights would lose digits about anything else, so that
// highlights, which need to know the eye, are added light by light.
Truth truthAt(const Stage& stage, const Vec& Q, const Vec& n) {
    const lighting::TermSet terms = stage.options.settings.terms;
    const Lit<long double> matt{n, Vec(0), toVec<long double>(stage.material.color), {}};
    const Lit<long double> glossy{n, Q - placeOf<long double>(stage.camera).origin, matt.D,
                                  glossOf<long double>(stage.material, {})};
    Truth t{Vec(0), Vec(0)};
    const auto addHighlight = [&](const Addend<long double>& addend) {
        const Vec arriving = addend.f * addend.L;
        t.P += arriving * Equation<long double>::highlight(glossy, addend.w);
        t.S += arriving * support::highlightStrength(glossy, addend.w);
    };
    t.P += makeEquation<long double>(stage.scene, terms, Q).lighting(matt, addHighlight);
    t.S += makeEquation<long double>(stage.scene, terms.without(lighting::Term::cosine), Q).lighting(matt);
    return t;
}

}  // namespace

Truth truth(Stage& stage) {
    const auto place = placeOf<long double>(stage.mesh);
    const Planes<long double> planes(place);
    const auto normal = [&](std::size_t i) {
        return planes.normal(unit(toVec<long double>(stage.geometry.getAttribute("normal")->getXYZ(i))));
    };
    const auto point = [&](const THREE::Vector3& local) {
        return place.direction(toVec<long double>(local)) + place.origin;
    };
    const auto corner = [&](std::size_t i) {
        return truthAt(stage, point(stage.geometry.getAttribute("position")->getXYZ(i)), normal(i));
    };
    if (stage.options.settings.shading != lighting::Shading::vertex) {
        const Truth t = truthAt(stage, point(middleOf(stage.geometry)), unit(normal(1) + normal(2)));
        return {held(t.P), held(t.S)};
    }
    const Truth a = corner(1), b = corner(2);
    return {held((held(a.P) + held(b.P)) * 0.5L), held((held(a.S) + held(b.S)) * 0.5L)};
}

namespace {

// Halfway between two opposite corners, as a rasteriser interpolates there.
support::StrictFragment gouraudTwin(const lighting::FramePlan& plan, const lighting::Draw& draw) {
    const THREE::BufferGeometry& geometry = *draw.mesh->geometry;
    const auto corner = [&](std::size_t i) {
        return support::strictGouraudVertex(plan, draw, geometry.getAttribute("position")->getXYZ(i),
                                            geometry.getAttribute("normal")->getXYZ(i));
    };
    const support::StrictGouraudVertex a = corner(1), b = corner(2);
    return support::strictGouraudFragment(
        draw, {0.5F * a.clip + 0.5F * b.clip, 0.5F * a.frontColor + 0.5F * b.frontColor,
               0.5F * a.backColor + 0.5F * b.backColor, 0.5F * a.metNonfinite + 0.5F * b.metNonfinite});
}

}  // namespace

Twin twin(Stage& stage) {
    const lighting::FramePlan plan = stage.plan();
    if (plan.draws.size() != 1)
        return {glm::vec3(std::numeric_limits<float>::quiet_NaN()), true};
    const lighting::Draw& draw = plan.draws[0];
    if (draw.variant.perVertex) {
        const support::StrictFragment fragment = gouraudTwin(plan, draw);
        return {fragment.P, fragment.nonfinite};
    }
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

}  // namespace stability
