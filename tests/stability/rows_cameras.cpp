// Rows C1 to C7: views, rotations, and scenes far from the origin.
// SPDX-License-Identifier: MIT
#include "stability/far_away.hpp"
#include "stability/rows.hpp"
#include "three/validate.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace stability {

namespace {

using THREE::Vector3;

template <class Matrix>
int notFinite(const Matrix& m) {
    int count = 0;
    for (int i = 0; i < 16; ++i)
        count += std::isfinite(m[i / 4][i % 4]) ? 0 : 1;
    return count;
}

Peer counted(int bad) {
    return {std::to_string(bad) + " of 16 not finite", bad == 0 ? Peer::ok : Peer::notFinite};
}

// Orthonormal and right-handed, or what it is instead.
Peer basis(const glm::dmat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    if (notFinite(m) > 0)
        return counted(notFinite(m));
    const double off =
        glm::length(glm::cross(x, y) - z) + std::abs(glm::length(x) - 1) + std::abs(glm::length(y) - 1);
    return off < 1e-9 ? Peer{"a basis", Peer::ok} : Peer{"no basis", Peer::wrong};
}

// three.js's Matrix4.lookAt, in double as there.
glm::dmat4 threeLookAt(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
    const auto normalized = [](const glm::dvec3& v) {
        const double length = glm::length(v);
        return v / (length != 0 ? length : 1.0);
    };
    glm::dvec3 z = eye - target;
    if (glm::dot(z, z) == 0)
        z.z = 1;
    z = normalized(z);
    glm::dvec3 x = glm::cross(up, z);
    if (glm::dot(x, x) == 0) {
        (std::abs(up.z) == 1 ? z.x : z.z) += 0.0001;
        z = normalized(z);
        x = glm::cross(up, z);
    }
    x = normalized(x);
    return {glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), glm::dvec4(0, 0, 0, 1)};
}

struct View {
    Vector3 eye, target, up{0, 1, 0};
};

// A camera that was told to look there; what others make of the same three vectors.
void look(const View& view, const glm::dvec3& expectedZ, Outcome& outcome) {
    THREE::PerspectiveCamera camera;
    camera.position = view.eye;
    camera.up = view.up;
    camera.lookAt(view.target);
    camera.updateWorldMatrix();
    const glm::dmat4 m = camera.matrixWorld;
    require(outcome, basis(m).verdict == Peer::ok, "the camera's axes are no right-handed orthonormal basis");
    require(outcome, glm::length(glm::dvec3(m[2]) - expectedZ) < 1e-12, "the camera looks another way");
    outcome.naive =
        counted(notFinite(glm::lookAt(glm::vec3(glm::dvec3(view.eye)), glm::vec3(glm::dvec3(view.target)),
                                      glm::vec3(glm::dvec3(view.up)))));
    outcome.naive.text = "GLM: " + outcome.naive.text;
    outcome.legacy = outcome.physical = basis(threeLookAt(view.eye, view.target, view.up));
    outcome.expected = outcome.twin = outcome.gl = "a basis";
    outcome.bound = "finite";
}

Setup facing() {
    Setup s{{sun({0, 0, 1})}};
    s.expected = A + 1;
    return s;
}

// The camera over a floor, its `up` along the view: the picture is what any other `up` would show in the middle.
void straightDown(Outcome& outcome) {
    for (const double side : {1.0, -1.0}) {
        Setup s = facing();
        Stage stage(s, 1);
        stage.camera.up.set(0, 0, side);
        stage.camera.lookAt(0, 0, 0);
        const glm::vec3 pixel =
            support::draw(stage.scene, stage.camera, stage.options).at(stage.middle(), stage.middle());
        require(outcome, std::abs(pixel.r - (A + 1)) <= 16 * support::u * (A + 1),
                "the floor is " + number(pixel.r));
    }
    look({{0, 5, 0}, {0, 0, 0}}, {0, 1, 0}, outcome);
}

// The whole camera is refused, though nothing would become NaN.
void noUp(Outcome& outcome) {
    look({{0, 0, 5}, {0, 0, 0}, {0, 0, 0}}, {0, 0, 1}, outcome);
    Stage stage(facing(), 1);
    stage.camera.up.set(0, 0, 0);
    const std::string refusal = stage.refusal();
    require(outcome,
            refusal.find("PerspectiveCamera 'occhio'") != std::string::npos &&
                refusal.find("up") != std::string::npos,
            "expected a refusal of up, found '" + refusal + "'");
    outcome.expected = outcome.twin = outcome.gl = "refused";
    outcome.bound = "names up";
}

// A field of the camera that leaves no projection.
void spoilt(const std::string& field, const std::function<void(THREE::PerspectiveCamera&)>& spoil,
            Outcome& outcome) {
    Stage stage(facing(), 1);
    stage.scene.updateMatrixWorld();
    stage.camera.aspect = 1;
    spoil(stage.camera);
    stage.camera.updateWorldMatrix();
    std::string refusal;
    try {
        THREE::validate(stage.scene, stage.camera);
    } catch (const THREE::SceneError& error) {
        refusal = error.what();
    }
    require(outcome,
            refusal.find("PerspectiveCamera 'occhio'") != std::string::npos &&
                refusal.find(field) != std::string::npos,
            "expected a refusal of " + field + ", found '" + refusal + "'");
}

// three.js's makePerspective, in double as there.
glm::dmat4 threePerspective(double fov, double aspect, double near, double far) {
    const double top = near * std::tan(fov / 2), right = aspect * top;
    glm::dmat4 m(0);
    m[0][0] = 2 * near / (2 * right);
    m[1][1] = 2 * near / (2 * top);
    m[2] = {(right - right) / (2 * right), (top - top) / (2 * top), -(far + near) / (far - near), -1};
    m[3][2] = -2 * far * near / (far - near);
    return m;
}

void projections(Outcome& outcome) {
    spoilt(
        "fov", [](auto& camera) { camera.fov = 0; }, outcome);
    spoilt(
        "near", [](auto& camera) { camera.far = camera.near; }, outcome);
    spoilt(
        "aspect", [](auto& camera) { camera.aspect = 1e-40; }, outcome);
    spoilt(
        "aspect", [](auto& camera) { camera.aspect = 0; }, outcome);
    int glmBad = 0, threeBad = 0;
    for (const auto& [fov, aspect, far] : {std::array{0.0, 1.0, 10.0}, {1.0, 1.0, 0.1}, {1.0, 1e-40, 10.0}}) {
        const auto f = [](double x) { return static_cast<float>(x); };
        glmBad += notFinite(glm::perspective(f(fov), f(aspect), 0.1F, f(far)));
        threeBad += notFinite(threePerspective(fov, aspect, 0.1, far));
    }
    outcome.naive = {"GLM: " + std::to_string(glmBad) + " not finite", Peer::notFinite};
    outcome.legacy = outcome.physical = {std::to_string(threeBad) + " not finite", Peer::notFinite};
    outcome.expected = outcome.twin = outcome.gl = "refused";
    outcome.bound = "names the field";
}

void noAxis(Outcome& outcome) {
    const THREE::Quaternion turned = THREE::Quaternion().setFromAxisAngle({0, 0, 0}, 1);
    const bool identity = turned.x == 0 && turned.y == 0 && turned.z == 0 && turned.w == 1;
    require(outcome, identity, "a turn about no axis is not the identity");
    outcome.naive = counted(notFinite(glm::rotate(glm::mat4(1), 1.0F, glm::vec3(0))));
    outcome.naive.text = "GLM: " + outcome.naive.text;
    outcome.legacy = outcome.physical = {"identity", Peer::ok};
    outcome.expected = outcome.twin = outcome.gl = "identity";
    outcome.bound = "exact";
}

Setup farEye() {
    Setup s = facing();
    s.size = 0.5e20;
    return s;
}

}  // namespace

std::vector<Row> cameraRows() {
    return {
        {"C1",
         "eye = target",
         "lookAt its own place",
         Kind::camera,
         {},
         {},
         [](Outcome& o) {
             look({{1, 2, 3}, {1, 2, 3}}, {0, 0, 1}, o);
         }},
        {"C2", "up parallel to view", "straight down", Kind::camera, {}, {}, straightDown},
        {"C3", "up = 0", "(0, 0, 0)", Kind::camera, {}, {}, noUp},
        {"C4",
         "eye at 1e20",
         "a plane of 3e20",
         Kind::camera,
         {farEye()},
         {},
         [](Outcome& o) {
             Outcome looking;
             look({{0, 0, 1e20}, {0, 0, 0}}, {0, 0, 1}, looking);
             o.failures.insert(o.failures.end(), looking.failures.begin(), looking.failures.end());
             o.naive = looking.naive;
         }},
        {"C5", "no projection", "fov 0; near = far; aspect 1e-40", Kind::camera, {}, {}, projections},
        {"C6", "rotate about (0, 0, 0)", "1 radian", Kind::camera, {}, {}, noAxis},
        {"C7", "scene at 1e5, 1e7", "offset", Kind::camera, {}, {}, farAway},
    };
}

}  // namespace stability
