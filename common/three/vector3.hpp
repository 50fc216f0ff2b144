// Vector3: a point or a vector in three doubles, on GLM.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace THREE {

/// A point or direction; its space is said where it is used.
/// https://threejs.org/docs/#api/en/math/Vector3
class Vector3 {
  public:
    double x = 0;
    double y = 0;
    double z = 0;

    Vector3() = default;
    Vector3(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
    Vector3(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
    /// The same three numbers for GLM's functions.
    operator glm::dvec3() const { return {x, y, z}; }

    Vector3& set(double x_, double y_, double z_) { return *this = Vector3(x_, y_, z_); }
    Vector3& copy(const Vector3& v) { return *this = v; }
    Vector3& setScalar(double s) { return set(s, s, s); }
    /// On a circle about the y axis; theta in radians from the z axis towards the x axis.
    Vector3& setFromCylindricalCoords(double radius, double theta, double height) {
        return set(radius * std::sin(theta), height, radius * std::cos(theta));
    }
    Vector3& add(const Vector3& v) { return set(x + v.x, y + v.y, z + v.z); }
    Vector3& sub(const Vector3& v) { return set(x - v.x, y - v.y, z - v.z); }
    Vector3& multiplyScalar(double s) { return set(x * s, y * s, z * s); }
    /// The slides' dot product: for unit vectors the cosine of the angle between them (slide 20).
    double dot(const Vector3& v) const { return x * v.x + y * v.y + z * v.z; }
    /// Becomes (this x v): perpendicular to both, right-handed.
    Vector3& cross(const Vector3& v) { return set(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x); }
    /// Does not overflow or underflow before the result itself would.
    double length() const { return std::hypot(x, y, z); }
    double lengthSq() const { return dot(*this); }
    double distanceTo(const Vector3& v) const { return Vector3(*this).sub(v).length(); }
    /// To length 1 whatever the length was; the zero vector stays zero.
    Vector3& normalize();
    bool equals(const Vector3& v) const { return x == v.x && y == v.y && z == v.z; }
};

inline bool operator==(const Vector3& a, const Vector3& b) { return a.equals(b); }

}  // namespace THREE
