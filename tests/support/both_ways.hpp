// Draws a scene with and without what lighting/frame_plan.hpp leaves out: the frames must be the same bytes.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw.hpp"

#include <memory>
#include <string>

namespace support {

/// A plan that was drawn in floats and in 8 bits; the stats are those of the floats.
struct Frames {
    lighting::FramePlan plan;
    image::Frame floats, codes;
    render::FrameStats stats;
};

/// Plans and draws. The scene must have been made ready.
Frames drawFrames(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                  const DrawOptions& options);
Frames drawFrames(lighting::FramePlan plan, const DrawOptions& options,
                  render::GlRenderer& with = renderer());

/// Updates matrices and sets the camera's aspect; validates.
void makeReady(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options);

/// Where two frames differ: "" if they are the same bytes, else how many pixels do, the first one's place and both values.
std::string difference(const image::Frame& a, const image::Frame& b);

/// The same of both pairs of frames.
std::string difference(const Frames& a, const Frames& b);
int differingPixels(const image::Frame& a, const image::Frame& b);

/// The same scene with its skips and without (settings.skip).
struct BothWays {
    Frames skipped, whole;

    /// Whether the plan tells of `object`, with a reason that has `why` in it.
    bool tells(const THREE::Object3D& object, const std::string& why) const;
};

/// A plan with nothing skipped, but with only those faces of closed meshes drawn that `skipped` draws, in its order of meshes.
/// These are the two exact skips that pixels may tell. Where a pixel's centre is beyond a silhouette by less than the 1/256
/// pixel that drivers round vertices to, both faces of a solid cover it, and the back one is the nearer. And where two meshes
/// have the same depth, the later one is seen.
lighting::FramePlan withFacesAndOrderOf(const lighting::FramePlan& skipped, lighting::FramePlan whole);

/// A renderer that has seen no light move.
std::unique_ptr<render::GlRenderer> freshRenderer();

/// Makes ready, draws both ways, and fails the test where a byte differs; beyond silhouettes (withFacesAndOrderOf) some pixels may.
BothWays drawBothWays(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options);

}  // namespace support
