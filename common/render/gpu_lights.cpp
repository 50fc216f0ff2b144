// Packs lights into vec4s and sends them only when they changed.
// SPDX-License-Identifier: MIT
#include "render/gpu_lights.hpp"

#include <algorithm>
#include <limits>

namespace render {

namespace {

constexpr std::size_t lightsPerRow = 512;  // shaders/lights.glsl counts on it

float toFloat(double x) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -largest, largest));
}

}  // namespace

GpuLights::~GpuLights() { glDeleteTextures(1, &texture_); }

void GpuLights::set(const lighting::FramePlan& plan) {
    count_ = plan.directional.size() + plan.point.size();
    data_.assign(count_ * 12 + 3, 0.0F);
    std::size_t i = 0;
    const auto write = [this](std::size_t light, std::size_t part, const glm::dvec3& v, double w) {
        float* const out = &data_[(part * count_ + light) * 4];
        out[0] = toFloat(v.x);
        out[1] = toFloat(v.y);
        out[2] = toFloat(v.z);
        out[3] = toFloat(w);
    };
    for (const lighting::DirectionalAddend& light : plan.directional) {
        write(i, 0, light.w, 0);
        write(i++, 1, light.color, light.intensity);
    }
    for (const lighting::PointAddend& light : plan.point) {
        write(i, 0, light.position, 0);
        write(i, 1, light.color, light.intensity);
        const double perDistance = light.distance > 0 ? 1 / light.distance : 0;
        write(i++, 2, {perDistance, light.decay, light.exponent}, 0);
    }
    for (int channel = 0; channel < 3; ++channel)
        data_[count_ * 12 + static_cast<std::size_t>(channel)] = toFloat(plan.ambient[channel]);
}

void GpuLights::use(Program& program, bool reuse) {
    if (program.lightData >= 0)
        uploadTexture(reuse);
    if (reuse && program.lights == data_)
        return;
    const GLsizei n = static_cast<GLsizei>(count_);
    const float* const radiance = data_.data() + count_ * 4;
    const float* const falloff = data_.data() + count_ * 8;
    if (program.lightGeometry >= 0)
        glUniform4fv(program.lightGeometry, n, data_.data());
    if (program.lightRadiance >= 0)
        glUniform4fv(program.lightRadiance, n, radiance);
    if (program.lightFalloff >= 0)
        glUniform4fv(program.lightFalloff, n, falloff);
    glUniform3fv(program.ambientLight, 1, data_.data() + count_ * 12);
    program.lights = data_;
    uploaded_ += program.lightData >= 0 ? 3 * sizeof(float) : data_.size() * sizeof(float);
}

void GpuLights::uploadTexture(bool reuse) {
    if (texture_ == 0) {
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
    if (reuse && inTexture_ == data_)
        return;
    const std::size_t rows = (count_ + lightsPerRow - 1) / lightsPerRow;
    std::vector<float> texels(rows * lightsPerRow * 12, 0.0F);
    for (std::size_t light = 0; light < count_; ++light)
        for (std::size_t part = 0; part < 3; ++part)
            std::copy_n(&data_[(part * count_ + light) * 4], 4, &texels[(light * 3 + part) * 4]);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, lightsPerRow * 3, static_cast<GLsizei>(rows), 0, GL_RGBA,
                 GL_FLOAT, texels.data());
    inTexture_ = data_;
    uploaded_ += texels.size() * sizeof(float);
}

}  // namespace render
