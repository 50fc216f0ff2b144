// Euler angles and quaternions, and the way from one to the other.
// SPDX-License-Identifier: MIT
#include "three/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace THREE {

Vector3& Vector3::normalize() {
    // Scaled by the largest component first, so that neither 1e-200 nor 1e200 leaves the range of doubles.
    const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
    if (!(largest > 0))
        return *this;
    // Divided, not times 1/largest, which is infinite for the smallest doubles.
    set(x / largest, y / largest, z / largest);
    return multiplyScalar(1 / std::sqrt(lengthSq()));
}

Euler& Euler::set(double x_, double y_, double z_, EulerOrder order) {
    setSilently(Euler(x_, y_, z_, order));
    if (listener_ != nullptr)
        listener_->changed();
    return *this;
}

void Euler::setSilently(const Euler& other) {
    x.setSilently(other.x);
    y.setSilently(other.y);
    z.setSilently(other.z);
    order_ = other.order_;
}

void Euler::listen(ChangeListener* listener) {
    listener_ = listener;
    x.listen(listener);
    y.listen(listener);
    z.listen(listener);
}

namespace {

// The axes of an order, first applied last: XYZ means R = Rx Ry Rz.
struct Axes {
    int first, second, third;
    double parity;  // +1 for the cyclic orders XYZ, YZX, ZXY, -1 for the others
};

Axes axesOf(EulerOrder order) {
    switch (order) {
    case EulerOrder::YXZ:
        return {1, 0, 2, -1};
    case EulerOrder::ZXY:
        return {2, 0, 1, 1};
    case EulerOrder::ZYX:
        return {2, 1, 0, -1};
    case EulerOrder::YZX:
        return {1, 2, 0, 1};
    case EulerOrder::XZY:
        return {0, 2, 1, -1};
    case EulerOrder::XYZ:
        break;
    }
    return {0, 1, 2, 1};
}

}  // namespace

Euler& Euler::setFromRotationMatrix(const glm::dmat4& m, EulerOrder order) {
    const auto [i, j, k, parity] = axesOf(order);
    const auto at = [&m](int row, int column) { return m[column][row]; };
    double angle[3];
    const double sine = std::clamp(parity * at(i, k), -1.0, 1.0);
    angle[j] = std::asin(sine);
    if (std::abs(sine) < 0.9999999) {
        angle[i] = std::atan2(-parity * at(j, k), at(k, k));
        angle[k] = std::atan2(-parity * at(i, j), at(i, i));
    } else {  // gimbal lock: only the sum or difference of the outer angles is known, the last one is taken as 0
        angle[i] = std::atan2(parity * at(k, j), at(j, j));
        angle[k] = 0;
    }
    return set(angle[0], angle[1], angle[2], order);
}

Quaternion& Quaternion::set(double x_, double y_, double z_, double w_) {
    setSilently(Quaternion(x_, y_, z_, w_));
    if (listener_ != nullptr)
        listener_->changed();
    return *this;
}

void Quaternion::setSilently(const Quaternion& other) {
    x.setSilently(other.x);
    y.setSilently(other.y);
    z.setSilently(other.z);
    w.setSilently(other.w);
}

void Quaternion::listen(ChangeListener* listener) {
    listener_ = listener;
    for (Observed* component : {&x, &y, &z, &w})
        component->listen(listener);
}

Quaternion& Quaternion::setFromEuler(const Euler& euler) {
    const double half[3] = {euler.x / 2, euler.y / 2, euler.z / 2};
    const auto turn = [&half](int axis) {
        glm::dquat q(std::cos(half[axis]), 0, 0, 0);
        q[axis] = std::sin(half[axis]);  // GLM's quaternion operator[] runs x, y, z, w
        return q;
    };
    const Axes axes = axesOf(euler.order());
    return *this = Quaternion(turn(axes.first) * turn(axes.second) * turn(axes.third));
}

Quaternion& Quaternion::setFromAxisAngle(const Vector3& axis, double angle) {
    const Vector3 unit = Vector3(axis).normalize();
    if (unit.lengthSq() == 0)
        return set(0, 0, 0, 1);
    const double s = std::sin(angle / 2);
    return set(unit.x * s, unit.y * s, unit.z * s, std::cos(angle / 2));
}

Quaternion& Quaternion::setFromRotationMatrix(const glm::dmat4& m) {
    return *this = Quaternion(glm::quat_cast(glm::dmat3(m)));
}

double Quaternion::length() const { return std::sqrt(x * x + y * y + z * z + w * w); }

Quaternion& Quaternion::normalize() {
    // Scaled by the largest component first, as in Vector3::normalize.
    const double largest = std::max({std::abs(x), std::abs(y), std::abs(z), std::abs(w)});
    const Quaternion scaled(x / largest, y / largest, z / largest, w / largest);
    const double l = scaled.length();
    if (!(l >= 1))  // NaN: it was zero, infinite or not a number
        return set(0, 0, 0, 1);
    return set(scaled.x / l, scaled.y / l, scaled.z / l, scaled.w / l);
}

}  // namespace THREE
