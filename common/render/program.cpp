// Compiles and links the shaders of a variant.
// SPDX-License-Identifier: MIT
#include "render/program.hpp"

#include "render/error.hpp"
#include "render/shader_source.hpp"

#include <algorithm>
#include <chrono>

namespace render {

namespace {

constexpr int mostUniformLights = 256;

}  // namespace

Programs::Programs(std::string shaderDirectory) : directory_(std::move(shaderDirectory)) {
    GLint fragment = 0, vertex = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_VECTORS, &fragment);  // at least 224
    glGetIntegerv(GL_MAX_VERTEX_UNIFORM_VECTORS, &vertex);  // at least 256
    uniformLights_ = std::min((std::min(fragment, vertex) - 24) / 3, mostUniformLights);
}

Programs::~Programs() {
    for (const auto& [variant, program] : programs_)
        glDeleteProgram(program.id);
}

Program& Programs::get(const lighting::Variant& variant) {
    const auto known = programs_.find(variant);
    if (known != programs_.end())
        return known->second;
    const auto start = std::chrono::steady_clock::now();
    Program& program = programs_.emplace(variant, build(variant)).first->second;
    milliseconds_ +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return program;
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

Program Programs::build(const lighting::Variant& variant) {
    const bool texture = variant.directional + variant.point() > uniformLights_;
    const ShaderFiles files = shaderFiles(variant);
    const GLuint vertex = compile(GL_VERTEX_SHADER, files.vertex, preamble(variant, false, texture));
    GLuint fragment = 0;
    try {
        fragment = compile(GL_FRAGMENT_SHADER, files.fragment, preamble(variant, true, texture));
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
    return program;
}

ShaderFiles shaderFiles(const lighting::Variant& variant) {
    if (!variant.lit)
        return {"mesh.vert", "unlit.frag"};
    return variant.perVertex ? ShaderFiles{"gouraud.vert", "gouraud.frag"}
                             : ShaderFiles{"mesh.vert", "mesh.frag"};
}

std::string dumpShaders(const std::string& directory, const lighting::Variant& variant) {
    const bool texture = variant.directional + variant.point() > mostUniformLights;
    const auto part = [&](const std::string& file, bool fragment) {
        const ShaderSource source = readShader(directory, file, preamble(variant, fragment, texture));
        return "// ==== " + file + "\n" + source.text + "\n";
    };
    const ShaderFiles files = shaderFiles(variant);
    return part(files.vertex, false) + part(files.fragment, true);
}

}  // namespace render
