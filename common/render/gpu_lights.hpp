// The lights of a plan on their way to the GPU: as uniforms, or in a texture where there are too many.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"
#include "render/program.hpp"

#include <cstdint>
#include <vector>

namespace render {

/// The lights of one context; shaders/lights.glsl reads what this writes.
class GpuLights {
  public:
    GpuLights() = default;
    ~GpuLights();
    GpuLights(const GpuLights&) = delete;
    GpuLights& operator=(const GpuLights&) = delete;

    /// Packs the lights of a frame: three vec4 each, directional ones first.
    void set(const lighting::FramePlan& plan);
    /// Gives them to a program, which must be in use. What it holds already is not sent again unless `reuse` is false.
    void use(Program& program, bool reuse);
    std::uint64_t uploadedBytes() const { return uploaded_; }

  private:
    void uploadTexture(bool reuse);

    std::vector<float> data_;  // geometry of all lights, then radiance, then falloff, then L_A
    std::size_t count_ = 0;
    std::vector<float> inTexture_;  // what the texture holds now
    GLuint texture_ = 0;
    std::uint64_t uploaded_ = 0;
};

}  // namespace render
