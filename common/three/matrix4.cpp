// 4x4 transforms, and the matrix that normals are transformed with.
// SPDX-License-Identifier: MIT
#include "three/matrix4.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace THREE {

Matrix4& Matrix4::fromArray(const double (&columns)[16]) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            elements[column][row] = columns[column * 4 + row];
    return *this;
}

Matrix4& Matrix4::compose(const Vector3& position, const Quaternion& quaternion, const Vector3& scale) {
    const glm::dmat3 rotation = glm::mat3_cast(glm::dquat(quaternion));
    elements[0] = glm::dvec4(rotation[0] * scale.x, 0);
    elements[1] = glm::dvec4(rotation[1] * scale.y, 0);
    elements[2] = glm::dvec4(rotation[2] * scale.z, 0);
    elements[3] = glm::dvec4(glm::dvec3(position), 1);
    return *this;
}

namespace {

// A unit vector at right angles to the unit vector v, near the axis number `wanted` unless v lies along it.
Vector3 perpendicularTo(const glm::dvec3& v, int wanted) {
    const int i = std::abs(v[wanted]) < 0.9 ? wanted : (wanted + 1) % 3;
    glm::dvec3 axis(0.0);
    axis[i] = 1;
    return glm::normalize(axis - v[i] * v);
}

// A flat object has lost an axis or more: any that completes a right-handed frame means the same matrix.
void completeFrame(Vector3 (&axis)[3]) {
    for (int i = 0; i < 3; ++i) {
        if (axis[i].lengthSq() > 0)
            continue;
        const Vector3& next = axis[(i + 1) % 3];
        const Vector3& last = axis[(i + 2) % 3];
        if (next.lengthSq() > 0 && last.lengthSq() > 0)
            axis[i] = Vector3(next).cross(last).normalize();
        else if (next.lengthSq() > 0 || last.lengthSq() > 0)
            axis[i] = perpendicularTo(next.lengthSq() > 0 ? next : last, i);
        else
            axis[i].set(i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0);
    }
}

template <class Vector>
double largestElement(const Vector& v) {
    double largest = 0;
    for (int i = 0; i < Vector::length(); ++i)
        largest = std::max(largest, std::abs(v[i]));
    return largest;
}

// The power of two that brings a column to about 1 is 2^-exponent; 0 where there is none.
int exponentOf(double largest) { return largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0; }

}  // namespace

void Matrix4::decompose(Vector3& position, Quaternion& quaternion, Vector3& scale) const {
    Vector3 axis[3] = {glm::dvec3(elements[0]), glm::dvec3(elements[1]), glm::dvec3(elements[2])};
    scale.set(axis[0].length(), axis[1].length(), axis[2].length());
    for (Vector3& a : axis)
        a.normalize();
    // Of the unit axes, because the determinant of a small scale underflows to 0.
    if (Vector3(axis[0]).cross(axis[1]).dot(axis[2]) < 0) {
        scale.x = -scale.x;
        axis[0].multiplyScalar(-1);
    }
    completeFrame(axis);
    const glm::dmat3 rotation{glm::dvec3(axis[0]), glm::dvec3(axis[1]), glm::dvec3(axis[2])};
    position = this->position();
    // Axes that are not at right angles (shear) give a quaternion that is not of unit length.
    quaternion = Quaternion().setFromRotationMatrix(glm::dmat4(rotation)).normalize();
}

double Matrix4::determinant() const { return glm::determinant(elements); }

Matrix4& Matrix4::invert() {
    // Columns are brought to about 1 by powers of two, which is exact; without that, the determinant of a small scale
    // is 0 and that of a large one infinite.
    int exponent[4];
    for (int i = 0; i < 4; ++i) {
        exponent[i] = exponentOf(largestElement(elements[i]));
        for (int row = 0; row < 4; ++row)
            elements[i][row] = std::ldexp(elements[i][row], -exponent[i]);
    }
    if (determinant() == 0)
        return *this = Matrix4(glm::dmat4(0.0));
    elements = glm::inverse(elements);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            elements[column][row] = std::ldexp(elements[column][row], -exponent[row]);
    return *this;
}

Matrix4& Matrix4::lookAt(const Vector3& eye, const Vector3& target, const Vector3& up) {
    Vector3 z = Vector3(eye).sub(target).normalize();
    if (z.lengthSq() == 0)
        z.set(0, 0, 1);
    Vector3 unitUp = Vector3(up).normalize();
    if (unitUp.lengthSq() == 0)
        unitUp.set(0, 1, 0);
    Vector3 x = Vector3(unitUp).cross(z);
    // Looking along `up`, any sideways axis would do; this one is the limit of three.js's small nudge.
    if (x.lengthSq() < 1e-24)
        x = Vector3(unitUp).cross(std::abs(unitUp.z) > 0.9 ? Vector3(1, 0, 0) : Vector3(0, 0, 1));
    x.normalize();
    const Vector3 y = Vector3(z).cross(x);
    elements = glm::dmat4(glm::dvec4(glm::dvec3(x), 0), glm::dvec4(glm::dvec3(y), 0),
                          glm::dvec4(glm::dvec3(z), 0), glm::dvec4(0, 0, 0, 1));
    return *this;
}

Vector3 Matrix4::applyTo(const Vector3& point) const {
    const glm::dvec4 image = elements * glm::dvec4(glm::dvec3(point), 1);
    return glm::dvec3(image) / image.w;
}

namespace {

// a b - c d with one rounding of each product's error (Kahan): cofactors cancel badly without it.
double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
    return {differenceOfProducts(a.y, b.z, a.z, b.y), differenceOfProducts(a.z, b.x, a.x, b.z),
            differenceOfProducts(a.x, b.y, a.y, b.x)};
}

}  // namespace

glm::dmat3 normalMatrix(const glm::dmat4& model) {
    // Columns are brought to about 1 by powers of two, which is exact; cof(A diag(s)) = cof(A) diag(s1 s2, s0 s2, s0 s1),
    // and those factors are put back as exponents relative to the largest, so nothing overflows on the way.
    // What is not a number has no normals: zero, as a point has.
    glm::dvec3 column[3];
    int exponent[3];
    for (int i = 0; i < 3; ++i) {
        column[i] = glm::dvec3(model[i]);
        exponent[i] = exponentOf(largestElement(column[i]));
        for (int row = 0; row < 3; ++row) {
            if (!std::isfinite(column[i][row]))
                return glm::dmat3(0.0);
            column[i][row] = std::ldexp(column[i][row], -exponent[i]);
        }
    }
    glm::dmat3 cofactors(cross(column[1], column[2]), cross(column[2], column[0]),
                         cross(column[0], column[1]));
    const double sign =
        glm::dot(column[0], cofactors[0]) < 0 ? -1 : 1;  // a mirror turns the normals of the cofactors inside

    int highest = -1'000'000;
    int power[3];
    for (int i = 0; i < 3; ++i) {
        power[i] = exponent[(i + 1) % 3] + exponent[(i + 2) % 3];
        const double largest = largestElement(cofactors[i]);
        if (largest > 0)
            highest = std::max(highest, power[i] + std::ilogb(largest));
    }
    for (int i = 0; i < 3; ++i)
        for (int row = 0; row < 3; ++row)
            cofactors[i][row] = sign * std::ldexp(cofactors[i][row], power[i] - highest);
    return cofactors;
}

}  // namespace THREE
