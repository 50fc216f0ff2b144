// Object3D and Group: a node of the scene graph with its place, its name and its children.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/matrix4.hpp"
#include "three/rotation.hpp"
#include "three/vector3.hpp"

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace THREE {

/// A node of the scene graph. Lives on the stack and cannot be copied, so that lesson lines read like the slide;
/// a destroyed object detaches itself from its parent and its children from itself.
/// https://threejs.org/docs/#api/en/core/Object3D
class Object3D {
  public:
    Object3D();
    virtual ~Object3D();
    Object3D(const Object3D&) = delete;
    Object3D& operator=(const Object3D&) = delete;

    std::string name;  ///< for messages and JSON; may be empty
    bool visible = true;  ///< false: neither this object nor what hangs below it is drawn or gives light
    Vector3 position;  ///< origin of this object in its parent's space
    Euler rotation;  ///< radians; the same rotation as `quaternion`, each follows the other
    Quaternion quaternion;  ///< the same rotation as `rotation`
    Vector3 scale{1, 1, 1};  ///< factor along each own axis; may be negative (mirror) or zero (flat)
    Vector3 up{0, 1, 0};  ///< what lookAt keeps upright; never zero
    Matrix4 matrix;  ///< this object's space to its parent's
    Matrix4 matrixWorld;  ///< this object's space to world space
    bool matrixAutoUpdate = true;  ///< false: `matrix` was set by hand and stands

    /// three.js's class name, as in its JSON: "Mesh", "PointLight", ...
    virtual const char* type() const { return "Object3D"; }
    /// True for what looks along -z (cameras) or is turned that way by lookAt, as three.js's isCamera/isLight.
    virtual bool looksAlongNegativeZ() const { return false; }

    Object3D* parent() const { return parent_; }
    const std::vector<Object3D*>& children() const { return children_; }

    /// Hangs `child` below this object, taking it from where it hung before. The caller keeps ownership.
    /// Throws std::invalid_argument if that would make a cycle.
    Object3D& add(Object3D& child);
    /// The same for several at once, in order, as three.js's add(a, b, c).
    template <class... More>
    Object3D& add(Object3D& first, Object3D& second, More&... more) {
        return add(first).add(second, more...);
    }
    /// The same, and this object owns the child from now on; returns it. Loaders use it.
    template <class T>
    T& add(std::unique_ptr<T> child) {
        static_assert(std::is_base_of_v<Object3D, T>);
        T& reference = *child;
        adopt(std::move(child));
        return reference;
    }
    /// Takes `child` out; nothing happens if it is not a child of this object. An owned child is destroyed.
    Object3D& remove(Object3D& child);

    /// Calls `visit` with this object and everything below it, parents first. The tree must not change meanwhile.
    void traverse(const std::function<void(Object3D&)>& visit);
    void traverse(const std::function<void(const Object3D&)>& visit) const;
    /// The same without invisible objects and what hangs below them.
    void traverseVisible(const std::function<void(const Object3D&)>& visit) const;
    /// The first object of this name here or below, or null.
    Object3D* getObjectByName(const std::string& wanted);

    /// Turns this object's z axis (a camera's -z) towards a point of world space.
    void lookAt(const Vector3& target);
    void lookAt(double x, double y, double z) { lookAt(Vector3(x, y, z)); }

    /// `matrix` from position, quaternion and scale.
    void updateMatrix();
    /// `matrix` and `matrixWorld` of this object and everything below it.
    void updateMatrixWorld();
    /// `matrixWorld` of this object only, from its parents' downwards.
    void updateWorldMatrix();
    /// Position in world space, up to date.
    Vector3 getWorldPosition();
    /// Sets `matrix` and, from it, position, quaternion and scale.
    void applyMatrix4(const Matrix4& m);

  private:
    struct Follow final : ChangeListener {
        Follow(Object3D& o, void (Object3D::*a)()) : object(o), action(a) {}
        void changed() override { (object.*action)(); }
        Object3D& object;
        void (Object3D::*action)();
    };
    void adopt(std::unique_ptr<Object3D> child);
    void detach(Object3D& child);
    void quaternionFromRotation() { quaternion.setSilently(Quaternion().setFromEuler(rotation)); }
    void rotationFromQuaternion();

    Follow rotationChanged_{*this, &Object3D::quaternionFromRotation};
    Follow quaternionChanged_{*this, &Object3D::rotationFromQuaternion};
    Object3D* parent_ = nullptr;
    std::vector<Object3D*> children_;
    std::vector<std::unique_ptr<Object3D>> owned_;
};

/// An object that only holds others. https://threejs.org/docs/#api/en/objects/Group
class Group : public Object3D {
  public:
    const char* type() const override { return "Group"; }
};

}  // namespace THREE
