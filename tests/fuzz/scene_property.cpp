// What is promised of every file that may be a scene: refused by name, or good for everything that follows.
// SPDX-License-Identifier: MIT
#include "fuzz/scene_property.hpp"

#include "fuzz/property.hpp"
#include "lighting/frame_plan.hpp"
#include "three/lights.hpp"
#include "three/validate.hpp"

#include <cctype>
#include <cmath>
#include <optional>

namespace fuzz {

namespace {

using THREE::LoadedScene;

// What follows loading takes time in proportion to the triangles and does nothing new with the millionth.
constexpr std::size_t mostTriangles = 200'000;

struct Counts {
    std::size_t meshes = 0;
    std::size_t lights = 0;
    std::size_t triangles = 0;
    bool operator==(const Counts&) const = default;
};

Counts count(const THREE::Scene& scene) {
    Counts counts;
    scene.traverse([&counts](const THREE::Object3D& object) {
        counts.lights += dynamic_cast<const THREE::Light*>(&object) != nullptr;
        if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object)) {
            ++counts.meshes;
            counts.triangles += mesh->geometry->triangleCount();
        }
    });
    return counts;
}

std::string text(const Counts& counts) {
    return std::to_string(counts.meshes) + " meshes, " + std::to_string(counts.lights) + " lights, " +
           std::to_string(counts.triangles) + " triangles";
}

// The camera that draws: the file's, or the default one. The scene's matrices come up to date.
const THREE::PerspectiveCamera& camera(LoadedScene& loaded) {
    static const THREE::PerspectiveCamera otherwise;
    require(loaded.scene != nullptr, "loaded, but there is no scene");
    loaded.scene->updateMatrixWorld();
    return loaded.camera != nullptr ? *loaded.camera : otherwise;
}

void requireFinite(const glm::dvec3& v, const char* what) {
    for (int i = 0; i < 3; ++i)
        require(std::isfinite(v[i]), std::string(what) + " of the frame plan is not finite");
}

template <int columns, int rows>
void requireFinite(const glm::mat<columns, rows, double>& m, const char* what) {
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row)
            require(std::isfinite(m[column][row]), std::string(what) + " of the frame plan is not finite");
}

void checkPlan(const lighting::FramePlan& plan) {
    requireFinite(plan.background, "background");
    requireFinite(plan.ambient, "ambient");
    for (const lighting::DirectionalAddend& light : plan.directional) {
        requireFinite(light.w, "a directional light's w");
        requireFinite(light.color, "a directional light's color");
    }
    for (const lighting::PointAddend& light : plan.point) {
        requireFinite(light.position, "a point light's position");
        requireFinite(light.color, "a point light's color");
    }
    for (const lighting::Draw& draw : plan.draws) {
        require(draw.mesh != nullptr, "a draw of the frame plan has no mesh");
        requireFinite(draw.model, "a model matrix");
        requireFinite(draw.normalMatrix, "a normal matrix");
        requireFinite(draw.clip, "a clip matrix");
        requireFinite(draw.albedo, "an albedo");
        requireFinite(draw.emitted, "an emitted colour");
        requireFinite(draw.specular, "a highlight's colour");
        require(std::isfinite(draw.shininess) && draw.shininess >= 0, "a shininess is no exponent");
        THREE::BufferGeometry faces;
        if (draw.mesh->material->flatShading)
            draw.mesh->geometry->toFaces(faces);
    }
}

// A zero may come back with the other sign: -0 x 1 + 0 is 0.
std::string withoutSignsOfZeros(std::string json) {
    static const std::string zero = "-0.0";
    for (std::size_t at = 0; (at = json.find(zero, at)) != std::string::npos; ++at)
        if (at + zero.size() == json.size() ||
            std::isdigit(static_cast<unsigned char>(json[at + zero.size()])) == 0)
            json.replace(at, zero.size(), "0");
    return json;
}

// Reads back what was written, and must get the same scene, which writes the same text.
void checkRoundTrip(const THREE::Scene& scene) {
    std::string step = "written";
    try {
        const std::string json = toJSON(scene);
        step = "read again";
        LoadedScene again = THREE::ObjectLoader().parse(json, "again.json");
        step = "validated after reading it again";
        THREE::validate(*again.scene, camera(again));
        const Counts before = count(scene);
        const Counts after = count(*again.scene);
        require(before == after, "an accepted scene changes when it is written and read again: from " +
                                     text(before) + " to " + text(after));
        step = "written again";
        require(withoutSignsOfZeros(toJSON(*again.scene)) == withoutSignsOfZeros(json),
                "an accepted scene is written differently the second time");
    } catch (const std::exception& e) {
        fail("an accepted scene cannot be " + step + ": " + e.what());
    }
}

// The scene of the file, if it is one that is drawn.
std::optional<LoadedScene> accepted(const std::function<LoadedScene()>& load, const std::string& prefix) {
    std::optional<LoadedScene> loaded;
    try {
        loaded = load();
    } catch (const THREE::SceneError& error) {
        require(std::string(error.what()).starts_with(prefix),
                std::string("a refusal does not begin with the file: ") + error.what());
        return std::nullopt;
    }
    try {
        THREE::validate(*loaded->scene, camera(*loaded));
    } catch (const THREE::SceneError& error) {
        require(*error.what() != '\0', "a refusal says nothing");
        return std::nullopt;
    }
    return loaded;
}

}  // namespace

void checkScene(const std::function<LoadedScene()>& load, const std::string& prefix) {
    std::optional<LoadedScene> loaded = accepted(load, prefix);
    if (!loaded || count(*loaded->scene).triangles > mostTriangles)
        return;
    const THREE::PerspectiveCamera& eye = camera(*loaded);
    lighting::Settings settings;
    checkPlan(lighting::planFrame(*loaded->scene, eye, settings));
    settings.skip = false;
    checkPlan(lighting::planFrame(*loaded->scene, eye, settings));
    settings.space = lighting::Space::view;
    settings.normals = lighting::NormalTransform::model;
    checkPlan(lighting::planFrame(*loaded->scene, eye, settings));
    settings.focus = glm::dvec3(eye.matrixWorld.position());
    settings.focusDistance = eye.near;
    checkPlan(lighting::planFrame(*loaded->scene, eye, settings));
    checkRoundTrip(*loaded->scene);
}

}  // namespace fuzz
