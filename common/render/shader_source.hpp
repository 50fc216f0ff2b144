// GLSL files with their #includes put together, so that errors still name the file and line they stand in.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"
#include "render/light_numbers.hpp"

#include <string>
#include <vector>

namespace render {

/// Where a line of a put-together shader stands; line 0: written by the framework.
struct ShaderLine {
    std::string
        file;  ///< path below the shader folder; full path of a file of the lab that lies under no --shaders DIR
    std::size_t line;  ///< from 1
};

/// One shader as the driver gets it, and where each of its lines comes from. (No #line: some drivers lose the file
/// number in some messages, while plain line numbers they all tell.)
struct ShaderSource {
    std::string text;  ///< complete GLSL ES 3.00
    std::vector<ShaderLine> lines;  ///< of each line of the text
};

/// The folder to look for shader files in first: `asked` (--shaders) if not empty, else the lab's own (image/home.hpp).
/// Throws ShaderError if `asked` has none of the lab's shader files, or the lab's own are gone.
std::string findShaderDirectory(const std::string& asked);

/// Reads `file`, puts each #include "x" in its place, once each, after `preamble`. Both are paths below `directory`, or,
/// where that has no such file, below the lab's own folder. A loop under `#pragma unroll` is written out where the
/// preamble's lights are constants (shader_loops.hpp). Throws ShaderError for a missing file, with the file:line of
/// the #include.
ShaderSource readShader(const std::string& directory, const std::string& file, const std::string& preamble);

/// The #version, precision and #define lines that make a variant, and the lights that are constants in it; `fragment` tells
/// the stages apart.
std::string preamble(const lighting::Variant& variant, const LightNumbers& lights, bool fragment);

/// A driver's message with our files: "terms/cosine.glsl:7: ..." and the lines around the first error.
std::string explain(const std::string& driverMessage, const std::string& directory,
                    const ShaderSource& source);

}  // namespace render
