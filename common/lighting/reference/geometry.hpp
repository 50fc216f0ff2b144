// What the reference takes from a scene: transforms, vertices and lights in its own scalar, formed from positions,
// quaternions and scales without the matrices that the GPU's path uses.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/equation.hpp"
#include "lighting/reference/views.hpp"
#include "three/scene.hpp"

#include <cstdint>
#include <optional>

namespace lighting::reference {

template <class T>
Vec3<T> toVec(double x, double y, double z) {
    return {T(x), T(y), T(z)};
}
template <class T>
Vec3<T> toVec(const THREE::Vector3& v) {
    return toVec<T>(v.x, v.y, v.z);
}
template <class T>
Vec3<T> toVec(const THREE::Color& c) {
    return toVec<T>(c.r, c.g, c.b);
}

/// v to length 1, whatever its length; what has no direction becomes zero.
template <class T>
Vec3<T> unit(const Vec3<T>& v) {
    using std::abs;
    using std::sqrt;
    const T squared = glm::dot(v, v);
    if (squared > T(1e-30) && squared < T(1e30))
        return v * (T(1) / sqrt(squared));
    const T largest = std::max({T(abs(v.x)), T(abs(v.y)), T(abs(v.z))});
    if (!(largest > T(0)))
        return Vec3<T>(T(0));
    const Vec3<T> s = v / largest;
    return s * (T(1) / sqrt(glm::dot(s, s)));
}

/// An object's own axes and origin in world space: p goes to x p.x + y p.y + z p.z + origin.
template <class T>
struct Place {
    Vec3<T> x, y, z, origin;

    Vec3<T> direction(const Vec3<T>& v) const { return x * v.x + y * v.y + z * v.z; }
    /// The volume that the unit cube becomes, negative in a mirror.
    T determinant() const { return glm::dot(x, glm::cross(y, z)); }
};

/// What a Place makes of planes, formed once for many vectors: where normals go, and the way back.
template <class T>
struct Planes {
    Vec3<T> x, y, z;  ///< cofactors of the place's axes
    T determinant;

    explicit Planes(const Place<T>& place)
        : x(glm::cross(place.y, place.z)), y(glm::cross(place.z, place.x)), z(glm::cross(place.x, place.y)),
          determinant(place.determinant()) {}
    /// Normals stay at right angles to the surface: the plane of two tangents is carried along, inside stays inside.
    Vec3<T> normal(const Vec3<T>& n) const {
        const Vec3<T> carried = x * n.x + y * n.y + z * n.z;
        return unit<T>(determinant < T(0) ? -carried : carried);
    }
    /// The direction that Place::direction takes to v.
    Vec3<T> inverseDirection(const Vec3<T>& v) const {
        return {glm::dot(v, x) / determinant, glm::dot(v, y) / determinant, glm::dot(v, z) / determinant};
    }
};

/// From `object`'s own place and that of everything it hangs on.
template <class T>
Place<T> placeOf(const THREE::Object3D& object) {
    Place<T> own;
    if (object.matrixAutoUpdate) {
        const T x = T(object.quaternion.x), y = T(object.quaternion.y), z = T(object.quaternion.z),
                w = T(object.quaternion.w);
        const T one(1), two(2);
        own.x = Vec3<T>(one - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)) *
                T(object.scale.x);
        own.y = Vec3<T>(two * (x * y - w * z), one - two * (x * x + z * z), two * (y * z + w * x)) *
                T(object.scale.y);
        own.z = Vec3<T>(two * (x * z + w * y), two * (y * z - w * x), one - two * (x * x + y * y)) *
                T(object.scale.z);
        own.origin = toVec<T>(object.position);
    } else {
        const auto column = [&object](int i) {
            const glm::dvec4& c = object.matrix.elements[i];
            return toVec<T>(c.x, c.y, c.z);
        };
        own = {column(0), column(1), column(2), column(3)};
    }
    if (object.parent() == nullptr)
        return own;
    const Place<T> parent = placeOf<T>(*object.parent());
    return {parent.direction(own.x), parent.direction(own.y), parent.direction(own.z),
            parent.direction(own.origin) + parent.origin};
}

/// A corner of a triangle.
template <class T>
struct Vertex {
    Vec3<T> Q;  ///< world space relative to the eye
    Vec3<T> view;  ///< view space: the camera looks along -z
    Vec3<T> n{T(0)};  ///< unit normal, world space; zero: none, or one for the whole triangle
};

/// The pixels that a triangle may cover; none where last < first.
struct Pixels {
    int firstColumn, lastColumn, firstRow, lastRow;
};

/// A mesh, ready to be drawn.
template <class T>
struct Body {
    const THREE::Mesh* mesh;  ///< which one it is; what is drawn is all in here
    THREE::Side side;  ///< which faces are drawn
    bool lit;
    bool flat;  ///< a normal per triangle
    bool mirrored;  ///< its place turns triangles round
    bool turnsNormals;  ///< on the back of a BackSide or DoubleSide surface
    Vec3<T> D;  ///< base colour, or the pixel of an unlit material
    Gloss<T> gloss;  ///< of the highlight
    Vec3<T> emitted;
    std::optional<Place<T>>
        wrongly;  ///< takes normals along by the model matrix alone (NormalTransform::model)
    std::vector<Vertex<T>> vertices;
    std::vector<std::uint32_t> index;  ///< three per triangle
    std::vector<Pixels> seen;  ///< of each triangle

    std::size_t triangles() const { return index.size() / 3; }
    const Vertex<T>& corner(std::size_t triangle, int i) const {
        return vertices[index[triangle * 3 + static_cast<std::size_t>(i)]];
    }
    /// A right normal, or what slide 33's wording makes of it: with M the 3x3 model matrix, M n_object = M M^T (M^-T n_object).
    Vec3<T> asAsked(const Vec3<T>& n) const {
        if (!wrongly)
            return n;
        const Vec3<T> object(glm::dot(wrongly->x, n), glm::dot(wrongly->y, n), glm::dot(wrongly->z, n));
        return unit<T>(wrongly->direction(object));
    }
};

/// The highlight of a material, `model` in place of the material's own if it is set.
template <class T>
Gloss<T> glossOf(const THREE::Material& material, const std::optional<THREE::SpecularModel>& model) {
    const auto* phong = dynamic_cast<const THREE::MeshPhongMaterial*>(&material);
    if (phong == nullptr)
        return {};
    Gloss<T> gloss{toVec<T>(phong->specular), T(phong->shininess), model.value_or(phong->specularModel)};
    if (gloss.model == THREE::SpecularModel::blinn)
        gloss.shininess = std::max(gloss.shininess, T(1e-4));  // three.js: "to prevent pow( 0.0, 0.0 )"
    return gloss;
}

template <class T>
Body<T> makeBody(const THREE::Mesh& mesh, const Place<T>& camera, const Switches& switches) {
    const THREE::BufferGeometry& geometry = *mesh.geometry;
    const THREE::Material& material = *mesh.material;
    const THREE::BufferAttribute* const normals = geometry.getAttribute("normal");
    Place<T> place = placeOf<T>(mesh);
    place.origin -= camera.origin;
    Body<T> body;
    body.mesh = &mesh;
    body.side = material.side;
    body.lit = material.isLit();
    body.flat = material.flatShading || switches.shading == Shading::flat || normals == nullptr;
    body.mirrored = place.determinant() < T(0);
    body.turnsNormals = material.side != THREE::FrontSide;
    body.D = toVec<T>(material.color);
    body.gloss = glossOf<T>(material, switches.specular);
    body.emitted = toVec<T>(material.emitted());
    if (switches.normals == NormalTransform::model)
        body.wrongly = place;
    const Planes<T> planes(place), cameraPlanes(camera);
    body.vertices.resize(geometry.vertexCount());
    for (std::size_t i = 0; i < body.vertices.size(); ++i) {
        const THREE::Vector3 position = geometry.getAttribute("position")->getXYZ(i);
        Vertex<T>& vertex = body.vertices[i];
        vertex.Q = place.direction(toVec<T>(position)) + place.origin;
        vertex.view = cameraPlanes.inverseDirection(vertex.Q);
        if (!body.flat)
            vertex.n = body.asAsked(planes.normal(unit<T>(toVec<T>(normals->getXYZ(i)))));
    }
    body.index.resize(geometry.triangleCount() * 3);
    for (std::size_t t = 0; t < geometry.triangleCount(); ++t) {
        std::uint32_t corners[3];
        geometry.triangle(t, corners);
        std::copy(corners, corners + 3, body.index.begin() + static_cast<std::ptrdiff_t>(t * 3));
    }
    return body;
}

/// The lights of a scene, in its order, relative to the eye; of a look those that it shows.
template <class T>
Equation<T> makeEquation(const THREE::Scene& scene, const TermSet& terms, const Vec3<T>& eye,
                         const Look& look = {}) {
    Equation<T> equation;
    equation.terms = termsIn(look.view, terms);
    scene.traverseVisible([&](const THREE::Object3D& object) {
        const auto* light = dynamic_cast<const THREE::Light*>(&object);
        if (light == nullptr || (look.only != nullptr && look.only != light))
            return;
        const Vec3<T> L = toVec<T>(light->color) * T(light->intensity);
        if (dynamic_cast<const THREE::AmbientLight*>(light) != nullptr) {
            equation.ambientLight += look.view == ViewMode::exaggerated ? L * T(exaggeration) : L;
            ++equation.ambientLights;
            return;
        }
        const Vec3<T> position = placeOf<T>(*light).origin;
        Light<T> made{light, position - eye, L, T(light->intensity), T(0), T(0)};
        if (const auto* sun = dynamic_cast<const THREE::DirectionalLight*>(light)) {
            made.place = unit<T>(position - placeOf<T>(sun->target).origin);
            equation.directionalLights.push_back(made);
        } else if (const auto* bulb = dynamic_cast<const THREE::PointLight*>(light)) {
            made.decay = T(bulb->decay);
            made.distance = T(bulb->distance);
            equation.pointLights.push_back(made);
        }
    });
    return equation;
}

}  // namespace lighting::reference
