// Wavefront .obj and .mtl as text: checked line by line before tinyobjloader reads them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace THREE {

/// An .obj of which every line is known to be sound.
struct ObjText {
    std::string text;  ///< only the lines that tinyobjloader is to read
    bool hasSmoothing = false;  ///< whether any "s" line says where the surface is smooth
    std::vector<std::string> notes;  ///< what was left out
};

/// Throws SceneError with file and line: an unknown keyword, a missing or bad number, a face with fewer than 3 corners or
/// with a vertex that does not exist. tinyobjloader itself would read most of these as 0 or pass them over in silence.
ObjText checkObj(const std::string& text, const std::string& file);

/// The lines of an .mtl, checked likewise: numbers of Kd, Ke, Ks, Ns, illum and d. Notes what is left out.
ObjText checkMtl(const std::string& text, const std::string& file);

}  // namespace THREE
