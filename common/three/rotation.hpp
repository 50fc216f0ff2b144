// Euler and Quaternion: two ways to say the same rotation, kept in step by Object3D.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/observed.hpp"
#include "three/vector3.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <string_view>

namespace THREE {

/// The six orders in which the three turns may be applied; XYZ is three.js's default.
enum class EulerOrder { XYZ, YXZ, ZXY, ZYX, YZX, XZY };

/// Three turns about the object's own axes, in radians, applied in `order`.
/// https://threejs.org/docs/#api/en/math/Euler
class Euler {
  public:
    Observed x;  ///< about the x axis, radians
    Observed y;  ///< about the y axis, radians
    Observed z;  ///< about the z axis, radians

    Euler() = default;
    Euler(double x_, double y_, double z_, EulerOrder order = EulerOrder::XYZ)
        : x(x_), y(y_), z(z_), order_(order) {}
    /// A copy has the same angles and tells nobody.
    Euler(const Euler& other) : Euler(other.x, other.y, other.z, other.order_) {}
    Euler& operator=(const Euler& other) { return set(other.x, other.y, other.z, other.order_); }

    Euler& set(double x_, double y_, double z_) { return set(x_, y_, z_, order_); }
    Euler& set(double x_, double y_, double z_, EulerOrder order);
    Euler& copy(const Euler& other) { return *this = other; }
    EulerOrder order() const { return order_; }
    /// The angles of a rotation matrix (upper left 3x3, no scale), in `order`.
    Euler& setFromRotationMatrix(const glm::dmat4& m, EulerOrder order);

    /// For Object3D: set without telling the listener, and who listens.
    void setSilently(const Euler& other);
    void listen(ChangeListener* listener);

  private:
    EulerOrder order_ = EulerOrder::XYZ;
    ChangeListener* listener_ = nullptr;
};

/// A rotation as a unit quaternion (x, y, z, w).
/// https://threejs.org/docs/#api/en/math/Quaternion
class Quaternion {
  public:
    Observed x;
    Observed y;
    Observed z;
    Observed w = 1;

    Quaternion() = default;
    Quaternion(double x_, double y_, double z_, double w_) : x(x_), y(y_), z(z_), w(w_) {}
    Quaternion(const glm::dquat& q) : Quaternion(q.x, q.y, q.z, q.w) {}
    /// A copy has the same numbers and tells nobody.
    Quaternion(const Quaternion& other) : Quaternion(other.x, other.y, other.z, other.w) {}
    Quaternion& operator=(const Quaternion& other) { return set(other.x, other.y, other.z, other.w); }
    operator glm::dquat() const { return {double(w), double(x), double(y), double(z)}; }

    Quaternion& set(double x_, double y_, double z_, double w_);
    Quaternion& copy(const Quaternion& other) { return *this = other; }
    Quaternion& setFromEuler(const Euler& euler);
    /// A turn by `angle` radians about `axis`, which is normalised; a zero axis gives the identity.
    Quaternion& setFromAxisAngle(const Vector3& axis, double angle);
    /// From the upper left 3x3 of a pure rotation.
    Quaternion& setFromRotationMatrix(const glm::dmat4& m);
    /// To unit length; the zero quaternion becomes the identity.
    Quaternion& normalize();
    double length() const;

    /// For Object3D: set without telling the listener, and who listens.
    void setSilently(const Quaternion& other);
    void listen(ChangeListener* listener);

  private:
    ChangeListener* listener_ = nullptr;
};

}  // namespace THREE
