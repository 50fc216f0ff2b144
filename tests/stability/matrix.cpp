// How a row with a model matrix is run: its normals, read out of the vertex shader and out of frames.
// SPDX-License-Identifier: MIT
#include "stability/peers.hpp"
#include "stability/rows.hpp"
#include "support/strict_glsl.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace stability {

namespace {

using Real = long double;
using Vec = glm::vec<3, Real>;

const std::vector<glm::dvec3> normals{{0.36, 0.48, 0.8}, {1, 0, 0},       {0, 1, 0},         {0, 0, 1},
                                      {0, 0, -1},        {0.6, 0.8, 0},   {0, 0.6, -0.8},    {-3, 2, 1},
                                      {0.1, -0.2, 5},    {1e-3, 1, 1e-3}, {-0.9, 0.1, -0.4}, {0.3, 0.7, 1}};

// Two tangents of the surface go where points go; their cross product is the new normal, turned round by a mirror.
Vec expectedNormal(const glm::dmat4& model, const glm::dvec3& normal) {
    const Vec a{glm::dvec3(model[0])}, b{glm::dvec3(model[1])}, c{glm::dvec3(model[2])};
    const auto carried = [&](const Vec& v) { return a * v.x + b * v.y + c * v.z; };
    const Vec n = glm::normalize(Vec(normal));
    const Vec aside = std::abs(n.x) < 0.5L ? Vec(1, 0, 0) : Vec(0, 1, 0);
    const Vec t1 = glm::normalize(glm::cross(n, aside)), t2 = glm::cross(n, t1);
    const Vec crossed = glm::cross(carried(t1), carried(t2));
    return glm::dot(a, glm::cross(b, c)) < 0 ? -crossed : crossed;
}

// 180 for what is not finite or has no direction.
double degreesBetween(const Vec& found, const Vec& expected) {
    const auto shortened = [](const Vec& v) {
        return v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    };
    const Vec a = shortened(found), b = shortened(expected);
    const Real angle =
        std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi_v<Real>;
    return std::isfinite(angle) && glm::length(a) > 0 ? static_cast<double>(angle) : 180;
}

// Lights along the axes, in the axis's own colour, and no clamp: the pixel is the normal.
struct NormalScene {
    THREE::Scene scene;
    THREE::Group outer;
    THREE::BufferGeometry geometry;
    THREE::MeshLambertMaterial material;
    THREE::Mesh mesh{geometry, material};
    THREE::DirectionalLight red{THREE::Color(1, 0, 0)}, green{THREE::Color(0, 1, 0)},
        blue{THREE::Color(0, 0, 1)};
    THREE::PerspectiveCamera camera{53.13010235415598};
    support::DrawOptions options{17, 17, true, {}};

    explicit NormalScene(const MatrixCase& matrix) {
        scene.add(outer, red, green, blue);
        outer.add(mesh);
        red.position.set(1, 0, 0);
        green.position.set(0, 1, 0);
        blue.position.set(0, 0, 1);
        material.side = THREE::FrontSide;
        if (matrix.nested) {
            outer.quaternion.setFromAxisAngle({1, 2, -0.5}, 1.1);
            mesh.quaternion.setFromAxisAngle({-0.3, 1, 0.9}, 2.3);
        }
        outer.scale = matrix.scale;
        options.settings.terms = options.settings.terms.without(lighting::Term::clamp);
        setNormal({0, 0, 1});
        scene.updateMatrixWorld();
        lookStraightAt();
    }
    const glm::dmat4& model() const { return mesh.matrixWorld; }
    void setNormal(const glm::dvec3& n) {
        std::vector<double> four;
        for (int i = 0; i < 4; ++i)
            four.insert(four.end(), {n.x, n.y, n.z});
        geometry.setAttribute("normal", four, 3);
    }
    // A camera straight above a part of the mesh's xy plane: the part whose image is some pictures long and wide, because
    // triangles that are a million times larger than the picture lose their digits in a driver's clipper.
    void lookStraightAt() {
        const Vec x{glm::dvec3(model()[0])}, y{glm::dvec3(model()[1])};
        const Vec across = expectedNormal(model(), {0, 0, 1}), g = glm::cross(x, y);
        const Vec along = glm::normalize(glm::length(x) > glm::length(y) ? x : y);
        const Vec beside = glm::cross(glm::normalize(across), along);
        const Real distance = glm::length(g) / std::max(glm::length(x), glm::length(y));
        std::vector<double> corners;
        for (const auto& [sideways, lengthways] :
             {std::pair<Real, Real>{-3, 100}, {-3, -100}, {3, 100}, {3, -100}}) {
            const Vec image = (beside * sideways + along * lengthways) * distance;  // = x s + y t
            const Real s = glm::dot(glm::cross(image, y), g) / glm::dot(g, g),
                       t = glm::dot(glm::cross(x, image), g) / glm::dot(g, g);
            corners.insert(corners.end(), {static_cast<double>(s), static_cast<double>(t), 0.0});
        }
        geometry.setAttribute("position", corners, 3).setIndex({0, 2, 1, 1, 2, 3});
        if (glm::dot(g, across) < 0)
            geometry.setIndex(
                {0, 1, 2, 1, 3, 2});  // mirrored: counter-clockwise in object space all the same
        camera.position = glm::dvec3(glm::normalize(across) * distance);
        camera.up = glm::dvec3(along);
        camera.lookAt(0, 0, 0);
        camera.near = 0.1 * static_cast<double>(distance);
        camera.far = 100 * static_cast<double>(distance);
        options.settings.focusDistance = static_cast<double>(distance);
    }
};

std::string degrees(double angle) { return angle == 180 ? "none" : number(angle) + " deg"; }

Peer peerNormal(const glm::vec3& found, const Vec& expected) {
    const double angle = degreesBetween(Vec(found), expected);
    if (!std::isfinite(found.x + found.y + found.z))
        return {"NaN", Peer::notFinite};
    if (found == glm::vec3(0))
        return {"(0, 0, 0)", Peer::wrong};
    return {number(angle) + " deg",
            angle <= 0.2 ? Peer::ok : Peer::wrong};  // at most one code: sin(0.22 deg) = 1/255
}

void askPeers(const glm::dmat4& model, const glm::dvec3& normal, Outcome& outcome) {
    const Vec truth = expectedNormal(model, normal);
    outcome.naive = peerNormal(naiveNormal(model, normal), truth);
    outcome.legacy = outcome.physical = peerNormal(threeNormal(model, normal), truth);
}

}  // namespace

void askMatrixPeers(const glm::dmat4& model, Outcome& outcome) { askPeers(model, normals[0], outcome); }

void runMatrix(const MatrixCase& matrix, Outcome& outcome) {
    NormalScene s(matrix);
    s.camera.updateWorldMatrix();
    const lighting::FramePlan plan = lighting::planFrame(s.scene, s.camera, s.options.settings);
    require(outcome, plan.draws.size() == 1, "the plane is not drawn");
    if (plan.draws.size() != 1)
        return;
    const glm::dvec3 shown = matrix.normal.value_or(normals[0]);
    double strict = 0, gl = 0;
    for (const glm::dvec3& n : normals) {
        const Vec found(support::strictVertex(plan.draws[0], {0, 0, 0}, n).worldNormal);
        if (expectedNormal(s.model(), n) == Vec(0)) {  // within a flattened plane: there is none
            require(outcome, found == Vec(0), "a normal that vanishes does not");
            continue;
        }
        require(outcome, std::abs(glm::length(found) - 1) < 4 * static_cast<Real>(support::u),
                "a normal is not of length 1");
        strict = std::max(strict, degreesBetween(found, expectedNormal(s.model(), n)));
    }
    for (const auto& [n, space] : {std::pair(shown, lighting::Space::world),
                                   {glm::dvec3(-0.9, 0.1, -0.4), lighting::Space::world},
                                   {shown, lighting::Space::view}}) {
        s.setNormal(n);
        s.options.settings.space = space;
        const glm::vec3 found = support::draw(s.scene, s.camera, s.options).at(8, 8);
        gl = std::max(gl, degreesBetween(Vec(found), expectedNormal(s.model(), n)));
    }
    require(outcome, strict <= matrix.degrees, "strict IEEE: a normal is off by " + degrees(strict));
    require(outcome, gl <= matrix.degrees, "GL: a normal is off by " + degrees(gl));
    askPeers(s.model(), shown, outcome);
    outcome.expected = "0 deg";
    outcome.twin = degrees(strict);
    outcome.gl = degrees(gl);
    outcome.bound = number(matrix.degrees) + " deg";
}

void modelMatrixForNormals(Outcome& outcome) {
    const glm::dmat4 model(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 2, 0, 0), glm::dvec4(0, 0, 3, 0),
                           glm::dvec4(0, 0, 0, 1));
    double worst = 0;
    for (const glm::dvec3& n : normals)
        worst = std::max(worst, degreesBetween(Vec(glm::dmat3(model) * n), expectedNormal(model, n)));
    outcome.naive = {number(worst) + " deg", Peer::wrong};
}

}  // namespace stability
