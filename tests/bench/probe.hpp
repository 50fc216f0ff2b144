// The least that a program does with GL to draw a mesh: what the lab's frames are timed against. Links nothing of the lab.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES3/gl3.h>
#include <cstdint>
#include <vector>

namespace probe {

/// Compiles and links. Throws std::runtime_error with the driver's log. The program is in use afterwards.
GLuint link(const char* vertexShader, const char* fragmentShader);

/// A mesh on the GPU: attribute 0 is the position, 1 the normal.
struct Mesh {
    GLuint vertexArray = 0;
    GLsizei indices = 0;
    GLuint buffers[2] = {0, 0};  ///< vertices, indices
};
/// Six floats for each vertex, three indices for each triangle.
Mesh upload(const std::vector<float>& vertices, const std::vector<std::uint32_t>& index);
void draw(const Mesh& mesh);
void release(const Mesh& mesh);

/// A framebuffer of 8-bit RGBA with depth.
struct Target {
    GLuint framebuffer = 0;
    int width = 0, height = 0;
    GLuint buffers[2] = {0, 0};  ///< colour, depth
};
Target makeTarget(int width, int height);
void release(const Target& target);
/// Binds it, with depth test and back faces culled, and clears it to black.
void begin(const Target& target);
/// R, G, B, A of each pixel of the target that is bound, bottom row first.
std::vector<std::uint8_t> read(const Target& target);

}  // namespace probe
