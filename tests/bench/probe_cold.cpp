// The least that a process can do to draw the lecture's scene and leave a PNG: the yardstick that lessons are timed against.
// SPDX-License-Identifier: MIT
//
//   probe_cold FILE.png            one frame, cold process to file, leaving by _exit
//   probe_cold FILE.png --phases   the same, and says on stdout where the time went: a name and milliseconds on each line
//   probe_cold --frames N          N steady frames of the same mesh and lights: prints the median in ms
//
// Nothing of the lab is linked: EGL surfaceless, one hand-written program with three lights as uniforms, a torus knot of
// 51,200 triangles from its formula, and a PNG through zlib.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace {

constexpr int size = 512;

const char* const vertexShader = R"(#version 300 es
precision highp float;
layout(location = 0) in vec3 p; layout(location = 1) in vec3 q;
uniform mat4 clip; uniform mat3 turn; out vec3 n; out vec3 Q;
void main() { Q = turn * p + vec3(0.0, 1.55, 0.0); n = normalize(turn * q); gl_Position = clip * vec4(Q, 1.0); })";
const char* const fragmentShader = R"(#version 300 es
precision highp float;
in vec3 n; in vec3 Q; out vec4 c;
uniform vec3 D, w, L1, P2, L2, LA;
void main() { vec3 m = normalize(n); vec3 v = P2 - Q;
  c = vec4(max(0.0, dot(m, w)) * D * L1 + max(0.0, dot(m, v)) / sqrt(dot(v, v)) * D * L2 + D * LA, 1.0); })";

void makeContext() {
    const auto get =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display = get(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    eglInitialize(display, nullptr, nullptr);
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                   eglCreateContext(display, config, EGL_NO_CONTEXT, version));
}

// A torus knot: position and normal of each vertex.
std::vector<float> knotVertices(int along, int around) {
    std::vector<float> out;
    const auto curve = [](double u, double(&p)[3]) {
        const double over = 1.5 * u;
        const double r = 0.9 * (2 + std::cos(over)) * 0.5;
        p[0] = r * std::cos(u);
        p[1] = r * std::sin(u);
        p[2] = 0.9 * std::sin(over) * 0.5;
    };
    for (int i = 0; i <= along; ++i) {
        const double u = i * 4 * M_PI / along;
        double a[3], b[3], T[3], N[3], B[3];
        curve(u, a);
        curve(u + 0.01, b);
        for (int k = 0; k < 3; ++k) {
            T[k] = b[k] - a[k];
            N[k] = b[k] + a[k];
        }
        const auto cross = [](const double(&s)[3], const double(&t)[3], double(&r)[3]) {
            for (int k = 0; k < 3; ++k)
                r[k] = s[(k + 1) % 3] * t[(k + 2) % 3] - s[(k + 2) % 3] * t[(k + 1) % 3];
            return std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        };
        const double lengthB = cross(T, N, B);
        const double lengthN = cross(B, T, N);
        for (int j = 0; j <= around; ++j) {
            const double v = j * 2 * M_PI / around;
            double n[3];
            for (int k = 0; k < 3; ++k)
                n[k] = -std::cos(v) * N[k] / lengthN + std::sin(v) * B[k] / lengthB;
            for (int k = 0; k < 3; ++k)
                out.push_back(static_cast<float>(a[k] + 0.34 * n[k]));
            for (int k = 0; k < 3; ++k)
                out.push_back(static_cast<float>(n[k]));
        }
    }
    return out;
}

GLsizei uploadKnot() {
    constexpr int along = 400, around = 64;
    const std::vector<float> vertices = knotVertices(along, around);
    std::vector<std::uint32_t> index;
    for (std::uint32_t i = 1; i <= along; ++i)
        for (std::uint32_t j = 1; j <= around; ++j) {
            const std::uint32_t a = (around + 1) * (i - 1) + j - 1, b = a + around + 1, c = b + 1, d = a + 1;
            index.insert(index.end(), {a, b, d, b, c, d});
        }
    GLuint names[2];
    glGenBuffers(2, names);
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
    return static_cast<GLsizei>(index.size());
}

void setUniforms() {
    const GLuint program = glCreateProgram();
    for (const auto& [stage, text] :
         {std::pair{GL_VERTEX_SHADER, vertexShader}, {GL_FRAGMENT_SHADER, fragmentShader}}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(stage));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    const auto vec3 = [program](const char* name, float x, float y, float z) {
        glUniform3f(glGetUniformLocation(program, name), x, y, z);
    };
    vec3("D", 1, 0.5333F, 0.3333F);
    vec3("w", 0, 0.83205F, -0.5547F);
    vec3("L1", 1, 1, 1);
    vec3("P2", 2, 1.5F, 5);
    vec3("L2", 0.8667F, 0.4F, 0.4F);
    vec3("LA", 0.0627F, 0.0627F, 0.0627F);
    // The knot fills about as much of the picture as in the lesson: seen from (2.2, 2.7, 6.4).
    const float clip[] = {2.91F, -0.22F, -0.31F, -0.31F, 0, 3.0F,  -0.21F, -0.21F,
                          -1.0F, -0.63F, -0.93F, -0.92F, 0, -3.6F, 6.9F,   7.05F};
    const float turn[] = {0.936F, 0.19F, 0.296F, -0.21F, 0.977F, 0.03F, -0.283F, -0.09F, 0.955F};
    glUniformMatrix4fv(glGetUniformLocation(program, "clip"), 1, GL_FALSE, clip);
    glUniformMatrix3fv(glGetUniformLocation(program, "turn"), 1, GL_FALSE, turn);
}

void makeTarget() {
    GLuint framebuffer = 0, buffers[2];
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(2, buffers);
    const GLenum format[] = {GL_RGBA8, GL_DEPTH_COMPONENT24},
                 place[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, format[i], size, size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place[i], GL_RENDERBUFFER, buffers[i]);
    }
    glViewport(0, 0, size, size);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

void drawFrame(GLsizei count) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
}

void chunk(std::FILE* file, const char* type, const std::vector<std::uint8_t>& data) {
    const auto number = [file](std::uint32_t x) {
        const std::uint8_t bytes[] = {std::uint8_t(x >> 24), std::uint8_t(x >> 16), std::uint8_t(x >> 8),
                                      std::uint8_t(x)};
        std::fwrite(bytes, 1, 4, file);
    };
    number(static_cast<std::uint32_t>(data.size()));
    std::fwrite(type, 1, 4, file);
    std::fwrite(data.data(), 1, data.size(), file);
    uLong crc = crc32(0, reinterpret_cast<const Bytef*>(type), 4);
    if (!data.empty())  // zlib takes a null pointer for "start again"
        crc = crc32(crc, data.data(), static_cast<uInt>(data.size()));
    number(static_cast<std::uint32_t>(crc));
}

std::vector<std::uint8_t> readPixels() {
    std::vector<std::uint8_t> rgba(size * size * 4);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

bool writePng(const char* path, const std::vector<std::uint8_t>& rgba) {
    std::vector<std::uint8_t> raw;
    for (int y = size - 1; y >= 0; --y) {
        raw.push_back(0);
        for (int x = 0; x < size; ++x)
            raw.insert(raw.end(), &rgba[static_cast<std::size_t>((y * size + x) * 4)],
                       &rgba[static_cast<std::size_t>((y * size + x) * 4)] + 3);
    }
    uLongf length = compressBound(raw.size());
    std::vector<std::uint8_t> packed(length);
    compress2(packed.data(), &length, raw.data(), raw.size(), 1);
    packed.resize(length);
    std::FILE* file = std::fopen(path, "wb");
    if (file == nullptr)
        return false;
    std::fwrite("\x89PNG\r\n\x1a\n", 1, 8, file);
    chunk(file, "IHDR", {0, 0, size >> 8, size & 255, 0, 0, size >> 8, size & 255, 8, 2, 0, 0, 0});
    chunk(file, "IDAT", packed);
    chunk(file, "IEND", {});
    return std::fclose(file) == 0;
}

// Says how long it is since the last call, or since the program began.
class Watch {
  public:
    explicit Watch(bool speaks) : speaks_(speaks) {}
    void mark(const char* name) {
        const auto now = std::chrono::steady_clock::now();
        if (speaks_)
            std::printf("%s %g\n", name, std::chrono::duration<double, std::milli>(now - last_).count());
        last_ = std::chrono::steady_clock::now();
    }

  private:
    bool speaks_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

int main(int argc, char** argv) {
    const bool phases = argc == 3 && std::strcmp(argv[2], "--phases") == 0;
    const int frames = argc == 3 && std::strcmp(argv[1], "--frames") == 0 ? std::atoi(argv[2]) : 0;
    if (argc < 2 || (argc == 3 && frames < 1 && !phases) || argc > 3) {
        std::fprintf(stderr, "probe_cold: expected FILE.png, FILE.png --phases or --frames N\n");
        return 2;
    }
    Watch watch(phases);
    if (phases)
        std::printf("load %g\n", static_cast<double>(std::clock()) * 1000 / CLOCKS_PER_SEC);
    makeContext();
    watch.mark("context");
    setUniforms();
    watch.mark("compile");
    const GLsizei count = uploadKnot();
    watch.mark("scene");
    makeTarget();
    drawFrame(count);
    watch.mark("draw");
    if (frames == 0) {
        if (phases)
            glFinish();
        watch.mark("finish");
        const std::vector<std::uint8_t> rgba = readPixels();
        watch.mark("read");
        const bool written = writePng(argv[1], rgba);
        watch.mark("write");
        std::fflush(stdout);
        _exit(written ? 0 : 5);
    }
    glFinish();
    std::vector<double> times;
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        drawFrame(count);
        glFinish();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(times.begin(), times.end());
    std::printf("%g\n", times[times.size() / 2]);
    std::fflush(stdout);
    _exit(0);
}
