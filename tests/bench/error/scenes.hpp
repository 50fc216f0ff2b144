// The ten scenes of the error benchmark, each made hard in one way; a scene has one case or several.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/error/world.hpp"
#include "lighting/reference/equation.hpp"

#include <functional>
#include <string>
#include <vector>

namespace bench::error {

/// What the frames of a case are compared with; never another renderer's picture.
enum class Reference {
    shading,  ///< R1: long double at the driver's own positions and normals; the error is that of the arithmetic alone
    surface,  ///< R2: long double on the exact surface that the triangles stand for
    scene  ///< R3: long double from the scene's description: transforms and interpolation are in the error
};

/// The point of the exact surface for a point of the mesh, with its normal; both about the eye.
using ExactSurface = std::function<lighting::reference::Lit<long double>(
    const lighting::reference::Lit<long double>& at, const THREE::Vector3& eye)>;

/// One picture.
struct Case {
    std::string scene;  ///< "S4"
    std::string name;  ///< what is special in this one: "32 segments"
    int size;  ///< pixels each way, where the command line does not say otherwise
    Reference reference;
    std::function<std::unique_ptr<World>()> make;
    ExactSurface surface = {};  ///< for Reference::surface
    /// What the lighting cost is counted from, where that is not the flat-colour frame of `make`.
    std::function<std::unique_ptr<World>()> floor = {};
};

/// A row of the table.
struct SceneInfo {
    const char* id;
    const char* title;
};
const std::vector<SceneInfo>& sceneTable();

/// All cases in the order of the table; `quick` leaves out the largest ones.
std::vector<Case> allCases(bool quick);

// By file, in the order of the table.
void addLectureScenes(std::vector<Case>& cases);  ///< S0, S1
void addLightScenes(std::vector<Case>& cases, bool quick);  ///< S2, S3, S7, S9
void addShapeScenes(std::vector<Case>& cases, bool quick);  ///< S4, S8
void addPlaceScenes(std::vector<Case>& cases);  ///< S5, S6

}  // namespace bench::error
