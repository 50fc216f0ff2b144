// The lab's frames, and hand-written ones.
// SPDX-License-Identifier: MIT
#include "bench/scenes.hpp"

#include "render/shader_source.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <string>

namespace bench {

Stage::Stage(double distance) {
    camera.position = THREE::Vector3(0.3, 0.25, 1).normalize().multiplyScalar(distance);
    camera.lookAt(0, 0, 0);
}

THREE::Mesh& Stage::mesh(THREE::BufferGeometry& geometry, THREE::Material& material) {
    return scene.add(std::make_unique<THREE::Mesh>(geometry, material));
}

THREE::PointLight& Stage::point(const THREE::Vector3& position, double intensity, double distance,
                                double decay) {
    THREE::PointLight& light =
        scene.add(std::make_unique<THREE::PointLight>(THREE::Color(0xDD6666), intensity, distance, decay));
    light.position = position;
    return light;
}

void Stage::lectureLights() {
    scene.add(std::make_unique<THREE::DirectionalLight>()).position.set(0, 3, -2);
    point({2, 1.5, 5}, 1, 0, 0);
    scene.add(std::make_unique<THREE::AmbientLight>(THREE::Color(0x101010)));
}

void Stage::lightsAround(int n) {
    for (int i = 0; i < n; ++i) {  // a spiral over the sphere
        const double y = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - y * y), turn = i * 2.399963;
        point({4 * r * std::cos(turn), 4 * y, 4 * r * std::sin(turn)}, 10.0 / n, 0, 2);
    }
}

void Stage::lightsWithin(int n, const THREE::Vector3& half, double distance) {
    const int side = std::max(1, static_cast<int>(std::ceil(std::cbrt(n))));
    const auto at = [side](int i) { return (2 * i + 1.0) / side - 1; };
    for (int i = 0; i < n; ++i)
        point({half.x * at(i % side), half.y * at(i / side % side), half.z * at(i / side / side)}, 0.002,
              distance, 2);
}

Ours::Ours(Stage& stage, int width, int height, render::Compile when)
    : renderer(render::findShaderDirectory(""), when), stage_(stage), request_{width, height, false} {
    stage.camera.aspect = static_cast<double>(width) / height;
}

void Ours::update() {
    stage_.scene.updateMatrixWorld();
    stage_.camera.updateWorldMatrix();
    THREE::validate(stage_.scene, stage_.camera);
}

void Ours::draw() {
    update();
    renderer.renderOnly(stage_.scene, stage_.camera, settings, request_);
}

image::Frame Ours::frame() {
    update();
    return renderer.render(stage_.scene, stage_.camera, settings, request_);
}

void Ours::settle() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < 8 && Clock::now() - start < std::chrono::seconds(2); ++i)
        draw();
}

int Ours::covered() {
    const image::Frame drawn = frame();
    const auto& codes = std::get<image::Bytes>(drawn.pixels);
    int count = 0;
    for (std::size_t i = 0; i < codes.size(); i += 3)
        count += (codes[i] | codes[i + 1] | codes[i + 2]) != 0 ? 1 : 0;
    return count;
}

namespace {

const char* const vertexShader = R"(#version 300 es
precision highp float;
layout(location = 0) in vec3 p; layout(location = 1) in vec3 q;
uniform mat4 clip, place; uniform mat3 turn; out vec3 n; out vec3 Q;
void main() { Q = vec3(place * vec4(p, 1.0)); n = normalize(turn * q); gl_Position = clip * vec4(p, 1.0); })";

template <int size>
std::vector<float> floats(const glm::mat<size, size, double>& m) {
    std::vector<float> values;
    for (int column = 0; column < size; ++column)
        for (int row = 0; row < size; ++row)
            values.push_back(static_cast<float>(m[column][row]));
    return values;
}

probe::Mesh upload(const THREE::BufferGeometry& geometry) {
    const THREE::BufferAttribute &position = *geometry.getAttribute("position"),
                                 &normal = *geometry.getAttribute("normal");
    std::vector<float> vertices;
    vertices.reserve(geometry.vertexCount() * 6);
    for (std::size_t i = 0; i < geometry.vertexCount(); ++i)
        for (const THREE::Vector3& v : {position.getXYZ(i), normal.getXYZ(i)})
            vertices.insert(vertices.end(),
                            {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
    return probe::upload(vertices, geometry.index);
}

}  // namespace

Probe::Probe(Stage& stage, int width, int height, const std::string& fragmentShader)
    : target_(probe::makeTarget(width, height)) {
    if (fragmentShader.empty())
        return;
    program_ = probe::link(vertexShader, fragmentShader.c_str());
    clip_ = glGetUniformLocation(program_, "clip");
    place_ = glGetUniformLocation(program_, "place");
    turn_ = glGetUniformLocation(program_, "turn");
    stage.camera.aspect = static_cast<double>(width) / height;
    stage.scene.updateMatrixWorld();
    stage.camera.updateWorldMatrix();
    const glm::dmat4 view =
        stage.camera.projectionMatrix().elements * stage.camera.matrixWorldInverse().elements;
    std::map<const THREE::BufferGeometry*, std::size_t> known;
    stage.scene.traverseVisible([&](const THREE::Object3D& object) {
        const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object);
        if (mesh == nullptr)
            return;
        const auto [found, isNew] = known.try_emplace(&*mesh->geometry, meshes_.size());
        if (isNew)
            meshes_.push_back(upload(*mesh->geometry));
        const glm::dmat4& place = mesh->matrixWorld.elements;
        placed_.push_back(
            {found->second, floats<4>(view * place), floats<4>(place), floats<3>(glm::dmat3(place))});
    });
}

Probe::~Probe() {
    glDeleteProgram(program_);
    for (const probe::Mesh& mesh : meshes_)
        probe::release(mesh);
    probe::release(target_);
}

void Probe::draw() {
    probe::begin(target_);
    if (program_ != 0)
        glUseProgram(program_);
    for (const Placed& one : placed_) {
        glUniformMatrix4fv(clip_, 1, GL_FALSE, one.clip.data());
        glUniformMatrix4fv(place_, 1, GL_FALSE, one.place.data());
        glUniformMatrix3fv(turn_, 1, GL_FALSE, one.turn.data());
        probe::draw(meshes_[one.mesh]);
    }
    glFinish();
}

image::Frame Probe::frame() {
    draw();
    const std::vector<std::uint8_t> rgba = probe::read(target_);
    image::Bytes codes;
    for (int y = target_.height - 1; y >= 0; --y)
        for (int x = 0; x < target_.width; ++x) {
            const auto first = rgba.begin() + (static_cast<std::ptrdiff_t>(y) * target_.width + x) * 4;
            codes.insert(codes.end(), first, first + 3);
        }
    return {target_.width, target_.height, codes};
}

const char* const flatShader = R"(#version 300 es
precision highp float;
uniform vec3 D; out vec4 c;
void main() { c = vec4(D, 1.0); })";

const char* const lectureShader = R"(#version 300 es
precision highp float;
in vec3 n; in vec3 Q; out vec4 c;
uniform vec3 D, w, L1, P2, L2, LA;
void main() { vec3 m = normalize(n); vec3 v = P2 - Q;
  c = vec4(max(0.0, dot(m, w)) * D * L1 + max(0.0, dot(m, v)) / sqrt(dot(v, v)) * D * L2 + D * LA, 1.0); })";

std::string loopShader(int n) {
    return "#version 300 es\nprecision highp float;\nin vec3 n; in vec3 Q; out vec4 c;\nuniform vec3 D, P[" +
           std::to_string(n) + "], L[" + std::to_string(n) +
           "];\nvoid main() { vec3 m = normalize(n), s = vec3(0.0);\n  for (int i = 0; i < " +
           std::to_string(n) +
           "; ++i) { vec3 v = P[i] - Q; float d2 = dot(v, v);\n"
           "    s += max(0.0, dot(m, v)) / (d2 * sqrt(d2)) * D * L[i]; }\n  c = vec4(s, 1.0); }";
}

void setLights(const Probe& probe, const Stage& stage) {
    glUseProgram(probe.program());
    std::vector<float> places, colors;
    const auto vec3 = [&probe](const char* name, double x, double y, double z) {
        glUniform3f(glGetUniformLocation(probe.program(), name), static_cast<float>(x), static_cast<float>(y),
                    static_cast<float>(z));
    };
    stage.scene.traverseVisible([&](const THREE::Object3D& object) {
        if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object))
            vec3("D", mesh->material->color.r, mesh->material->color.g, mesh->material->color.b);
        const auto* light = dynamic_cast<const THREE::Light*>(&object);
        if (light == nullptr)
            return;
        const THREE::Color L = light->radiance();
        const THREE::Vector3 at = light->position;
        if (const auto* sun = dynamic_cast<const THREE::DirectionalLight*>(light)) {
            const THREE::Vector3 w = sun->directionTowardsLight();
            vec3("w", w.x, w.y, w.z);
            vec3("L1", L.r, L.g, L.b);
        } else if (dynamic_cast<const THREE::AmbientLight*>(light) != nullptr) {
            vec3("LA", L.r, L.g, L.b);
        } else {
            vec3("P2", at.x, at.y, at.z);
            vec3("L2", L.r, L.g, L.b);
            places.insert(places.end(),
                          {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
            colors.insert(colors.end(),
                          {static_cast<float>(L.r), static_cast<float>(L.g), static_cast<float>(L.b)});
        }
    });
    const auto count = static_cast<GLsizei>(places.size() / 3);
    glUniform3fv(glGetUniformLocation(probe.program(), "P"), count, places.data());
    glUniform3fv(glGetUniformLocation(probe.program(), "L"), count, colors.data());
}

int codesApart(const image::Frame& a, const image::Frame& b) {
    const auto &x = std::get<image::Bytes>(a.pixels), &y = std::get<image::Bytes>(b.pixels);
    int most = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        most = std::max(most, std::abs(int{x[i]} - int{y[i]}));
    return most;
}

}  // namespace bench
