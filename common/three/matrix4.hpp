// Matrix4: a 4x4 transform in doubles, on GLM.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/rotation.hpp"
#include "three/vector3.hpp"

#include <glm/mat4x4.hpp>

namespace THREE {

/// An affine or projective transform; column vectors, column-major, as in three.js and GLSL.
/// https://threejs.org/docs/#api/en/math/Matrix4
class Matrix4 {
  public:
    glm::dmat4 elements{1.0};  ///< elements[column][row]; the identity at first

    Matrix4() = default;
    Matrix4(const glm::dmat4& m) : elements(m) {}
    operator const glm::dmat4&() const { return elements; }

    Matrix4& identity() { return *this = Matrix4(); }
    /// Sixteen numbers column by column, as three.js's JSON writes them.
    Matrix4& fromArray(const double (&columns)[16]);
    /// Translation x rotation x scale: what position, quaternion and scale mean together.
    Matrix4& compose(const Vector3& position, const Quaternion& quaternion, const Vector3& scale);
    /// The reverse of compose, exact only where there is no shear. A mirrored matrix gets scale.x < 0,
    /// a zero column scale 0 and an axis that completes the frame; nothing becomes NaN.
    void decompose(Vector3& position, Quaternion& quaternion, Vector3& scale) const;
    Matrix4& multiply(const Matrix4& right) { return *this = Matrix4(elements * right.elements); }
    Matrix4& premultiply(const Matrix4& left) { return *this = Matrix4(left.elements * elements); }
    double determinant() const;
    /// Becomes its inverse; a singular matrix becomes zero, as in three.js.
    Matrix4& invert();
    /// The rotation whose z axis points from `target` to `eye` (cameras look along -z). Where eye and target
    /// coincide z stays (0,0,1); an `up` parallel to the view is replaced, never NaN.
    Matrix4& lookAt(const Vector3& eye, const Vector3& target, const Vector3& up);
    /// The image of a point (w divided out).
    Vector3 applyTo(const Vector3& point) const;
    /// The translation column: where this transform puts the origin.
    Vector3 position() const { return {elements[3][0], elements[3][1], elements[3][2]}; }
};

/// The matrix that takes normals where `model` takes points: the inverse transpose of its upper left 3x3 up to a
/// positive factor (slide 33 says "the model matrix"; see slides_refs, errata). Formed as cofactors in double after
/// a power-of-two scaling, times the sign of the determinant, so that mirrored, flat, tiny and huge scales all give
/// finite normals that point outwards; its largest element is about 1. The zero matrix gives zero.
glm::dmat3 normalMatrix(const glm::dmat4& model);

}  // namespace THREE
