// Scene files: read, and known to be drawable.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/object_loader.hpp"

#include <string>

namespace lab {

/// Reads a scene file and checks everything but the view of it. Throws what ObjectLoader::load and THREE::validate throw.
THREE::LoadedScene loadScene(const std::string& file);

/// Puts a scene file's camera where it stands in the world, with its angle of view and reach: a camera that is none of the file's own
/// objects, and can be turned whatever the file's camera hangs on.
void takeCamera(THREE::PerspectiveCamera& camera, const THREE::PerspectiveCamera& own);
/// Checks what the file's camera sees, if it has one; without one, all is brought into view. Throws what THREE::validate throws.
void expectView(const THREE::LoadedScene& loaded);

/// The folder that a file is in, as one can watch it: "." where the name has none.
std::string folderOf(const std::string& file);
/// Whether two names are those of one file that is there.
bool sameFile(const std::string& a, const std::string& b);

}  // namespace lab
