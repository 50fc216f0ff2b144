// Uploads lists when they changed.
// SPDX-License-Identifier: MIT
#include "render/gpu_clusters.hpp"

namespace render {

namespace {

// Units of the textures; 0 is the lights'.
constexpr int beginsUnit = 1, lightsUnit = 2;

}  // namespace

GpuClusters::~GpuClusters() {
    glDeleteTextures(1, &begins_);
    glDeleteTextures(1, &lights_);
}

void GpuClusters::set(lighting::LightClusters clusters, int width, int height, bool reuse) {
    width_ = width;
    height_ = height;
    const bool same =
        reuse && begins_ != 0 && clusters.begins == clusters_.begins && clusters.lights == clusters_.lights;
    clusters_ = std::move(clusters);
    if (same)
        return;
    // shaders/clusters.glsl counts on these rows
    upload(begins_, 1024, 4, clusters_.begins);
    upload(lights_, 4096, 1, clusters_.lights);
}

void GpuClusters::upload(unsigned& texture, std::size_t perRow, int components,
                         std::vector<std::uint32_t> numbers) {
    glActiveTexture(GL_TEXTURE0 + (components == 4 ? beginsUnit : lightsUnit));
    if (texture == 0) {
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glBindTexture(GL_TEXTURE_2D, texture);
    const std::size_t row = perRow * static_cast<std::size_t>(components);
    const std::size_t rows = std::max<std::size_t>((numbers.size() + row - 1) / row, 1);
    uploaded_ += numbers.size() * sizeof numbers[0];
    numbers.resize(rows * row);
    const bool four = components == 4;
    glTexImage2D(GL_TEXTURE_2D, 0, four ? GL_RGBA32UI : GL_R32UI, static_cast<GLsizei>(perRow),
                 static_cast<GLsizei>(rows), 0, four ? GL_RGBA_INTEGER : GL_RED_INTEGER, GL_UNSIGNED_INT,
                 numbers.data());
}

void GpuClusters::use(const Program& program) const {
    glActiveTexture(GL_TEXTURE0 + beginsUnit);
    glBindTexture(GL_TEXTURE_2D, begins_);
    glActiveTexture(GL_TEXTURE0 + lightsUnit);
    glBindTexture(GL_TEXTURE_2D, lights_);
    glActiveTexture(GL_TEXTURE0);
    glUniform1i(program.clusterBegins, beginsUnit);
    glUniform1i(program.clusterLights, lightsUnit);
    glUniform3i(program.clusterGrid, clusters_.columns, clusters_.rows, clusters_.slices);
    glUniform4f(program.clusterScale, static_cast<float>(clusters_.columns) / static_cast<float>(width_),
                static_cast<float>(clusters_.rows) / static_cast<float>(height_),
                static_cast<float>(clusters_.slicesPerOctave), static_cast<float>(clusters_.firstSlice));
}

}  // namespace render
