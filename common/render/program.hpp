// Compiled shaders: one program per variant, compiled on first use and kept.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"
#include "render/light_numbers.hpp"

#include <GLES3/gl3.h>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
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
    std::uint64_t lastUsed = 0;  ///< a count of Programs that grows
    std::uint64_t lastDrawn = 0;  ///< the same, of Programs::get alone
};

/// What tells programs apart: the variant, and the numbers of the lights that are compiled in.
using ProgramKey = std::pair<lighting::Variant, std::vector<float>>;

/// When a program that is missing is compiled.
enum class Compile {
    atOnce,  ///< the frame waits for it
    aside  ///< frames go on with a program that does the same in another form, where there is one
};

class CompileAside;

/// The programs of one context.
class Programs {
  public:
    /// Compile::aside compiles for each variant whose lights are constants the same with lights as uniforms, which serves any numbers,
    /// and draws with that one while the other is being compiled on a thread of its own.
    Programs(std::string shaderDirectory, Compile when);
    ~Programs();
    Programs(const Programs&) = delete;
    Programs& operator=(const Programs&) = delete;

    /// The program of a variant; where lights are constants, with those of `lights` that stand still compiled in. Throws
    /// ShaderError with file:line if it does not compile.
    Program& get(const lighting::Variant& variant, const LightNumbers& lights);
    /// Whether get() has a program of this variant, or one that stands in for it, without compiling. If not, it is being compiled aside
    /// from now on, or, without a thread for that, left to get(). Throws ShaderError if it was, and failed.
    bool ready(const lighting::Variant& variant);
    /// Has a program that stands in for the variant compiled aside when nothing else is to do.
    void prepare(const lighting::Variant& variant);
    /// Reads and compiles anew the programs that get() returned since beginFrame(); all others when they are wanted. If one fails, everything
    /// stays as it was, and `error` says file:line and what is wrong.
    bool reload(std::string& error);
    void beginFrame() { frameBegan_ = calls_; }

    /// Whether something is compiled on a thread of its own.
    bool aside() const { return aside_ != nullptr; }
    /// Whether what ready() asked for is not there yet.
    bool compiling() const;
    /// Is called, on another thread, when it is there.
    void onCompiled(std::function<void()> call);
    /// More lights than this go into a texture: what the driver's uniforms hold, less some for everything else.
    int uniformLights() const { return uniformLights_; }
    /// Waits for what is being compiled aside.
    void finish();
    /// Time spent in get() on compiling and linking, milliseconds.
    double compileMilliseconds() const { return milliseconds_; }

  private:
    Program* find(const ProgramKey& key);
    Program build(const lighting::Variant& variant, const LightNumbers& lights) const;
    Program& make(const ProgramKey& key, const LightNumbers& lights);
    void keep(ProgramKey key, const Program& program);
    void collect();
    void forgetOldest();
    GLuint compile(GLenum stage, const std::string& file, const std::string& preamble) const;

    std::string directory_;
    std::map<ProgramKey, Program> programs_;
    std::map<ProgramKey, std::string> failed_;  // could not be compiled aside, and why
    std::uint64_t calls_ = 0, frameBegan_ = 0;
    int uniformLights_ = 0;
    double milliseconds_ = 0;
    std::unique_ptr<CompileAside> aside_;  // none: everything at once
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
