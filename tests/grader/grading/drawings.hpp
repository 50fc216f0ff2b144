// What a program is asked to draw, and the scenes that it writes.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/builder.hpp"
#include "grader/judge/views.hpp"
#include "three/object_loader.hpp"

#include <memory>

namespace grader {

/// A drawing without lines: the program in the rubric's size, with these shaders and the lamp's state.
Drawing drawingOf(const Rubric& rubric, std::string program,
                  const std::map<std::string, std::string>& shaders);
/// The lab's shaders as those of a student are tried in: each function gets what its name says. The lab's own point.glsl hands
/// clamp_cosine the cosine divided by d^k already, which saves a division; there clamp(c, 0.0, 1.0) would be wrong, though
/// no cosine is above 1. Throws std::runtime_error where point.glsl is not as it was.
std::map<std::string, std::string> shadersToTryIn(std::map<std::string, std::string> lab);

/// The line of a view, for Drawing::lines.
std::string lineOf(const View& view);
/// The scene at a view, as the program itself describes it.
Dump dumpAt(const Confinement& confinement, const Kit& kit, Drawing drawing, const View& view);
/// The same, read and checked. Throws THREE::SceneError, or std::runtime_error if it has no camera or is huge.
std::shared_ptr<const THREE::LoadedScene> loadScene(const std::string& json);

}  // namespace grader
