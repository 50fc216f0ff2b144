// Compiled shaders: one program per variant, compiled on first use and kept.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"
#include "render/light_numbers.hpp"

#include <GLES3/gl3.h>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <utility>
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
    GLint clusterBegins = -1;
    GLint clusterLights = -1;
    GLint clusterGrid = -1;
    GLint clusterScale = -1;
    bool constants = false;  ///< lights that stand still are compiled in
    LightNumbers lights;  ///< what the light uniforms hold now, so that nothing is uploaded twice
    glm::vec3 ambient{-1};  ///< the same; no ambient light is negative
    std::uint64_t lastUsed = 0;  ///< counts calls of Programs::get
};

/// The programs of one context.
class Programs {
  public:
    explicit Programs(std::string shaderDirectory);
    ~Programs();
    Programs(const Programs&) = delete;
    Programs& operator=(const Programs&) = delete;

    /// The program of a variant; where lights are constants, with those of `lights` that stand still compiled in. Throws
    /// ShaderError with file:line if it does not compile.
    Program& get(const lighting::Variant& variant, const LightNumbers& lights);
    /// More lights than this go into a texture: what the driver's uniforms hold, less some for everything else.
    int uniformLights() const { return uniformLights_; }
    /// Time spent in get() on compiling and linking, milliseconds.
    double compileMilliseconds() const { return milliseconds_; }

  private:
    /// What tells programs apart: the variant, and the numbers of the lights that are compiled in.
    using Key = std::pair<lighting::Variant, std::vector<float>>;

    Program build(const lighting::Variant& variant, const LightNumbers& lights);
    void forgetOldest();
    GLuint compile(GLenum stage, const std::string& file, const std::string& preamble) const;

    std::string directory_;
    std::map<Key, Program> programs_;
    std::uint64_t calls_ = 0;
    int uniformLights_ = 0;
    double milliseconds_ = 0;
};

/// The two shaders of a draw as they are compiled, one after the other under a comment line each (--dump-shader).
/// No context is needed: lights are in constants, uniforms or a texture as most drivers have them.
std::string dumpShaders(const std::string& directory, const lighting::FramePlan& plan,
                        const lighting::Draw& draw);

/// The file names of a variant's shaders.
struct ShaderFiles {
    const char* vertex;
    const char* fragment;
};
ShaderFiles shaderFiles(const lighting::Variant& variant);

}  // namespace render
