// A depth buffer in doubles, and where it jumps.
// SPDX-License-Identifier: MIT
#include "support/silhouette.hpp"

#include <algorithm>
#include <cmath>

namespace support {

namespace {

struct Buffer {
    int width, height;
    std::vector<double> inverseDepth;  // 1 / w: linear over the picture on a plane; 0 where nothing is
    std::vector<int> mesh;  // number of the mesh, -1: none

    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * width + x); }
};

// One triangle that faces the camera, wholly in front of the near plane.
void rasterise(const glm::dvec4 (&clip)[3], int mesh, bool mirrored, Buffer& buffer) {
    double x[3], y[3], q[3];
    for (int i = 0; i < 3; ++i) {
        if (clip[i].z < -clip[i].w || clip[i].w <= 0)
            return;
        q[i] = 1 / clip[i].w;
        x[i] = (clip[i].x * q[i] * 0.5 + 0.5) * buffer.width;
        y[i] = (0.5 - clip[i].y * q[i] * 0.5) * buffer.height;
    }
    double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (mirrored ? area <= 0 : area >= 0)  // y runs downwards, so counter-clockwise is negative
        return;
    const int left = std::max(0, static_cast<int>(std::floor(std::min({x[0], x[1], x[2]}))));
    const int right = std::min(buffer.width - 1, static_cast<int>(std::ceil(std::max({x[0], x[1], x[2]}))));
    const int top = std::max(0, static_cast<int>(std::floor(std::min({y[0], y[1], y[2]}))));
    const int bottom = std::min(buffer.height - 1, static_cast<int>(std::ceil(std::max({y[0], y[1], y[2]}))));
    for (int py = top; py <= bottom; ++py)
        for (int px = left; px <= right; ++px) {
            double weight[3];
            for (int i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3, k = (i + 2) % 3;
                weight[i] = ((x[k] - x[j]) * (py + 0.5 - y[j]) - (y[k] - y[j]) * (px + 0.5 - x[j])) / area;
            }
            if (weight[0] < 0 || weight[1] < 0 || weight[2] < 0)
                continue;
            const double here = weight[0] * q[0] + weight[1] * q[1] + weight[2] * q[2];
            const std::size_t at = buffer.index(px, py);
            if (here > buffer.inverseDepth[at]) {
                buffer.inverseDepth[at] = here;
                buffer.mesh[at] = mesh;
            }
        }
}

bool smoothAround(const Buffer& buffer, int x, int y) {
    const double here = buffer.inverseDepth[buffer.index(x, y)];
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const int nx = x + dx, ny = y + dy, ox = x - dx, oy = y - dy;
            if (std::min({nx, ny, ox, oy}) < 0 || std::max(nx, ox) >= buffer.width ||
                std::max(ny, oy) >= buffer.height)
                continue;
            if (buffer.mesh[buffer.index(nx, ny)] != buffer.mesh[buffer.index(x, y)])
                return false;
            const double bend = buffer.inverseDepth[buffer.index(nx, ny)] +
                                buffer.inverseDepth[buffer.index(ox, oy)] - 2 * here;
            if (std::abs(bend) > 0.01 * here)
                return false;
        }
    return true;
}

}  // namespace

std::vector<std::uint8_t> awayFromSilhouettes(const THREE::Scene& scene,
                                              const THREE::PerspectiveCamera& camera, int width, int height) {
    const auto pixels = static_cast<std::size_t>(width * height);
    Buffer buffer{width, height, std::vector<double>(pixels, 0), std::vector<int>(pixels, -1)};
    int number = 0;
    const glm::dmat4 toClip = camera.projectionMatrix().elements * camera.matrixWorldInverse().elements;
    scene.traverseVisible([&](const THREE::Object3D& object) {
        const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object);
        if (mesh == nullptr)
            return;
        const THREE::BufferGeometry& geometry = *mesh->geometry;
        const glm::dmat4 matrix = toClip * mesh->matrixWorld.elements;
        const bool mirrored = mesh->matrixWorld.determinant() < 0;
        for (std::size_t t = 0; t < geometry.triangleCount(); ++t) {
            std::uint32_t vertices[3];
            geometry.triangle(t, vertices);
            glm::dvec4 clip[3];
            for (int i = 0; i < 3; ++i)
                clip[i] = matrix *
                          glm::dvec4(glm::dvec3(geometry.getAttribute("position")->getXYZ(vertices[i])), 1);
            rasterise(clip, number, mirrored, buffer);
        }
        ++number;
    });
    std::vector<std::uint8_t> away(pixels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            away[buffer.index(x, y)] = smoothAround(buffer, x, y) ? 1 : 0;
    return away;
}

}  // namespace support
