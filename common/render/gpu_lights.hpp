// The lights of a plan on their way to the GPU: constants of the shader, uniforms, or a texture where there are too many.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"
#include "render/light_numbers.hpp"
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

    /// Packs the lights of a frame, and notes which of them changed since the frame before.
    void set(const lighting::FramePlan& plan);
    /// The lights of one of the plan's sets.
    const LightNumbers& of(std::size_t lightSet) const { return sets_[lightSet]; }
    /// Whether it has been the same lights that move for some frames, so that the others are worth compiling in. True for a
    /// first frame: what has not been seen to move stands still.
    bool settled() const { return framesSettled_ >= framesToSettle; }
    /// Whether some frames were drawn since then, so that even a program that takes long to compile will pay.
    bool lasting() const { return framesSettled_ >= 2 * framesToSettle; }
    /// Gives a set's lights to a program, which must be in use. What it holds already is not sent again unless `reuse` is false.
    void use(Program& program, std::size_t lightSet, bool reuse);
    std::uint64_t uploadedBytes() const { return uploaded_; }

  private:
    static constexpr int framesToSettle = 8;
    static constexpr int framesToStandStill = 30;

    void watch();
    void uploadTexture(const LightNumbers& lights, bool reuse);

    LightNumbers all_;  // in the plan's order
    std::vector<LightNumbers> sets_;
    LightNumbers before_;  // all_ of the frame before
    std::vector<int> framesStill_;  // of each light
    int ambientStill_ = framesToStandStill;
    std::vector<const THREE::Light*> moving_;  // in order
    int framesSettled_ = framesToSettle;
    LightNumbers inTexture_;  // what the texture holds now
    unsigned texture_ = 0;
    std::uint64_t uploaded_ = 0;
};

}  // namespace render
