// The scene graph: who hangs where, who owns whom, and where everything is in world space.
// SPDX-License-Identifier: MIT
#include "three/object3d.hpp"

#include <algorithm>
#include <stdexcept>

namespace THREE {

Object3D::Object3D() {
    rotation.listen(&rotationChanged_);
    quaternion.listen(&quaternionChanged_);
}

Object3D::~Object3D() {
    for (Object3D* child : children_)
        child->parent_ = nullptr;
    if (parent_ != nullptr)
        parent_->detach(*this);
}

void Object3D::rotationFromQuaternion() {
    // Through glm::dquat, so that the copy has no listener: normalising it would come back here for ever.
    Quaternion unit{glm::dquat(quaternion)};
    const glm::dmat4 m = glm::mat4_cast(glm::dquat(unit.normalize()));
    rotation.setSilently(Euler().setFromRotationMatrix(m, rotation.order()));
}

void Object3D::detach(Object3D& child) {
    std::erase(children_, &child);
    child.parent_ = nullptr;
}

Object3D& Object3D::add(Object3D& child) {
    for (const Object3D* ancestor = this; ancestor != nullptr; ancestor = ancestor->parent_)
        if (ancestor == &child)
            throw std::invalid_argument(
                "Object3D::add: '" + child.name +
                "' holds the object it is added to, expected a tree; remove one of them first");
    std::unique_ptr<Object3D> owner;
    if (Object3D* before = child.parent_) {
        const auto mine = std::find_if(before->owned_.begin(), before->owned_.end(),
                                       [&child](const auto& o) { return o.get() == &child; });
        if (mine != before->owned_.end()) {  // ownership goes along
            owner = std::move(*mine);
            before->owned_.erase(mine);
        }
        before->detach(child);
    }
    children_.push_back(&child);
    child.parent_ = this;
    if (owner != nullptr)
        owned_.push_back(std::move(owner));
    return *this;
}

void Object3D::adopt(std::unique_ptr<Object3D> child) {
    add(*child);
    owned_.push_back(std::move(child));
}

Object3D& Object3D::remove(Object3D& child) {
    if (child.parent_ != this)
        return *this;
    detach(child);
    std::erase_if(owned_, [&child](const auto& o) { return o.get() == &child; });
    return *this;
}

void Object3D::traverse(const std::function<void(Object3D&)>& visit) {
    visit(*this);
    for (Object3D* child : children_)
        child->traverse(visit);
}

void Object3D::traverse(const std::function<void(const Object3D&)>& visit) const {
    visit(*this);
    for (const Object3D* child : children_)
        child->traverse(visit);
}

void Object3D::traverseVisible(const std::function<void(const Object3D&)>& visit) const {
    if (!visible)
        return;
    visit(*this);
    for (const Object3D* child : children_)
        child->traverseVisible(visit);
}

Object3D* Object3D::getObjectByName(const std::string& wanted) {
    if (name == wanted)
        return this;
    for (Object3D* child : children_)
        if (Object3D* found = child->getObjectByName(wanted))
            return found;
    return nullptr;
}

void Object3D::lookAt(const Vector3& target) {
    updateWorldMatrix();
    const Vector3 here = matrixWorld.position();
    Matrix4 turned;
    if (looksAlongNegativeZ())
        turned.lookAt(here, target, up);
    else
        turned.lookAt(target, here, up);
    Quaternion world = Quaternion().setFromRotationMatrix(turned);
    if (parent_ != nullptr) {
        Vector3 position_, scale_;
        Quaternion parentTurn;
        parent_->matrixWorld.decompose(position_, parentTurn, scale_);
        world = Quaternion(glm::inverse(glm::dquat(parentTurn)) * glm::dquat(world));
    }
    quaternion = world;
}

void Object3D::updateMatrix() { matrix.compose(position, quaternion, scale); }

void Object3D::updateMatrixWorld() {
    if (matrixAutoUpdate)
        updateMatrix();
    matrixWorld = parent_ != nullptr ? Matrix4(parent_->matrixWorld).multiply(matrix) : matrix;
    for (Object3D* child : children_)
        child->updateMatrixWorld();
}

void Object3D::updateWorldMatrix() {
    if (parent_ != nullptr)
        parent_->updateWorldMatrix();
    if (matrixAutoUpdate)
        updateMatrix();
    matrixWorld = parent_ != nullptr ? Matrix4(parent_->matrixWorld).multiply(matrix) : matrix;
}

Vector3 Object3D::getWorldPosition() {
    updateWorldMatrix();
    return matrixWorld.position();
}

void Object3D::applyMatrix4(const Matrix4& m) {
    matrix = m;
    m.decompose(position, quaternion, scale);
}

}  // namespace THREE
