// Random scenes with something to skip: lights that end, many meshes, closed and open, black and shiny.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw.hpp"

#include <cmath>
#include <memory>
#include <rapidcheck.h>
#include <vector>

namespace support {

/// A scene whose every number comes from RapidCheck.
struct RandomLab {
    /// What a property asks for.
    struct Wishes {
        int lights = 12;  ///< at most so many point lights
        int meshes = 6;
        bool ending = true;  ///< some lights have a `distance`
        bool endless = true;  ///< some have none
        bool anySize = true;  ///< in worlds of 1e-6 to 1e6 units
    };

    THREE::Scene scene;
    THREE::Group all;
    std::vector<std::unique_ptr<THREE::BufferGeometry>> geometries;
    std::vector<std::unique_ptr<THREE::Material>> materials;
    std::vector<std::unique_ptr<THREE::Mesh>> meshes;
    std::vector<std::unique_ptr<THREE::Light>> lights;
    THREE::PerspectiveCamera camera;
    DrawOptions options;

    explicit RandomLab(const Wishes& wishes);

    /// RapidCheck's log: what it takes to see it again in scene_viewer.
    std::string text() const;

  private:
    void addMesh();
    void addPoint(const Wishes& wishes);
    void placeCamera();
    void chooseSettings();
    std::unique_ptr<THREE::Material> anyMaterial();
    THREE::Color anyColor();
};

/// Evenly from low to high.
inline double between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1 << 20) / (1 << 20);
}
/// Evenly by octaves.
inline double octaves(double low, double high) { return std::exp2(between(std::log2(low), std::log2(high))); }
/// True in `percent` of the cases.
inline bool chance(int percent) { return *rc::gen::inRange(0, 100) >= 100 - percent; }

}  // namespace support
