// GL calls by hand.
// SPDX-License-Identifier: MIT
#include "bench/probe.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace probe {

namespace {

GLuint compile(GLenum stage, const char* text) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE)
        return shader;
    char log[2000] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw std::runtime_error("a probe's shader does not compile: " + std::string(log));
}

}  // namespace

GLuint link(const char* vertexShader, const char* fragmentShader) {
    const GLuint program = glCreateProgram();
    for (const auto& [stage, text] : {std::pair<GLenum, const char*>{GL_VERTEX_SHADER, vertexShader},
                                      {GL_FRAGMENT_SHADER, fragmentShader}})
        glAttachShader(program, compile(stage, text));
    glLinkProgram(program);
    GLint good = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (good != GL_TRUE)
        throw std::runtime_error("a probe's program does not link");
    glUseProgram(program);
    return program;
}

Mesh upload(const std::vector<float>& vertices, const std::vector<std::uint32_t>& index) {
    Mesh mesh{0, static_cast<GLsizei>(index.size()), {0, 0}};
    glGenVertexArrays(1, &mesh.vertexArray);
    glBindVertexArray(mesh.vertexArray);
    const GLuint* const names = mesh.buffers;
    glGenBuffers(2, mesh.buffers);
    glBindBuffer(GL_ARRAY_BUFFER, names[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * 4), vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(index.size() * 4), index.data(),
                 GL_STATIC_DRAW);
    for (GLuint k = 0; k < 2; ++k) {
        glEnableVertexAttribArray(k);
        glVertexAttribPointer(k, 3, GL_FLOAT, GL_FALSE, 24,
                              reinterpret_cast<const void*>(std::uintptr_t{12} * k));
    }
    glBindVertexArray(0);
    return mesh;
}

void draw(const Mesh& mesh) {
    glBindVertexArray(mesh.vertexArray);
    glDrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

void release(const Mesh& mesh) {
    glDeleteVertexArrays(1, &mesh.vertexArray);
    glDeleteBuffers(2, mesh.buffers);
}

Target makeTarget(int width, int height) {
    Target target{0, width, height, {0, 0}};
    const GLuint* const buffers = target.buffers;
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glGenRenderbuffers(2, target.buffers);
    const GLenum format[] = {GL_RGBA8, GL_DEPTH_COMPONENT24},
                 place[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, format[i], width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place[i], GL_RENDERBUFFER, buffers[i]);
    }
    return target;
}

void release(const Target& target) {
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteRenderbuffers(2, target.buffers);
}

void begin(const Target& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.width, target.height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

std::vector<std::uint8_t> read(const Target& target) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(target.width) *
                                   static_cast<std::size_t>(target.height) * 4);
    glReadPixels(0, 0, target.width, target.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

}  // namespace probe
