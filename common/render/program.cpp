// Compiles and links the shaders of a variant.
// SPDX-License-Identifier: MIT
#include "render/program.hpp"

#include "render/compile_aside.hpp"
#include "render/error.hpp"
#include "render/shader_source.hpp"

#include <algorithm>
#include <chrono>

namespace render {

namespace {

constexpr int mostUniformLights = 256;
constexpr std::size_t mostPrograms = 256;

// The numbers that are compiled into a program: of each light a 1 if it moves, or a 0 and what it is.
std::vector<float> constantsOf(const lighting::Variant& variant, const LightNumbers& lights) {
    std::vector<float> out;
    if (variant.storage != lighting::LightStorage::constants)
        return out;
    for (std::size_t i = 0; i < lights.count(); ++i) {
        out.push_back(lights.moves[i] ? 1.0F : 0.0F);
        if (!lights.moves[i])
            for (const glm::vec4& v : {lights.geometry[i], lights.radiance[i], lights.falloff[i]})
                out.insert(out.end(), &v.x, &v.x + 4);
    }
    if (variant.ambient && !lights.ambientMoves)
        out.insert(out.end(), &lights.ambient.x, &lights.ambient.x + 3);
    return out;
}

}  // namespace

Programs::Programs(std::string shaderDirectory, Compile when) : directory_(std::move(shaderDirectory)) {
    GLint fragment = 0, vertex = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_VECTORS, &fragment);  // at least 224
    glGetIntegerv(GL_MAX_VERTEX_UNIFORM_VECTORS, &vertex);  // at least 256
    uniformLights_ = std::min((std::min(fragment, vertex) - 24) / 3, mostUniformLights);
    if (when == Compile::aside)
        aside_ = std::make_unique<CompileAside>();
    if (aside_ && !aside_->usable())
        aside_.reset();
}

Programs::~Programs() {
    aside_.reset();  // before the programs that it may still compile have nobody to go to
    for (const auto& [key, program] : programs_)
        glDeleteProgram(program.id);
}

Program& Programs::get(const lighting::Variant& variant, const LightNumbers& lights) {
    const ProgramKey key{variant, constantsOf(variant, lights)};
    collect(false);
    Program* program = find(key);
    if (aside_ && variant.storage == lighting::LightStorage::constants) {
        ProgramKey general{variant, {}};
        general.first.storage = lighting::LightStorage::uniforms;
        Program* const stand = find(general);
        if (stand == nullptr) {
            buildAside(general, {});  // for when a light begins to move
        } else if (program == nullptr) {
            buildAside(key, lights);
            program = stand;
        }
    }
    if (program == nullptr && underWay_.contains(key)) {
        collect(true);
        program = find(key);
    }
    if (program == nullptr)
        program = &buildNow(key, lights);
    program->lastUsed = ++calls_;
    if (programs_.size() > mostPrograms)
        forgetOldest();
    return *program;
}

Program* Programs::find(const ProgramKey& key) {
    const auto known = programs_.find(key);
    return known == programs_.end() ? nullptr : &known->second;
}

Program& Programs::buildNow(const ProgramKey& key, const LightNumbers& lights) {
    const auto start = std::chrono::steady_clock::now();
    Program& program = programs_.emplace(key, build(key.first, lights)).first->second;
    milliseconds_ +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return program;
}

void Programs::buildAside(const ProgramKey& key, const LightNumbers& lights) {
    if (!failed_.contains(key) && underWay_.insert(key).second)
        aside_->ask(key, [this, variant = key.first, lights] { return build(variant, lights); });
}

void Programs::collect(bool wait) {
    if (!aside_)
        return;
    for (CompileAside::Done& done : aside_->take(wait)) {
        underWay_.erase(done.key);
        if (done.failed)
            failed_.insert(
                done.key);  // its stand-in stays; who has none compiles at once, and says what is wrong
        else if (!programs_.emplace(std::move(done.key), done.program).second)
            glDeleteProgram(done.program.id);  // there is one by now
    }
}

void Programs::finish() { collect(true); }

// Lights that were moved by hand leave a program behind wherever they stood.
void Programs::forgetOldest() {
    const auto oldest =
        std::min_element(programs_.begin(), programs_.end(),
                         [](const auto& a, const auto& b) { return a.second.lastUsed < b.second.lastUsed; });
    glDeleteProgram(oldest->second.id);
    programs_.erase(oldest);
}

GLuint Programs::compile(GLenum stage, const std::string& file, const std::string& preamble) const {
    const ShaderSource source = readShader(directory_, file, preamble);
    const GLuint shader = glCreateShader(stage);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok == GL_TRUE)
        return shader;
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    log.resize(log.find('\0') < log.size() ? log.find('\0') : log.size());
    glDeleteShader(shader);
    throw ShaderError("a shader of " + directory_ + " does not compile:\n" +
                      explain(log, directory_, source) +
                      "Correct the file and try again; --dump-shader writes the whole variant.");
}

Program Programs::build(const lighting::Variant& wanted, const LightNumbers& lights) const {
    lighting::Variant variant = wanted;
    if (variant.storage == lighting::LightStorage::uniforms &&
        variant.directional + variant.point() > uniformLights_)
        variant.storage = lighting::LightStorage::texture;  // this driver has few uniforms
    const ShaderFiles files = shaderFiles(variant);
    const GLuint vertex = compile(GL_VERTEX_SHADER, files.vertex, preamble(variant, lights, false));
    GLuint fragment = 0;
    try {
        fragment = compile(GL_FRAGMENT_SHADER, files.fragment, preamble(variant, lights, true));
    } catch (...) {
        glDeleteShader(vertex);
        throw;
    }
    Program program;
    program.id = glCreateProgram();
    glAttachShader(program.id, vertex);
    glAttachShader(program.id, fragment);
    glLinkProgram(program.id);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint ok = GL_FALSE;
    glGetProgramiv(program.id, GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
        char log[2048] = "";
        glGetProgramInfoLog(program.id, sizeof log, nullptr, log);
        glDeleteProgram(program.id);
        throw ShaderError("the shaders of " + directory_ + " compile but do not fit together (" +
                          files.vertex + ", " + files.fragment + "):\n" + log);
    }
    const auto locate = [&program](GLint& place, const char* name) {
        place = glGetUniformLocation(program.id, name);
    };
    locate(program.modelViewProjectionMatrix, "modelViewProjectionMatrix");
    locate(program.modelMatrix, "modelMatrix");
    locate(program.normalMatrix, "normalMatrix");
    locate(program.baseColor, "baseColor");
    locate(program.emissive, "emissive");
    locate(program.specularColor, "specularColor");
    locate(program.shininess, "shininess");
    locate(program.eyePosition, "eyePosition");
    locate(program.ambientLight, "ambientLight");
    locate(program.lightGeometry, "lightGeometry");
    locate(program.lightRadiance, "lightRadiance");
    locate(program.lightFalloff, "lightFalloff");
    locate(program.lightData, "lightData");
    locate(program.clusterBegins, "clusterBegins");
    locate(program.clusterLights, "clusterLights");
    locate(program.clusterGrid, "clusterGrid");
    locate(program.clusterScale, "clusterScale");
    program.constants = variant.storage == lighting::LightStorage::constants;
    return program;
}

ShaderFiles shaderFiles(const lighting::Variant& variant) {
    if (!variant.lit)
        return {"mesh.vert", "unlit.frag"};
    if (lighting::isData(variant.view))
        return {"mesh.vert", "view.frag"};
    return variant.perVertex ? ShaderFiles{"gouraud.vert", "gouraud.frag"}
                             : ShaderFiles{"mesh.vert", "mesh.frag"};
}

std::string dumpShaders(const std::string& directory, const lighting::FramePlan& plan,
                        const lighting::Draw& draw) {
    const lighting::Variant& variant = draw.variant;
    const LightNumbers lights = pick(numbersOf(plan), plan, plan.lightSets[draw.lights]);
    const auto part = [&](const std::string& file, bool fragment) {
        const ShaderSource source = readShader(directory, file, preamble(variant, lights, fragment));
        return "// ==== " + file + "\n" + source.text + "\n";
    };
    const ShaderFiles files = shaderFiles(variant);
    return part(files.vertex, false) + part(files.fragment, true);
}

}  // namespace render
