// The lists of lights of each part of the picture, as textures.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/light_clusters.hpp"
#include "render/program.hpp"

#include <cstdint>

namespace render {

/// The clusters of one context; shaders/clusters.glsl reads what this writes.
class GpuClusters {
  public:
    GpuClusters() = default;
    ~GpuClusters();
    GpuClusters(const GpuClusters&) = delete;
    GpuClusters& operator=(const GpuClusters&) = delete;

    /// The clusters of a frame of this size, pixels.
    void set(lighting::LightClusters clusters, int width, int height, bool reuse);
    /// Gives them to a program, which must be in use.
    void use(const Program& program) const;
    std::uint64_t uploadedBytes() const { return uploaded_; }
    const lighting::LightClusters& clusters() const { return clusters_; }

  private:
    void upload(unsigned& texture, std::size_t perRow, int components, std::vector<std::uint32_t> numbers);

    lighting::LightClusters clusters_;
    int width_ = 1, height_ = 1;
    unsigned begins_ = 0, lights_ = 0;
    std::uint64_t uploaded_ = 0;
};

}  // namespace render
