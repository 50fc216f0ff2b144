// Unit tests of Matrix4 and of the camera's projection, against values derived by hand.
// SPDX-License-Identifier: MIT
#include "three/matrix4.hpp"
#include "three/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace {

using THREE::Matrix4;
using THREE::Quaternion;
using THREE::Vector3;

const double half = std::sqrt(0.5);  // sine and cosine of 45 degrees: the quaternions of quarter turns

void expectNear(const Vector3& found, const Vector3& expected, double bound) {
    EXPECT_NEAR(found.x, expected.x, bound);
    EXPECT_NEAR(found.y, expected.y, bound);
    EXPECT_NEAR(found.z, expected.z, bound);
}

// `relative`: as a share of the largest element expected.
void expectNear(const Matrix4& found, const Matrix4& expected, double relative) {
    double largest = 0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(expected.elements[i / 4][i % 4]));
    for (int i = 0; i < 16; ++i)
        EXPECT_NEAR(found.elements[i / 4][i % 4], expected.elements[i / 4][i % 4], relative * largest)
            << "column " << i / 4 << ", row " << i % 4;
}

bool isRotation(const Quaternion& q) { return std::abs(q.length() - 1) < 1e-14; }

// --- compose, products, determinant

TEST(Matrix4, ComposeIsTranslationTimesRotationTimesScale) {
    // A quarter turn about z takes (2,0,0) to (0,2,0) and (0,3,0) to (-3,0,0).
    const Matrix4 m = Matrix4().compose({10, 20, 30}, Quaternion(0, 0, half, half), {2, 3, 4});
    const Matrix4 expected = Matrix4().fromArray({0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 20, 30, 1});
    expectNear(m, expected, 1e-16);
    expectNear(m.applyTo({1, 1, 1}), {7, 22, 34}, 1e-14);
    EXPECT_EQ(m.position(), Vector3(10, 20, 30));
    EXPECT_NEAR(m.determinant(), 24, 1e-13);
}

TEST(Matrix4, FromArrayReadsColumnByColumn) {
    const Matrix4 m = Matrix4().fromArray({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
    EXPECT_EQ(m.elements[0], glm::dvec4(0, 1, 2, 3));
    EXPECT_EQ(m.elements[3], glm::dvec4(12, 13, 14, 15));
}

TEST(Matrix4, MultiplyPutsTheArgumentToTheRightAndPremultiplyToTheLeft) {
    const Matrix4 turn = Matrix4().compose({}, Quaternion(0, 0, half, half), {1, 1, 1});
    const Matrix4 move = Matrix4().compose({1, 0, 0}, {}, {1, 1, 1});
    expectNear(Matrix4(turn).multiply(move).applyTo({0, 0, 0}), {0, 1, 0}, 1e-15);  // moved, then turned
    expectNear(Matrix4(turn).premultiply(move).applyTo({0, 0, 0}), {1, 0, 0}, 0);  // turned, then moved
    expectNear(Matrix4(turn).identity(), Matrix4(), 0);
}

TEST(Matrix4, InvertUndoesTurnScaleAndTranslation) {
    const Matrix4 m = Matrix4().compose({10, 20, 30}, Quaternion(0, 0, half, half), {2, 4, 8});
    const Matrix4 inverse = Matrix4(m).invert();
    // x' = -4y+10, y' = 2x+20, z' = 8z+30, so that x = y'/2-10, y = -x'/4+2.5, z = z'/8-3.75.
    const Matrix4 expected =
        Matrix4().fromArray({0, -0.25, 0, 0, 0.5, 0, 0, 0, 0, 0, 0.125, 0, -10, 2.5, -3.75, 1});
    expectNear(inverse, expected, 1e-15);
}

TEST(Matrix4, InvertWorksAtEveryScaleWhoseInverseIsADouble) {
    for (const Vector3& scale :
         {Vector3(1e-120, 1e-120, 1e-120), Vector3(1e120, 1e120, 1e120), Vector3(1e-103, 2e-103, 3e-103),
          Vector3(1e100, 1e-100, 1e-200), Vector3(-1e-36, 1e36, 1e-36), Vector3(1e-300, 1e-300, 1e-300)}) {
        const Matrix4 inverse = Matrix4().compose({}, {}, scale).invert();
        EXPECT_NEAR(inverse.elements[0][0] * scale.x, 1, 1e-14) << scale.x;
        EXPECT_NEAR(inverse.elements[1][1] * scale.y, 1, 1e-14) << scale.y;
        EXPECT_NEAR(inverse.elements[2][2] * scale.z, 1, 1e-14) << scale.z;
        EXPECT_EQ(inverse.elements[3][3], 1);
    }
}

TEST(Matrix4, InvertOfASingularMatrixIsZero) {
    for (const Vector3& scale : {Vector3(1, 1, 0), Vector3(0, 1, 0), Vector3(0, 0, 0)})
        expectNear(Matrix4().compose({1, 2, 3}, {}, scale).invert(), Matrix4(glm::dmat4(0.0)), 0);
}

TEST(Matrix4, InvertOfAProjectionGivesThePointBack) {
    const Matrix4 projection = THREE::PerspectiveCamera(40, 1.5, 0.1, 100).projectionMatrix();
    expectNear(Matrix4(projection).invert().applyTo(projection.applyTo({1, -2, -7})), {1, -2, -7}, 1e-11);
}

// --- decompose

struct Parts {
    Vector3 position, scale;
    Quaternion quaternion;
};

Parts partsOf(const Matrix4& m) {
    Parts parts;
    m.decompose(parts.position, parts.quaternion, parts.scale);
    return parts;
}

TEST(Matrix4, DecomposeGivesBackWhatWasComposed) {
    const Matrix4 m = Matrix4().fromArray({0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 20, 30, 1});
    const Parts parts = partsOf(m);
    EXPECT_EQ(parts.position, Vector3(10, 20, 30));
    expectNear(parts.scale, {2, 3, 4}, 1e-15);
    EXPECT_NEAR(parts.quaternion.x, 0, 1e-15);
    EXPECT_NEAR(parts.quaternion.y, 0, 1e-15);
    EXPECT_NEAR(parts.quaternion.z, half, 1e-15);
    EXPECT_NEAR(parts.quaternion.w, half, 1e-15);
}

TEST(Matrix4, DecomposeOfAMirrorGivesNegativeScaleX) {
    const Matrix4 inX = Matrix4().compose({}, {}, {-2, 3, 4});
    expectNear(partsOf(inX).scale, {-2, 3, 4}, 0);
    // A mirror in y is one in x after half a turn about z.
    const Parts parts = partsOf(Matrix4().compose({}, {}, {2, -3, 4}));
    expectNear(parts.scale, {-2, 3, 4}, 0);
    EXPECT_NEAR(std::abs(parts.quaternion.z), 1, 1e-15);
    EXPECT_NEAR(parts.quaternion.w, 0, 1e-15);
}

// Whatever parts are found, composing them must give the same matrix.
TEST(Matrix4, DecomposedPartsComposeToTheSameMatrix) {
    const Quaternion turn = Quaternion().setFromAxisAngle({1, -2, 0.5}, 2.2);
    const Vector3 scales[] = {{1, 2, 3},
                              {-1, 2, 3},
                              {1, -2, 3},
                              {-1, -2, -3},
                              {1e-150, -1e-150, 1e-150},
                              {1e150, 1e150, -1e150},
                              {1, 2, 0},
                              {1, 0, 3},
                              {0, 2, 3},
                              {-1, 2, 0},
                              {1, 0, 0},
                              {0, 2, 0},
                              {0, 0, -3},
                              {0, 0, 0},
                              {1, 1, 1e-30}};
    for (const Vector3& scale : scales) {
        SCOPED_TRACE(testing::Message() << scale.x << ", " << scale.y << ", " << scale.z);
        const Matrix4 m = Matrix4().compose({1, 2, 3}, turn, scale);
        const Parts parts = partsOf(m);
        EXPECT_TRUE(isRotation(parts.quaternion));
        const Matrix4 again = Matrix4().compose(parts.position, parts.quaternion, parts.scale);
        for (int axis = 0; axis < 3;
             ++axis)  // each column by itself: tiny ones must not hide behind large ones
            for (int row = 0; row < 3; ++row)
                EXPECT_NEAR(again.elements[axis][row], m.elements[axis][row],
                            1e-14 * glm::length(glm::dvec3(m.elements[axis])) + 1e-320);
    }
}

TEST(Matrix4, DecomposeOfAFlatMatrixKeepsTheAxesItHas) {
    const Parts flat = partsOf(Matrix4().compose({}, {}, {2, 3, 0}));
    EXPECT_EQ(flat.scale, Vector3(2, 3, 0));
    EXPECT_NEAR(flat.quaternion.w, 1, 1e-15);  // nothing was turned, and z completes the frame
}

TEST(Matrix4, DecomposeOfAnUnturnedLineOrPointDoesNotTurn) {
    for (const Vector3& scale : {Vector3(2, 0, 0), Vector3(0, 2, 0), Vector3(0, 0, 2), Vector3(0, 0, 0)}) {
        const Parts parts = partsOf(Matrix4().compose({4, 5, 6}, {}, scale));
        EXPECT_EQ(parts.position, Vector3(4, 5, 6));
        EXPECT_EQ(parts.scale, scale);
        EXPECT_NEAR(parts.quaternion.w, 1, 1e-15) << scale.x << ", " << scale.y << ", " << scale.z;
    }
}

// Two or three parallel columns, or sheared ones: no parts mean this matrix, but they must be a rotation and finite.
TEST(Matrix4, DecomposeOfSingularAndShearedMatricesGivesARotation) {
    for (const Matrix4& m : {Matrix4().fromArray({1, 2, 3, 0, 2, 4, 6, 0, 3, 6, 9, 0, 0, 0, 0, 1}),
                             Matrix4().fromArray({1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
                             Matrix4().fromArray({1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}),
                             Matrix4().fromArray({1, 0, 0, 0, 5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
                             Matrix4().fromArray({1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1})})
        EXPECT_TRUE(isRotation(partsOf(m).quaternion));
}

// --- lookAt

// The columns of a rotation: unit, perpendicular, right-handed, in every row of the suite.
void expectRotation(const Matrix4& m) {
    const Vector3 x = glm::dvec3(m.elements[0]), y = glm::dvec3(m.elements[1]), z = glm::dvec3(m.elements[2]);
    for (const Vector3& axis : {x, y, z})
        EXPECT_NEAR(axis.length(), 1, 1e-15);
    EXPECT_NEAR(x.dot(y), 0, 1e-15);
    EXPECT_NEAR(y.dot(z), 0, 1e-15);
    expectNear(Vector3(x).cross(y), z, 1e-15);
}

TEST(Matrix4, LookAtTurnsZFromTheTargetToTheEye) {
    const Matrix4 m = Matrix4().lookAt({5, 0, 0}, {1, 0, 0}, {0, 1, 0});
    expectNear(m, Matrix4().fromArray({0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1}), 0);
    const Matrix4 slanted = Matrix4().lookAt({3, 4, 12}, {0, 0, 0}, {0, 2, 0});
    expectRotation(slanted);
    expectNear(glm::dvec3(slanted.elements[2]), {3 / 13.0, 4 / 13.0, 12 / 13.0}, 1e-15);
    EXPECT_EQ(slanted.elements[0][1], 0);  // x stays level
    EXPECT_GT(slanted.elements[1][1], 0);  // y points upwards
}

TEST(Matrix4, C1EyeOnTheTargetLeavesZ) {
    const Matrix4 m = Matrix4().lookAt({1, 2, 3}, {1, 2, 3}, {0, 1, 0});
    expectNear(m, Matrix4(), 0);
    expectRotation(Matrix4().lookAt({1, 2, 3}, {1, 2, 3}, {0, 0, 1}));
}

TEST(Matrix4, C2UpParallelToTheViewIsSubstituted) {
    for (const Vector3& up : {Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(1, 0, 0), Vector3(1, 1, 3)})
        for (const double distance : {-1e20, -3.0, -1e-9, 1e-9, 3.0, 1e20}) {
            SCOPED_TRACE(testing::Message() << up.x << up.y << up.z << " at " << distance);
            const Vector3 eye = Vector3(up).multiplyScalar(distance);
            const Matrix4 m = Matrix4().lookAt(eye, {0, 0, 0}, up);
            expectRotation(m);
            expectNear(glm::dvec3(m.elements[2]), Vector3(eye).normalize(), 1e-15);
        }
    // As three.js: seen from straight above, x stays x.
    expectNear(glm::dvec3(Matrix4().lookAt({0, 9, 0}, {0, 0, 0}, {0, 1, 0}).elements[0]), {1, 0, 0}, 1e-15);
}

TEST(Matrix4, UpAlmostParallelToTheViewStillDecides) {
    const Matrix4 m = Matrix4().lookAt({1e-9, 1, 0}, {0, 0, 0}, {0, 1, 0});
    expectRotation(m);
    expectNear(glm::dvec3(m.elements[0]), {0, 0, -1}, 1e-6);  // up x z = (0,1,0) x (1e-9,1,0)
}

TEST(Matrix4, C3UpZeroIsSubstituted) {
    for (const Vector3& eye : {Vector3(0, 0, 5), Vector3(0, 5, 0), Vector3(-1, 2, 3), Vector3(0, 0, 0)})
        expectRotation(Matrix4().lookAt(eye, {0, 0, 0}, {0, 0, 0}));
}

TEST(Matrix4, C4EyeFarAwayStaysFinite) {
    for (const double far : {1e20, 1e36, 1e300}) {
        const Matrix4 m = Matrix4().lookAt({far, far, far}, {0, 0, 0}, {0, 1, 0});
        expectRotation(m);
        EXPECT_NEAR(m.elements[2][0], std::sqrt(1.0 / 3), 1e-15) << far;
    }
    expectRotation(Matrix4().lookAt({0, 0, 5}, {0, 0, 0}, {1e-200, 1e-200, 0}));
}

// --- the camera's matrices

TEST(PerspectiveCamera, ProjectionPutsNearFarTopAndRightOnTheUnitCube) {
    // fov 90: half the height equals the depth. aspect 2: half the width is twice that.
    const Matrix4 p = THREE::PerspectiveCamera(90, 2, 1, 3).projectionMatrix();
    const auto clip = [&p](double x, double y, double z) { return p.elements * glm::dvec4(x, y, z, 1); };
    const auto expectClip = [](const glm::dvec4& found, const glm::dvec4& expected) {
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(found[i], expected[i], 4e-15) << "component " << i;
    };
    expectClip(clip(0, 0, -1), {0, 0, -1, 1});  // near: z/w = -1
    expectClip(clip(0, 0, -3), {0, 0, 3, 3});  // far: z/w = 1
    expectClip(clip(0, 2, -2), {0, 2, 1, 2});  // top edge at depth 2: y/w = 1
    expectClip(clip(-4, 0, -2), {-2, 0, 1, 2});  // left edge: x/w = -1
    expectClip(clip(6, -3, -3), {3, -3, 3, 3});  // the far lower right corner
}

TEST(PerspectiveCamera, ZoomMagnifiesWhatTheFieldOfViewLeaves) {
    THREE::PerspectiveCamera camera(90, 1, 1, 3);
    camera.zoom = 2;
    expectNear(camera.projectionMatrix().applyTo({0.5, 0.25, -1}), {1, 0.5, -1}, 1e-14);
    // tan 30 degrees = 1/sqrt 3: the top edge of fov 60 at depth 1.
    const THREE::PerspectiveCamera narrow(60, 1, 1, 3);
    expectNear(narrow.projectionMatrix().applyTo({0, std::sqrt(1.0 / 3), -1}), {0, 1, -1}, 1e-14);
}

TEST(PerspectiveCamera, ViewMatrixTakesTheWorldToTheCamera) {
    THREE::PerspectiveCamera camera;
    camera.position.set(5, 0, 0);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    expectNear(camera.matrixWorldInverse().applyTo({0, 0, 0}), {0, 0, -5}, 5e-15);
    expectNear(camera.matrixWorldInverse().applyTo({5, 1, -2}), {2, 1, 0}, 5e-15);
}

}  // namespace
