// Geometries on the GPU: uploaded once per version.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

#include <GLES3/gl3.h>
#include <cstdint>
#include <map>
#include <tuple>

namespace render {

/// A geometry's buffers, ready to draw.
struct GpuGeometry {
    GLuint vertexArray = 0;
    GLuint vertexBuffer = 0;  ///< position and normal, three floats each, per vertex
    GLuint indexBuffer = 0;  ///< 32-bit indices, or empty
    bool indexed = false;  ///< whether indexBuffer is used
    GLsizei count = 0;  ///< indices or vertices to draw
    std::uint64_t version = 0;
    std::uint64_t lastUsed = 0;  ///< frame number
};

/// Tells the vertex array that is bound how the buffer that is bound lies: see GpuGeometry::vertexBuffer.
void describeVertices();

/// The geometries of one context.
class GpuGeometries {
  public:
    GpuGeometries() = default;
    ~GpuGeometries();
    GpuGeometries(const GpuGeometries&) = delete;
    GpuGeometries& operator=(const GpuGeometries&) = delete;

    /// The buffers of a draw's geometry, uploaded if they are new or changed, or always where `reuse` is false. A
    /// flat draw gets three vertices per triangle and the triangle's normal.
    const GpuGeometry& get(const lighting::Draw& draw, bool reuse);
    /// Call once per frame: forgets what was not drawn for a long time.
    void endFrame();
    std::uint64_t uploadedBytes() const { return uploaded_; }

  private:
    void upload(const lighting::Draw& draw, GpuGeometry& gpu);

    std::map<std::tuple<std::uint64_t, bool>, GpuGeometry>
        geometries_;  // by resource id and whether faces are flat
    std::uint64_t frame_ = 0;
    std::uint64_t uploaded_ = 0;
};

}  // namespace render
