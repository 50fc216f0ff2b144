// GLSL files with their #includes put together, so that errors still name the file and line they stand in.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

#include <string>
#include <vector>

namespace render {

/// Where a line of a put-together shader stands; line 0: written by the framework.
struct ShaderLine {
    std::string file;  ///< path below the shader folder
    std::size_t line;  ///< from 1
};

/// One shader as the driver gets it, and where each of its lines comes from. (No #line: some drivers lose the file
/// number in some messages, while plain line numbers they all tell.)
struct ShaderSource {
    std::string text;  ///< complete GLSL ES 3.00
    std::vector<ShaderLine> lines;  ///< of each line of the text
};

/// The folder of the shader files: `asked` if not empty (--shaders), else share/ beside the program where the lab is
/// installed, else the source tree's. Throws ShaderError if it holds no mesh.vert.
std::string findShaderDirectory(const std::string& asked);

/// Reads `file` of `directory`, puts each #include "x" (a path below the folder) in its place, once each, after
/// `preamble`. Throws ShaderError for a missing file, with the file:line of the #include.
ShaderSource readShader(const std::string& directory, const std::string& file, const std::string& preamble);

/// The #version, precision and #define lines that make a variant; `fragment` tells the stages apart.
std::string preamble(const lighting::Variant& variant, bool fragment, bool lightsInTexture);

/// A driver's message with our files: "terms/cosine.glsl:7: ..." and the lines around the first error.
std::string explain(const std::string& driverMessage, const std::string& directory,
                    const ShaderSource& source);

}  // namespace render
