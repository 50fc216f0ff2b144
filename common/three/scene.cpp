// The camera's two matrices.
// SPDX-License-Identifier: MIT
#include "three/scene.hpp"

#include <cmath>
#include <numbers>

namespace THREE {

Matrix4 PerspectiveCamera::projectionMatrix() const {
    const double top = std::tan(fov * std::numbers::pi / 360) / zoom;  // at depth 1
    glm::dmat4 m(0.0);
    m[0][0] = 1 / (top * aspect);
    m[1][1] = 1 / top;
    m[2][2] = -(far + near) / (far - near);
    m[2][3] = -1;
    m[3][2] = -2 * far * near / (far - near);
    return m;
}

Matrix4 PerspectiveCamera::matrixWorldInverse() const { return Matrix4(matrixWorld).invert(); }

}  // namespace THREE
