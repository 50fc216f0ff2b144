// toJSON: a scene as three.js's JSON format 4, the way scene.toJSON() of r146 writes it.
// SPDX-License-Identifier: MIT
#include "three/json_writer.hpp"
#include "three/lights.hpp"
#include "three/object_loader.hpp"
#include "three/resource_writer.hpp"
#include "three/validate.hpp"

#include <map>
#include <optional>

namespace THREE {

namespace {

Matrix4 localMatrix(const Object3D& object) {
    return object.matrixAutoUpdate ? Matrix4().compose(object.position, object.quaternion, object.scale)
                                   : object.matrix;
}

// Formed from the parts, because nobody may have updated matrixWorld since they were changed.
Matrix4 worldMatrix(const Object3D* object) {
    Matrix4 world;
    for (; object != nullptr; object = object->parent())
        world.premultiply(localMatrix(*object));
    return world;
}

std::vector<double> numbers(const Vector3& v) { return {v.x, v.y, v.z}; }
std::vector<double> numbers(const Euler& e) { return {e.x, e.y, e.z}; }
std::vector<double> numbers(const Quaternion& q) { return {q.x, q.y, q.z, q.w}; }
std::vector<double> numbers(const Matrix4& m) {
    std::vector<double> all;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            all.push_back(m.elements[column][row]);
    return all;
}

const char* nameOf(EulerOrder order) {
    static const char* const names[] = {"XYZ", "YXZ", "ZXY", "ZYX", "YZX", "XZY"};
    return names[static_cast<int>(order)];
}

// The type that the file names: only what the loader makes again. A class derived by a lesson is what it derives from.
const char* typeOf(const Object3D& object) {
    for (const char* type :
         {"Scene", "Mesh", "Group", "PerspectiveCamera", "AmbientLight", "DirectionalLight", "PointLight"})
        if (std::string_view(object.type()) == type)
            return type;
    return "Object3D";
}

class SceneWriter {
  public:
    SceneWriter(const Object3D& root, const PerspectiveCamera* camera) : root_(root) {
        bool inside = false;
        for (const Object3D* object = camera; object != nullptr; object = object->parent())
            inside |= object == &root;
        camera_ = inside ? nullptr : camera;
        root.traverse([this](const Object3D& object) { collect(object); });
        root.traverse([this](const Object3D& object) { collectTarget(object); });
    }

    std::string write() {
        json_.beginObject().key("metadata").beginObject();
        json_.field("version", 4.5).field("type", "Object").field("generator", "Object3D.toJSON").endObject();
        writeAll("geometries", geometries_, writeGeometry);
        writeAll("materials", materials_, writeMaterial);
        json_.key("object");
        writeObject(root_);
        json_.endObject();
        return json_.text() + "\n";
    }

  private:
    template <class T>
    using Ids = std::map<const T*, std::string>;
    template <class T>
    struct Resources {
        Ids<T> uuids;
        std::vector<const T*> inOrder;
        void add(const T& resource, Kind kind) {
            if (uuids.emplace(&resource, uuid(kind, inOrder.size() + 1)).second)
                inOrder.push_back(&resource);
        }
    };
    struct Target {
        const DirectionalLight* light;
        std::string uuid;
        Vector3 position;  // in the root's own space
    };

    template <class T>
    void writeAll(const char* key, const Resources<T>& resources,
                  void (*writeOne)(JsonWriter&, const T&, const std::string&)) {
        if (resources.inOrder.empty())
            return;
        json_.key(key).beginArray();
        for (const T* resource : resources.inOrder)
            writeOne(json_, *resource, resources.uuids.at(resource));
        json_.endArray();
    }

    void collect(const Object3D& object) {
        uuids_.emplace(&object, uuid(Kind::object, ++objects_));
        if (&object == &root_ &&
            camera_ != nullptr)  // in the order of the file, so that reading and writing changes nothing
            uuids_.emplace(camera_, uuid(Kind::object, ++objects_));
        const auto* mesh = dynamic_cast<const Mesh*>(&object);
        if (mesh == nullptr)
            return;
        if (!mesh->geometry || !mesh->material)
            throw SceneError(describe(object) + ": its " + (mesh->geometry ? "material" : "geometry") +
                             " was destroyed before it; declare it first, so that it lives longer");
        geometries_.add(*mesh->geometry, Kind::geometry);
        materials_.add(*mesh->material, Kind::material);
    }

    // A target that hangs in the tree is written there. Another one is written as a child of the root, unless it is at
    // the origin, where a light without target aims.
    void collectTarget(const Object3D& object) {
        const auto* light = dynamic_cast<const DirectionalLight*>(&object);
        if (light == nullptr || uuids_.contains(&light->target))
            return;
        const Vector3 place = light->target.parent() == nullptr ? light->target.position
                                                                : worldMatrix(&light->target).position();
        const Vector3 inFile = Matrix4(worldMatrix(root_.parent())).invert().applyTo(place);
        if (inFile == Vector3())
            return;
        Vector3 inRoot = inFile;
        if (const Matrix4 root = localMatrix(root_); root.elements != glm::dmat4(1.0)) {
            if (root.determinant() == 0)
                throw SceneError(describe(root_) +
                                 ": scale: expected no zero, found a flat one, in which the target of " +
                                 describe(*light) + " has no place; add the target to the scene");
            inRoot = Matrix4(root).invert().applyTo(inFile);
        }
        targets_.push_back({light, uuid(Kind::object, ++objects_), inRoot});
    }

    void writeObject(const Object3D& object) {
        json_.whose = [&object] { return describe(object); };
        json_.beginObject().field("uuid", uuids_.at(&object)).field("type", typeOf(object));
        if (!object.name.empty())
            json_.field("name", object.name);
        if (!object.visible)
            json_.field("visible", false);
        json_.field("layers", 1.0);
        writePlace(object);
        writeOwn(object);
        if (!object.children().empty() || (&object == &root_ && (camera_ != nullptr || !targets_.empty())))
            writeChildren(object);
        json_.endObject();
    }

    void writeChildren(const Object3D& object) {
        json_.key("children").beginArray();
        // First, because the first camera of a file is the one that is used.
        if (&object == &root_ && camera_ != nullptr)
            writeObject(*camera_);
        for (const Object3D* child : object.children())
            writeObject(*child);
        if (&object == &root_) {
            for (const Target& target : targets_) {
                json_.whose = [&target] { return "target of " + describe(*target.light); };
                Matrix4 place;
                place.elements[3] = glm::dvec4(glm::dvec3(target.position), 1);
                json_.beginObject().field("uuid", target.uuid).field("type", "Object3D");
                json_.field("layers", 1.0).field("matrix", numbers(place)).endObject();
            }
        }
        json_.endArray();
    }

    // three.js reads the matrix. Where taking it apart again would not give the very same doubles, the parts stand
    // beside it, for our own loader.
    void writePlace(const Object3D& object) {
        Matrix4 matrix = localMatrix(object);
        // A camera from outside keeps its place in the world, whatever it hung from.
        const bool isMoved = &object == camera_ && object.parent() != nullptr;
        if (isMoved)
            matrix = Matrix4(worldMatrix(&root_)).invert().multiply(worldMatrix(&object));
        json_.field("matrix", numbers(matrix));
        if (!object.matrixAutoUpdate)
            json_.field("matrixAutoUpdate", false);
        if (!(object.up == Vector3(0, 1, 0)))
            json_.field("up", numbers(object.up));
        if (isMoved)
            return;
        Object3D read;
        read.applyMatrix4(matrix);
        const bool same = read.position == object.position && read.scale == object.scale &&
                          numbers(read.quaternion) == numbers(object.quaternion) &&
                          numbers(read.rotation) == numbers(object.rotation) &&
                          object.rotation.order() == EulerOrder::XYZ;
        if (same)
            return;
        json_.field("position", numbers(object.position));
        writeRotation(object);
        json_.field("scale", numbers(object.scale));
    }

    // One of the two is what the lesson set, the other one follows from it.
    void writeRotation(const Object3D& object) {
        const Euler& rotation = object.rotation;
        json_.key("rotation")
            .beginArray()
            .value(double(rotation.x))
            .value(double(rotation.y))
            .value(double(rotation.z));
        json_.value(nameOf(rotation.order())).endArray();
        if (numbers(Quaternion().setFromEuler(rotation)) != numbers(object.quaternion))
            json_.field("quaternion", numbers(object.quaternion));
    }

    void writeOwn(const Object3D& object) {
        if (const auto* scene = dynamic_cast<const Scene*>(&object)) {
            if (scene->background)
                writeColor(json_, "background", "lambertBackground", *scene->background);
        } else if (const auto* mesh = dynamic_cast<const Mesh*>(&object)) {
            json_.field("geometry", geometries_.uuids.at(mesh->geometry.get()));
            json_.field("material", materials_.uuids.at(mesh->material.get()));
        } else if (const auto* camera = dynamic_cast<const PerspectiveCamera*>(&object)) {
            json_.field("fov", camera->fov).field("zoom", camera->zoom).field("near", camera->near);
            json_.field("far", camera->far).field("focus", 10.0).field("aspect", camera->aspect);
            json_.field("filmGauge", 35.0).field("filmOffset", 0.0);
        } else if (const auto* light = dynamic_cast<const Light*>(&object)) {
            writeLight(*light);
        }
    }

    void writeLight(const Light& light) {
        writeColor(json_, "color", "lambertColor", light.color);
        json_.field("intensity", light.intensity);
        if (const auto* point = dynamic_cast<const PointLight*>(&light)) {
            json_.field("distance", point->distance).field("decay", point->decay);
        } else if (const auto* directional = dynamic_cast<const DirectionalLight*>(&light)) {
            if (const auto inTree = uuids_.find(&directional->target); inTree != uuids_.end())
                json_.field("target", inTree->second);
            for (const Target& target : targets_)
                if (target.light == directional)
                    json_.field("target", target.uuid);
        }
    }

    const Object3D& root_;
    const PerspectiveCamera* camera_ = nullptr;  // one to add as the root's first child
    std::uint64_t objects_ = 0;
    Ids<Object3D> uuids_;
    Resources<BufferGeometry> geometries_;
    Resources<Material> materials_;
    std::vector<Target> targets_;  // children to add to the root after the camera
    JsonWriter json_;
};

}  // namespace

std::string toJSON(const Object3D& object, const PerspectiveCamera* camera) {
    return SceneWriter(object, camera).write();
}

}  // namespace THREE
