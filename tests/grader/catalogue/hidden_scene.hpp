// Scenes that no student has seen: made so that every misconception shows and each looks different from the others.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/object_loader.hpp"

#include <cstdint>

namespace grader {

/// What all the meshes of a hidden scene are made of: Lambertian materials, or Phong's, each with K_S of three different
/// channels and an exponent that is not three.js's.
enum class Finish { matte, shiny };

/// A scene with its camera in it, different for each seed and the same on every machine. In all of them: meshes off the
/// origin, turned before they are scaled unequally, one curved, one coarse, one with flat faces; base colours of three
/// different channels; a directional light and two point lights (k = 2 and 1), tinted, none of intensity 1, one nearer
/// than 1 to a surface; a tinted ambient light of at least 0x30; a camera that is turned about all axes. The picture has
/// points that no light reaches, or one, or several, and points brighter than a screen can show. A shiny scene is the
/// matte one with highlights and one more directional light, from behind. For square pictures.
THREE::LoadedScene hiddenScene(std::uint64_t seed, Finish finish = Finish::shiny);

}  // namespace grader
