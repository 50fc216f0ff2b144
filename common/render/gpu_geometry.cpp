// Uploads vertices as floats relative to a near origin, with unit normals.
// SPDX-License-Identifier: MIT
#include "render/gpu_geometry.hpp"

#include <vector>

namespace render {

namespace {

constexpr std::uint64_t forgetAfterFrames = 1000;

void destroy(const GpuGeometry& gpu) {
    glDeleteVertexArrays(1, &gpu.vertexArray);
    glDeleteBuffers(1, &gpu.vertexBuffer);
    glDeleteBuffers(1, &gpu.indexBuffer);
}

void attribute(GLuint location, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float),
                          reinterpret_cast<const void*>(offset));
}

std::vector<float> vertices(const THREE::BufferGeometry& geometry, const glm::dvec3& origin) {
    const THREE::BufferAttribute* position = geometry.getAttribute("position");
    const THREE::BufferAttribute* normal = geometry.getAttribute("normal");
    std::vector<float> out;
    out.reserve(geometry.vertexCount() * 6);
    const auto push = [&out](const THREE::Vector3& v) {
        for (const double x : {v.x, v.y, v.z})
            out.push_back(static_cast<float>(x));
    };
    for (std::size_t i = 0; i < position->count(); ++i) {
        push(position->getXYZ(i).sub(origin));
        push(normal->getXYZ(i).normalize());
    }
    return out;
}

}  // namespace

void describeVertices() {
    attribute(0, 0);
    attribute(1, 3 * sizeof(float));
}

GpuGeometries::~GpuGeometries() {
    for (const auto& [key, gpu] : geometries_)
        destroy(gpu);
}

const GpuGeometry& GpuGeometries::get(const lighting::Draw& draw, bool reuse) {
    const THREE::BufferGeometry& geometry = *draw.mesh->geometry;
    GpuGeometry& gpu = geometries_[{geometry.id(), draw.flat}];
    if (gpu.version != geometry.version() || !reuse)
        upload(draw, gpu);
    gpu.lastUsed = frame_;
    return gpu;
}

void GpuGeometries::upload(const lighting::Draw& draw, GpuGeometry& gpu) {
    const THREE::BufferGeometry* geometry = draw.mesh->geometry.get();
    THREE::BufferGeometry faces;
    if (draw.flat) {
        geometry->toFaces(faces);
        geometry = &faces;
    }
    const std::vector<float> data = vertices(*geometry, draw.origin);
    const std::vector<std::uint32_t>& index = geometry->index;
    if (gpu.vertexArray == 0) {
        glGenVertexArrays(1, &gpu.vertexArray);
        glGenBuffers(1, &gpu.vertexBuffer);
        glGenBuffers(1, &gpu.indexBuffer);
    }
    glBindVertexArray(gpu.vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, gpu.vertexBuffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(),
                 GL_STATIC_DRAW);
    describeVertices();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indexBuffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(index.size() * sizeof(index[0])),
                 index.data(), GL_STATIC_DRAW);
    gpu.indexed = !index.empty();
    gpu.count = static_cast<GLsizei>(gpu.indexed ? index.size() : geometry->vertexCount() / 3 * 3);
    gpu.version = draw.mesh->geometry->version();
    uploaded_ += data.size() * sizeof(float) + index.size() * sizeof(index[0]);
}

void GpuGeometries::endFrame() {
    ++frame_;
    std::erase_if(geometries_, [this](const auto& entry) {
        const bool forgotten = frame_ - entry.second.lastUsed > forgetAfterFrames;
        if (forgotten)
            destroy(entry.second);
        return forgotten;
    });
}

}  // namespace render
