// A frame as it should be, by the reference in doubles, with all that judging asks of it.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/report.hpp"
#include "lighting/reference/reference.hpp"
#include "three/object_loader.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace grader {

/// Parts of a picture that mistakes show in differently.
enum class Region : std::uint8_t {
    lit,  ///< some lamp's n . w is clearly above 0
    unlit,  ///< every lamp is behind, or there is none
    terminator,  ///< between the two: the best n . w is about 0
    silhouette,  ///< within a pixel of an edge, where rasterisers may differ
    background  ///< no lit surface
};
inline constexpr int regionCount = 5;
const char* nameOf(Region region);

class ExpectedFrame {
  public:
    /// The scene must have a camera in it, and be valid. `name` is what the report calls the frame.
    ExpectedFrame(std::shared_ptr<const THREE::LoadedScene> scene, int size,
                  const lighting::Switches& switches, std::string name);

    const std::string& name() const { return name_; }
    int size() const { return size_; }
    const THREE::LoadedScene& scene() const { return *scene_; }
    /// R, G, B of each pixel, linear, not clamped, top row first.
    const std::vector<float>& pixels() const { return pixels_; }
    const std::vector<Region>& regions() const { return regions_; }
    /// The equation at a pixel, symbol by symbol, as it should be.
    std::vector<TermNumber> numbersAt(int x, int y) const;

  private:
    std::shared_ptr<const THREE::LoadedScene> scene_;
    int size_;
    std::string name_;
    lighting::reference::Reference<double> reference_;
    std::vector<float> pixels_;
    std::vector<Region> regions_;
};

/// How far apart two values may be on a screen, which clamps to [0,1] (slide 39): half an 8-bit code. Drivers were measured
/// at a tenth of one.
inline constexpr double tolerance = 0.5 / 255;
/// The largest difference of the three channels after the clamp.
double apartAt(const std::vector<float>& a, const std::vector<float>& b, std::size_t pixel);

/// A frame held against the expected one.
struct FrameVerdict {
    struct Share {
        long long pixels = 0, right = 0;
        double share() const {
            return pixels == 0 ? 1 : static_cast<double>(right) / static_cast<double>(pixels);
        }
    };
    std::array<Share, regionCount> regions{};
    std::size_t worst = 0;  ///< pixel outside the silhouettes that is farthest off
    double worstBy = 0;  ///< 0 to 1

    /// Of all pixels but silhouettes.
    double share() const;
    /// Whether the frame is as expected: hardly a pixel of any region is not. Silhouettes get some slack.
    bool right() const;
};
FrameVerdict compare(const ExpectedFrame& expected, const std::vector<float>& found);

}  // namespace grader
