// Unit tests of world space: matrixWorld, lookAt below turned parents, and where a directional light comes from.
// SPDX-License-Identifier: MIT
#include "three/lights.hpp"
#include "three/object3d.hpp"
#include "three/scene.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <vector>

namespace {

using THREE::Object3D;
using THREE::Vector3;

constexpr double pi = std::numbers::pi;

void expectNear(const Vector3& found, const Vector3& expected, double bound = 1e-14) {
    EXPECT_NEAR(found.x, expected.x, bound);
    EXPECT_NEAR(found.y, expected.y, bound);
    EXPECT_NEAR(found.z, expected.z, bound);
}

Vector3 axisOf(const Object3D& object, int axis) {
    return Vector3(glm::dvec3(object.matrixWorld.elements[axis])).normalize();
}

// --- updateMatrixWorld

// Ry(90) takes (x,y,z) to (z,y,-x): the child at (1,2,3) lies at 2 (3,2,-1) + (10,0,0).
TEST(World, ChildrenAreMovedTurnedAndScaledByTheirParents) {
    Object3D parent, child;
    parent.add(child);
    parent.position.set(10, 0, 0);
    parent.rotation.y = pi / 2;
    parent.scale.setScalar(2);
    child.position.set(1, 2, 3);
    parent.updateMatrixWorld();
    expectNear(child.matrixWorld.position(), {16, 4, -2});
    expectNear(child.matrixWorld.applyTo({1, 0, 0}), {16, 4, -4});
    expectNear(child.matrix.position(), {1, 2, 3}, 0);
}

TEST(World, AMatrixSetByHandStands) {
    Object3D object;
    object.position.set(1, 2, 3);
    object.matrixAutoUpdate = false;
    object.matrix.compose({7, 8, 9}, {}, {1, 1, 1});
    object.updateMatrixWorld();
    expectNear(object.matrixWorld.position(), {7, 8, 9}, 0);
    object.updateMatrix();
    expectNear(object.matrix.position(), {1, 2, 3}, 0);
}

TEST(World, UpdateWorldMatrixLooksUpwardsOnly) {
    Object3D top, middle, bottom;
    top.add(middle);
    middle.add(bottom);
    top.position.x = 1;
    middle.position.x = 10;
    bottom.position.x = 100;
    middle.updateWorldMatrix();
    EXPECT_EQ(middle.matrixWorld.position(), Vector3(11, 0, 0));
    EXPECT_EQ(bottom.matrixWorld.position(), Vector3(0, 0, 0));  // not yet
    EXPECT_EQ(bottom.getWorldPosition(), Vector3(111, 0, 0));
}

TEST(World, ADetachedObjectStandsInItsOwnPlaceAgain) {
    Object3D parent, child;
    parent.add(child);
    parent.position.x = 5;
    parent.updateMatrixWorld();
    EXPECT_EQ(child.matrixWorld.position(), Vector3(5, 0, 0));
    parent.remove(child);
    child.updateMatrixWorld();
    EXPECT_EQ(child.matrixWorld.position(), Vector3(0, 0, 0));
}

TEST(World, ApplyMatrix4SetsPlaceTurnAndScaleToo) {
    Object3D object;
    object.applyMatrix4(THREE::Matrix4().fromArray({0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 20, 30, 1}));
    expectNear(object.position, {10, 20, 30}, 0);
    expectNear(object.scale, {2, 3, 4});
    EXPECT_NEAR(object.rotation.z, pi / 2, 1e-15);
    object.updateMatrixWorld();
    expectNear(object.matrixWorld.applyTo({1, 1, 1}), {7, 22, 34});
}

// --- lookAt

// What looks: its own -z points at the target for cameras and lights, its +z for everything else.
struct Looker {
    const char* name;
    std::shared_ptr<Object3D> object;
    double forwards;  // the sign of the z axis that points at the target
};

std::vector<Looker> lookers() {
    return {{"camera", std::make_shared<THREE::PerspectiveCamera>(), -1},
            {"point light", std::make_shared<THREE::PointLight>(), -1},
            {"directional light", std::make_shared<THREE::DirectionalLight>(), -1},
            {"plain object", std::make_shared<Object3D>(), 1},
            {"group", std::make_shared<THREE::Group>(), 1}};
}

void expectLooksAt(const Looker& looker, const Vector3& target) {
    SCOPED_TRACE(looker.name);
    const Vector3 here = looker.object->matrixWorld.position();
    expectNear(axisOf(*looker.object, 2).multiplyScalar(looker.forwards),
               Vector3(target).sub(here).normalize());
    EXPECT_NEAR(axisOf(*looker.object, 0).dot(looker.object->up), 0, 1e-14) << "the horizon must be level";
    EXPECT_GT(axisOf(*looker.object, 1).dot(looker.object->up), 0) << "upside down";
}

TEST(LookAt, TurnsTheRightAxisToTheTarget) {
    for (const Looker& looker : lookers()) {
        looker.object->position.set(1, 2, 3);
        looker.object->lookAt(-4, 0.5, 7);
        looker.object->updateMatrixWorld();
        expectLooksAt(looker, {-4, 0.5, 7});
    }
}

TEST(LookAt, ByHandForACameraOnTheXAxis) {
    THREE::PerspectiveCamera camera;
    camera.position.set(5, 0, 0);
    camera.lookAt(0, 0, 0);
    EXPECT_NEAR(camera.rotation.y, pi / 2, 1e-15);  // -z turned to -x
    EXPECT_NEAR(camera.rotation.x, 0, 1e-15);
    Object3D mesh;
    mesh.position.set(5, 0, 0);
    mesh.lookAt(0, 0, 0);
    EXPECT_NEAR(mesh.rotation.y, -pi / 2, 1e-15);  // +z turned to -x
}

TEST(LookAt, TheTargetIsAPointOfTheWorldEvenBelowTurnedParents) {
    for (const Looker& looker : lookers()) {
        Object3D outer, inner;
        outer.add(inner);
        inner.add(*looker.object);
        outer.position.set(3, -1, 2);
        outer.rotation.set(0.5, -1.2, 2);
        outer.scale.setScalar(3);
        inner.position.set(0.5, 1, -2);
        inner.rotation.set(-2, 0.3, 1);
        looker.object->position.set(1, 2, 3);
        looker.object->lookAt(-4, 0.5, 7);  // the parents' matrices are not up to date yet: it sees to that
        outer.updateMatrixWorld();
        expectLooksAt(looker, {-4, 0.5, 7});
    }
}

TEST(LookAt, KeepsWhateverUpSays) {
    for (const Looker& looker : lookers()) {
        looker.object->up.set(0, 0, 1);
        looker.object->position.set(4, 4, 2);
        looker.object->lookAt({0, 0, 0});
        looker.object->updateMatrixWorld();
        expectLooksAt(looker, {0, 0, 0});
    }
}

TEST(LookAt, StraightUpOrDownAndAtItselfIsATurnLikeAnyOther) {
    for (const Looker& looker : lookers())
        for (const Vector3& target : {Vector3(1, 9, 3), Vector3(1, -9, 3), Vector3(1, 2, 3)}) {
            SCOPED_TRACE(testing::Message() << looker.name << " at y = " << target.y);
            looker.object->position.set(1, 2, 3);
            looker.object->lookAt(target);
            looker.object->updateMatrixWorld();
            EXPECT_NEAR(looker.object->quaternion.length(), 1, 1e-14);
            if (target.y != 2)
                expectNear(axisOf(*looker.object, 2).multiplyScalar(looker.forwards),
                           {0, target.y > 2 ? 1.0 : -1.0, 0});
        }
}

// A parent without size has no turn of its own to undo; the result must be a rotation all the same.
TEST(LookAt, BelowAFlatOrVanishedParentStaysARotation) {
    for (const Vector3& scale : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(-1, 1, 1)}) {
        Object3D parent, child;
        parent.add(child);
        parent.rotation.set(1, 2, 3);
        parent.scale = scale;
        child.lookAt(1, 2, 3);
        EXPECT_NEAR(child.quaternion.length(), 1, 1e-14) << scale.x << ", " << scale.y << ", " << scale.z;
    }
}

// --- DirectionalLight

TEST(DirectionalLight, PositionIsADirectionAndOnlyItsDirectionCounts) {
    THREE::DirectionalLight light;
    light.updateMatrixWorld();
    EXPECT_EQ(light.directionTowardsLight(), Vector3(0, 1, 0));  // from above, by default
    for (const double length : {1e-30, 1.0, 7.0, 1e30}) {
        light.position.set(2 * length, 3 * length, 6 * length);
        light.updateMatrixWorld();
        expectNear(light.directionTowardsLight(), {2 / 7.0, 3 / 7.0, 6 / 7.0}, 1e-15);
    }
}

TEST(DirectionalLight, ATargetOutsideTheGraphCountsByItsPosition) {
    THREE::Scene scene;
    THREE::DirectionalLight light;
    scene.add(light);
    light.position.set(1, 5, 1);
    light.target.position.set(1, 2, -3);  // nobody updates its matrixWorld
    scene.updateMatrixWorld();
    expectNear(light.directionTowardsLight(), {0, 3 / 5.0, 4 / 5.0}, 1e-15);
}

TEST(DirectionalLight, ATargetInsideTheGraphCountsByItsPlaceInTheWorld) {
    THREE::Scene scene;
    THREE::Group moved;
    THREE::DirectionalLight light;
    scene.add(light, moved);
    moved.add(light.target);
    moved.position.set(10, 0, 0);
    moved.rotation.z = pi / 2;  // takes (0,4,0) to (-4,0,0)
    light.target.position.set(0, 4, 0);
    light.position.set(6, 2, 0);
    scene.updateMatrixWorld();
    expectNear(light.directionTowardsLight(), {0, 1, 0}, 1e-15);
    moved.remove(light.target);  // now (6,2,0) - (0,4,0)
    expectNear(light.directionTowardsLight(), Vector3(6, -2, 0).normalize(), 1e-15);
}

TEST(DirectionalLight, BelowATurnedGroupItComesFromItsPlaceInTheWorld) {
    THREE::Group group;
    THREE::DirectionalLight light;
    group.add(light);
    group.rotation.x = pi / 2;  // takes (0,1,0) to (0,0,1)
    group.updateMatrixWorld();
    expectNear(light.directionTowardsLight(), {0, 0, 1}, 1e-15);
}

TEST(DirectionalLight, OnItsTargetItHasNoDirection) {
    THREE::DirectionalLight light;
    light.target.position = light.position;
    light.updateMatrixWorld();
    EXPECT_EQ(light.directionTowardsLight(), Vector3(0, 0, 0));
}

}  // namespace
