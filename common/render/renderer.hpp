// The one interface behind which a renderer stands: scene, camera and settings in, a frame out.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"
#include "lighting/frame_plan.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace render {

/// What a frame cost and what it did without (--stats).
struct FrameStats {
    int drawCalls = 0;
    long long triangles = 0;
    int meshesDrawn = 0;
    int meshesSkipped = 0;
    int lightsUsed = 0;  ///< ambient ones included
    int lightsSkipped = 0;
    long long pairsSkipped =
        0;  ///< a mesh and a light that ends before it, or that its black surface swallows
    int sidesSkipped = 0;  ///< closed meshes whose hidden back faces were not drawn
    double cutCodes = 0;  ///< the most that --light-cut took from a pixel, 8-bit codes
    std::size_t clusters = 0;  ///< parts of the picture with a list of lights of their own; 0: none needed
    std::size_t clusterEntries = 0;  ///< lights in all their lists
    std::vector<lighting::Skipped> skipped;  ///< what and why; the objects must still be there
    bool shiny = false;  ///< some material has a highlight
    std::set<lighting::Variant> variants;  ///< the shaders that drew; none where there are no shaders
    std::uint64_t uploadedBytes = 0;  ///< by this frame: vertices, indices, lights
    double compileMilliseconds = 0;  ///< since the renderer began
    double planMilliseconds = 0;  ///< deciding what this frame needs; 0 where there is no plan
    double finishMilliseconds = 0;  ///< waiting for the driver after the last call
    double readMilliseconds = 0;  ///< fetching the pixels
    std::optional<long long> nonfinite;  ///< pixels that met NaN or infinity; none: not counted
};

/// How a frame is wanted.
struct FrameRequest {
    int width = 512;
    int height = 512;
    bool floats = false;  ///< linear, unclamped floats instead of 8-bit codes
};

/// A plan's share of a picture: some of its columns, as they would be in the whole picture.
struct Part {
    const lighting::FramePlan* plan;
    const lighting::Settings* settings;  ///< that it was planned with
    int firstColumn, endColumn;  ///< from the left, 0 <= firstColumn <= endColumn <= the picture's width
};

/// Is told the share of a slow frame that is done, 0 to 1.
using Progress = std::function<void(double share)>;

/// Draws frames. The matrices of scene and camera must be up to date and validated.
class Renderer {
  public:
    virtual ~Renderer() = default;
    /// Draws one frame and returns it. Throws NoRenderer, ShaderError.
    virtual image::Frame render(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                                const lighting::Settings& settings, const FrameRequest& request) = 0;
    /// The same without handing the frame over, for timing.
    virtual void renderOnly(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                            const lighting::Settings& settings, const FrameRequest& request) {
        render(scene, camera, settings, request);
    }
    /// Of the last frame.
    virtual FrameStats stats() const = 0;
    /// The driver's own name for itself.
    virtual std::string name() const = 0;
};

/// Two frames of one size and kind as one: the columns before `column` of the left one, the others of the right one. As the parts of
/// two plans are drawn, for renderers that have no plans. Throws image::Error if they do not fit together.
image::Frame sideBySide(const image::Frame& left, const image::Frame& right, int column);

}  // namespace render
