// The matrix of normals, rows M1 to M14 of the stability suite: each against a normal that is formed another way.
// SPDX-License-Identifier: MIT
#include "three/matrix4.hpp"
#include "three/object3d.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using THREE::Matrix4;
using THREE::normalMatrix;
using THREE::Quaternion;
using THREE::Vector3;

using Real = long double;
using Vec = glm::vec<3, Real>;
using Mat = glm::mat<3, 3, Real>;

const std::vector<glm::dvec3> normals = {
    {1, 0, 0},       {0, 1, 0},      {0, 0, 1},         {-1, 0, 0},     {0, -1, 0},       {0, 0, -1},
    {0.6, 0.8, 0},   {0, 0.6, -0.8}, {0.36, 0.48, 0.8}, {1, 1, 1},      {-3, 2, 1},       {0.1, -0.2, 5},
    {1e-3, 1, 1e-3}, {4, -5, -0.1},  {-0.2, -0.1, -3},  {2, -0.5, 0.7}, {-0.9, 0.1, -0.4}};

// Two tangents of the surface are transformed as points are, and their cross product is the new normal, turned round
// by a mirror. Long double carries 11 more bits and exponents to 1e4932, so that no scaling is needed.
Vec expectedNormal(const glm::dmat4& model, const glm::dvec3& normal) {
    const Mat m{Vec(glm::dvec3(model[0])), Vec(glm::dvec3(model[1])), Vec(glm::dvec3(model[2]))};
    const Vec n = glm::normalize(Vec(normal));
    const Vec aside = std::abs(n.x) < 0.5L ? Vec(1, 0, 0) : Vec(0, 1, 0);
    const Vec t1 = glm::normalize(glm::cross(n, aside));
    const Vec t2 = glm::cross(n, t1);
    const Vec crossed = glm::cross(m * t1, m * t2);
    return glm::determinant(m) < 0 ? -crossed : crossed;
}

// 180 for anything that is not finite or has no direction.
Real degreesBetween(const glm::dvec3& found, const Vec& expected) {
    const Vec a =
        Vec(found) / std::max({std::abs(Real(found.x)), std::abs(Real(found.y)), std::abs(Real(found.z))});
    const Vec b = expected / std::max({std::abs(expected.x), std::abs(expected.y), std::abs(expected.z)});
    const Real angle =
        std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi_v<Real>;
    return std::isfinite(angle) && glm::length(a) > 0 ? angle : 180;
}

// Asserts the row's bound for every normal of the list; also that the matrix can be given to a float shader.
void expectNormals(const glm::dmat4& model, Real boundDegrees) {
    const glm::dmat3 matrix = normalMatrix(model);
    double largest = 0;
    for (int i = 0; i < 9; ++i)
        largest = std::max(largest, std::abs(matrix[i / 3][i % 3]));
    EXPECT_GE(largest, 0.9);
    EXPECT_LT(largest, 2.1);
    for (const glm::dvec3& n : normals)
        EXPECT_LE(degreesBetween(matrix * n, expectedNormal(model, n)), boundDegrees)
            << "normal " << n.x << ", " << n.y << ", " << n.z;
}

glm::dmat4 scaled(double x, double y, double z) { return Matrix4().compose({}, {}, {x, y, z}); }

// Turns that no axis is fixed in.
const Quaternion turn1 = Quaternion().setFromAxisAngle({1, 2, -0.5}, 1.1);
const Quaternion turn2 = Quaternion().setFromAxisAngle({-0.3, 1, 0.9}, 2.3);

// R1 diag(scale) R2, as two nested objects give it.
glm::dmat4 nested(const Vector3& scale) {
    THREE::Object3D outer, inner;
    outer.add(inner);
    outer.quaternion = turn1;
    outer.scale = scale;
    inner.quaternion = turn2;
    outer.updateMatrixWorld();
    return inner.matrixWorld;
}

bool isZero(const glm::dmat3& m) { return m == glm::dmat3(0.0); }

TEST(NormalMatrix, OfARotationIsThatRotation) {
    const glm::dmat4 turn = Matrix4().compose({7, 8, 9}, turn1, {1, 1, 1});
    expectNormals(turn, 1e-13L);
    EXPECT_LE(
        degreesBetween(normalMatrix(turn) * glm::dvec3(1, 2, 3), Vec(glm::dmat3(turn) * glm::dvec3(1, 2, 3))),
        1e-13L);
}

TEST(NormalMatrix, M1FlatGivesTheNormalOfThePlane) {
    const glm::dvec3 n = normalMatrix(scaled(1, 1, 0)) * glm::dvec3(0.3, 0.7, 1);
    EXPECT_LE(degreesBetween(n, {0, 0, 1}), 1e-5L);
    // Flattened in x after a turn: the plane's normal is the first column's direction lost, (1,0,0) turned.
    const glm::dmat4 flat = Matrix4().compose({}, turn1, {0, 2, 3});
    const glm::dvec3 axis = glm::mat3_cast(glm::dquat(turn1)) * glm::dvec3(1, 0, 0);
    EXPECT_LE(degreesBetween(normalMatrix(flat) * glm::dvec3(0.5, 0.1, -0.7), Vec(axis)), 1e-5L);
    EXPECT_LE(degreesBetween(normalMatrix(flat) * glm::dvec3(-0.5, 0.1, -0.7), Vec(-axis)), 1e-5L);
}

// What is flat and mirrored faces the way its triangles turn: (1,0),(0,1) counter-clockwise becomes clockwise.
TEST(NormalMatrix, M1FlatAndMirroredFollowsTheTriangles) {
    EXPECT_LE(degreesBetween(normalMatrix(scaled(-1, 1, 0)) * glm::dvec3(0, 0, 1), {0, 0, -1}), 1e-5L);
}

TEST(NormalMatrix, M2VanishedIsZeroNotNaN) { EXPECT_TRUE(isZero(normalMatrix(scaled(0, 0, 0)))); }

TEST(NormalMatrix, M3ALineHasNoNormal) {
    EXPECT_TRUE(isZero(normalMatrix(scaled(1, 0, 0))));
    EXPECT_TRUE(isZero(normalMatrix(scaled(0, 1e-30, 0))));
    EXPECT_TRUE(isZero(normalMatrix(Matrix4().compose({}, turn1, {0, 0, 5}))));
}

TEST(NormalMatrix, M4MirrorPointsOutwards) {
    expectNormals(scaled(-1, 1, 1), 1e-5L);
    expectNormals(scaled(1, 1, -1), 1e-5L);
    expectNormals(scaled(-1, -1, -1), 1e-5L);
    expectNormals(Matrix4().compose({}, turn1, {1, -2, 3}), 1e-5L);
    // By hand: the mirror in x turns (0.6,0.8,0) to (-0.6,0.8,0), not to its opposite.
    EXPECT_LE(degreesBetween(normalMatrix(scaled(-1, 1, 1)) * glm::dvec3(0.6, 0.8, 0), {-0.6L, 0.8L, 0}),
              1e-5L);
}

TEST(NormalMatrix, M5ToM9UniformScalesAreExact) {
    for (const double s : {1e-13, 1e-16, 1e-20, 1e13, 1e20, 1e10, 1e-300, 1e36, 1e300, -1e-160}) {
        SCOPED_TRACE(s);
        expectNormals(Matrix4().compose({}, turn1, {s, s, s}), 1e-5L);
    }
}

TEST(NormalMatrix, M10OneAxisAlmostFlat) {
    const glm::dvec3 n = normalMatrix(scaled(1, 1, 1e-30)) * glm::dvec3(0.3, 0.7, 1);
    EXPECT_NEAR(n.x / n.z, 3e-31, 1e-45);
    EXPECT_NEAR(n.y / n.z, 7e-31, 1e-45);
    EXPECT_GT(n.z, 0);
    expectNormals(scaled(1, 1, 1e-30), 1e-5L);
    expectNormals(Matrix4().compose({}, turn2, {1e-30, 1, 1}), 1e-5L);
    expectNormals(scaled(1e-150, 1, 1e150), 1e-5L);
}

TEST(NormalMatrix, M11NonUniformScaleIsNotTheModelMatrix) {
    expectNormals(scaled(1, 2, 3), 1e-5L);
    expectNormals(Matrix4().compose({}, turn1, {1, 2, 3}), 1e-5L);
    // By hand: the plane x + y = 1 under scale (1,2,1) becomes x + y/2 = 1, its normal (2,1,0).
    EXPECT_LE(degreesBetween(normalMatrix(scaled(1, 2, 1)) * glm::dvec3(1, 1, 0), {2, 1, 0}), 1e-5L);
    // The model matrix itself is far off: the bound above would notice it.
    EXPECT_GT(degreesBetween(glm::dmat3(scaled(1, 2, 3)) * glm::dvec3(1, 0, 1),
                             expectedNormal(scaled(1, 2, 3), {1, 0, 1})),
              50);
}

TEST(NormalMatrix, M12NestedScaleOfConditionTwelve) {
    expectNormals(nested({1e6, 1, 1e-6}), 2e-3L);
    expectNormals(nested({-1e6, 1, 1e-6}), 2e-3L);
}

TEST(NormalMatrix, M13NestedTwoSmallAxes) {
    expectNormals(nested({1, 1e-4, 1e-4}), 1e-4L);
    expectNormals(nested({1e-4, -1e-4, 1}), 1e-4L);
}

// Harder than the suite, whose bounds are a float's: cofactors with two roundings each would miss this bound,
// and further on the sign of their determinant. Long double still is good for 3e-10 degrees.
TEST(NormalMatrix, NestedTwoMinuteAxesNeedExactProducts) {
    expectNormals(nested({1, 1e-8, 1e-8}), 1e-8L);
    expectNormals(nested({1e-8, 1, -1e-8}), 1e-8L);
}

// Such a matrix is refused by validate() (test_validate.cpp); here it must only do no harm.
TEST(NormalMatrix, M14NotANumberGivesZero) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()})
        for (int i = 0; i < 9; ++i) {
            glm::dmat4 m = scaled(1, 2, 3);
            m[i / 3][i % 3] = bad;
            EXPECT_TRUE(isZero(normalMatrix(m))) << bad << " in column " << i / 3 << ", row " << i % 3;
        }
}

TEST(NormalMatrix, TheTranslationDoesNotMatter) {
    const glm::dmat4 there = Matrix4().compose({1e30, -5, 1e-9}, turn1, {1, 2, 3});
    const glm::dmat4 here = Matrix4().compose({0, 0, 0}, turn1, {1, 2, 3});
    EXPECT_EQ(normalMatrix(there), normalMatrix(here));
}

// Exactness of power-of-two scales: the very same bits, so that a picture does not depend on the unit of length.
TEST(NormalMatrix, PowersOfTwoChangeNoBit) {
    const glm::dmat4 model = Matrix4().compose({}, turn2, {1, 2.5, 0.3});
    for (const int power : {-500, -40, 17, 600})
        EXPECT_EQ(normalMatrix(std::ldexp(1.0, power) * model), normalMatrix(model)) << power;
}

}  // namespace
