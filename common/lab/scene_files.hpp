// Scene files: read, and known to be drawable.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/object_loader.hpp"

#include <string>

namespace lab {

/// Reads a scene file and checks everything but the view of it. Throws what ObjectLoader::load and THREE::validate throw.
THREE::LoadedScene loadScene(const std::string& file);

/// The folder that a file is in, as one can watch it: "." where the name has none.
std::string folderOf(const std::string& file);
/// Whether two names are those of one file that is there.
bool sameFile(const std::string& a, const std::string& b);

}  // namespace lab
