// What is refused before a frame is drawn.
// SPDX-License-Identifier: MIT
#include "three/validate.hpp"

#include "three/lights.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>

namespace THREE {

namespace {

double radiusInWorld(const Mesh& mesh) {
    double stretch = 0;
    for (int column = 0; column < 3; ++column)
        stretch = std::max(stretch, Vector3(glm::dvec3(mesh.matrixWorld.elements[column])).length());
    return std::max(mesh.geometry->boundingSphere().radius, 0.0) * stretch;
}

}  // namespace

double reach(const Mesh& mesh, const Vector3& from) {
    const Vector3 center = mesh.matrixWorld.applyTo(mesh.geometry->boundingSphere().center);
    return center.distanceTo(from) + radiusInWorld(mesh);
}

std::string describe(const Object3D& object) {
    if (!object.name.empty())
        return std::string(object.type()) + " '" + object.name + "'";
    const Object3D* parent = object.parent();
    if (parent == nullptr)
        return object.type();
    const auto& siblings = parent->children();
    const auto number = std::find(siblings.begin(), siblings.end(), &object) - siblings.begin();
    return std::string(object.type()) + " (no name, child " + std::to_string(number) + " of " +
           describe(*parent) + ")";
}

namespace {

[[noreturn]] void refuse(const std::string& who, const std::string& field, const std::string& expected,
                         double found) {
    std::ostringstream message;
    message.precision(17);
    message << who << ": " << field << " must be " << expected << ", found " << found;
    throw SceneError(message.str());
}

bool isNumber(double x) {
    return std::abs(x) <= largestNumber;  // false for NaN too
}

// A check of one object: its fields are looked at one after the other, the first bad one is refused.
// Nothing is written until something is wrong, so that thousands of objects cost little each frame.
class Check {
  public:
    explicit Check(const Object3D& object) : object_(object) {}

    void number(const char* field, double x, const char* part = "") const {
        if (!isNumber(x))
            refuse(describe(object_), std::string(field) + part, "a number of at most 1e36", x);
    }
    void notNegative(const char* field, double x, const char* part = "") const {
        number(field, x, part);
        if (x < 0)
            refuse(describe(object_), std::string(field) + part, "0 or more", x);
    }
    void positive(const char* field, double x) const {
        number(field, x);
        if (!(x > 0))
            refuse(describe(object_), field, "more than 0", x);
    }
    void vector(const char* field, const Vector3& v) const {
        number(field, v.x, ".x");
        number(field, v.y, ".y");
        number(field, v.z, ".z");
    }
    void color(const char* field, const Color& c) const {
        notNegative(field, c.r, ".r");
        notNegative(field, c.g, ".g");
        notNegative(field, c.b, ".b");
    }
    [[noreturn]] void fail(const std::string& message) const {
        throw SceneError(describe(object_) + ": " + message);
    }
    std::string who() const { return describe(object_); }

  private:
    const Object3D& object_;
};

void checkPlace(const Object3D& object, const Check& check) {
    check.vector("position", object.position);
    check.vector("scale", object.scale);
    check.vector("rotation", Vector3(object.rotation.x, object.rotation.y, object.rotation.z));
    const Quaternion& q = object.quaternion;
    check.vector("quaternion", Vector3(q.x, q.y, q.z));
    check.number("quaternion", q.w, ".w");
    check.vector("up", object.up);
    if (object.up.equals(Vector3()))
        check.fail("up must not be the zero vector, found (0, 0, 0); the usual one is (0, 1, 0)");
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            check.number("matrixWorld", object.matrixWorld.elements[column][row]);
}

void checkDirection(const DirectionalLight& light, const Check& check) {
    check.vector("target.position", light.target.position);
    // A target in the graph may hang below something invisible, which was not looked at.
    check.vector("target.matrixWorld", light.target.matrixWorld.position());
    if (light.directionTowardsLight().equals(Vector3()))
        check.fail("position and target coincide, so there is no direction; expected two different points "
                   "(slide 36: \"position\" is the direction towards the light)");
}

void checkLight(const Light& light, const Check& check) {
    check.color("color", light.color);
    check.notNegative("intensity", light.intensity);
    const Color radiance = light.radiance();
    check.number("color x intensity", std::max({radiance.r, radiance.g, radiance.b}));
    if (const auto* point = dynamic_cast<const PointLight*>(&light)) {
        check.notNegative("distance", point->distance);
        check.notNegative("decay", point->decay);
    } else if (const auto* directional = dynamic_cast<const DirectionalLight*>(&light)) {
        checkDirection(*directional, check);
    }
}

void checkGeometry(const BufferGeometry& geometry, const Check& check) {
    if (geometry.validatedVersion() == geometry.version())
        return;
    const std::size_t vertices = geometry.vertexCount();
    for (const char* name : {"position", "normal"}) {
        const BufferAttribute* attribute = geometry.getAttribute(name);
        if (attribute == nullptr)
            continue;
        const std::string field = std::string("geometry.attributes.") + name;
        if (attribute->itemSize != 3 || attribute->array.size() % 3 != 0)
            check.fail(field + " must hold 3 numbers per vertex, found itemSize " +
                       std::to_string(attribute->itemSize) + " and " +
                       std::to_string(attribute->array.size()) + " numbers");
        if (attribute->count() != vertices)
            check.fail(field + " must have as many vertices as position, expected " +
                       std::to_string(vertices) + ", found " + std::to_string(attribute->count()));
        for (std::size_t i = 0; i < attribute->array.size(); ++i)
            if (!isNumber(attribute->array[i]))
                check.number(field.c_str(), attribute->array[i], ("[" + std::to_string(i) + "]").c_str());
    }
    if (geometry.index.size() % 3 != 0)
        check.fail("geometry.index must hold 3 indices per triangle, found " +
                   std::to_string(geometry.index.size()));
    for (std::size_t i = 0; i < geometry.index.size(); ++i)
        if (geometry.index[i] >= vertices)
            check.fail("geometry.index[" + std::to_string(i) + "] must be below the number of vertices, " +
                       std::to_string(vertices) + ", found " + std::to_string(geometry.index[i]));
    geometry.markValidated();
}

void checkMesh(const Mesh& mesh, const Check& check) {
    if (!mesh.geometry)
        check.fail(
            "its geometry was destroyed before it; declare the geometry first, so that it lives longer");
    if (!mesh.material)
        check.fail(
            "its material was destroyed before it; declare the material first, so that it lives longer");
    checkGeometry(*mesh.geometry, check);
    check.number("size in world space", radiusInWorld(mesh));
    check.color("material.color", mesh.material->color);
    check.color("material.emissive", mesh.material->emitted());
    if (const auto* phong = dynamic_cast<const MeshPhongMaterial*>(mesh.material.get())) {
        check.color("material.specular", phong->specular);
        check.notNegative("material.shininess", phong->shininess);
    }
}

void checkCamera(const PerspectiveCamera& camera, const Check& check) {
    if (!(camera.fov > 0 && camera.fov < 180))
        refuse(check.who(), "fov", "between 0 and 180 degrees", camera.fov);
    check.positive("aspect", camera.aspect);
    check.positive("near", camera.near);
    check.positive("far", camera.far);
    check.positive("zoom", camera.zoom);
    if (!(camera.near < camera.far))
        refuse(check.who(), "near", "less than far", camera.near);
    const glm::dmat4 projection = camera.projectionMatrix();
    for (const double element : {projection[0][0], projection[1][1], projection[2][2], projection[3][2]})
        if (!isNumber(element))
            check.fail(
                "fov, aspect, zoom, near and far together give no projection with numbers of at most 1e36; "
                "expected ordinary values such as 50, 1, 1, 0.1, 2000");
    const glm::dmat4 view = camera.matrixWorldInverse();
    for (int i = 0; i < 16; ++i)
        if (view[3][3] == 0 || !isNumber(view[i / 4][i % 4]))
            check.fail("its scale, or that of an object it hangs below, is 0 or almost 0 along some axis, so "
                       "nothing "
                       "can be seen; expected a scale such as (1, 1, 1)");
}

// Floats interpolate over a triangle what they hold at its corners divided by their depth.
void checkReach(const Scene& scene, const PerspectiveCamera& camera) {
    const Vector3 eye = camera.matrixWorld.position();
    const double farthest = camera.near * largestReach;
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", farthest);
    scene.traverseVisible([&](const Object3D& object) {
        const auto* mesh = dynamic_cast<const Mesh*>(&object);
        if (mesh == nullptr)
            return;
        const double found = reach(*mesh, eye);
        if (!(found <= farthest))
            refuse(describe(*mesh), "distance from the camera and size together",
                   "at most 1e30 times the camera's near (" + std::string(text) + ")", found);
    });
}

}  // namespace

void validate(const Scene& scene, const PerspectiveCamera& camera) {
    if (scene.background)
        Check(scene).color("background", *scene.background);
    scene.traverseVisible([](const Object3D& object) {
        const Check check(object);
        checkPlace(object, check);
        if (const auto* light = dynamic_cast<const Light*>(&object))
            checkLight(*light, check);
        else if (const auto* mesh = dynamic_cast<const Mesh*>(&object))
            checkMesh(*mesh, check);
    });
    const Check check(camera);
    checkPlace(camera, check);
    checkCamera(camera, check);
    checkReach(scene, camera);
}

}  // namespace THREE
