// Compiled shaders: one program per variant, compiled on first use and kept.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

#include <GLES3/gl3.h>
#include <map>
#include <string>
#include <vector>

namespace render {

/// A linked program with the places of its uniforms (-1: not in this variant, which GL ignores).
struct Program {
    GLuint id = 0;
    GLint modelViewProjectionMatrix = -1;
    GLint modelMatrix = -1;
    GLint normalMatrix = -1;
    GLint baseColor = -1;
    GLint emissive = -1;
    GLint specularColor = -1;
    GLint shininess = -1;
    GLint eyePosition = -1;
    GLint ambientLight = -1;
    GLint lightGeometry = -1;
    GLint lightRadiance = -1;
    GLint lightFalloff = -1;
    GLint lightData = -1;
    std::vector<float> lights;  ///< what the light uniforms hold now, so that nothing is uploaded twice
};

/// The programs of one context.
class Programs {
  public:
    explicit Programs(std::string shaderDirectory);
    ~Programs();
    Programs(const Programs&) = delete;
    Programs& operator=(const Programs&) = delete;

    /// The program of a variant. Throws ShaderError with file:line if it does not compile.
    Program& get(const lighting::Variant& variant);
    /// More lights than this go into a texture: what the driver's uniforms hold, less some for everything else.
    int uniformLights() const { return uniformLights_; }
    /// Time spent in get() on compiling and linking, milliseconds.
    double compileMilliseconds() const { return milliseconds_; }

  private:
    Program build(const lighting::Variant& variant);
    GLuint compile(GLenum stage, const std::string& file, const std::string& preamble) const;

    std::string directory_;
    std::map<lighting::Variant, Program> programs_;
    int uniformLights_ = 0;
    double milliseconds_ = 0;
};

/// The two shaders of a variant as they are compiled, one after the other under a comment line each (--dump-shader).
/// No context is needed: beyond 256 lights they are in a texture on every driver, below that as most drivers have it.
std::string dumpShaders(const std::string& directory, const lighting::Variant& variant);

/// The file names of a variant's shaders.
struct ShaderFiles {
    const char* vertex;
    const char* fragment;
};
ShaderFiles shaderFiles(const lighting::Variant& variant);

}  // namespace render
