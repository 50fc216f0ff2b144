// What is promised of every file that may be a scene: refused by name, or good for everything that follows.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/object_loader.hpp"

#include <functional>
#include <string>

namespace fuzz {

/// `load` must give a scene or a SceneError that begins with `prefix`. A scene goes on: validate may still refuse it; one that it
/// accepts must give a plan of finite numbers and a JSON text that loads as the same scene. Anything else is a finding.
void checkScene(const std::function<THREE::LoadedScene()>& load, const std::string& prefix);

}  // namespace fuzz
