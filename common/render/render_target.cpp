// Framebuffers, and reading them back a band of rows at a time.
// SPDX-License-Identifier: MIT
#include "render/render_target.hpp"

#include "render/error.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace render {

namespace {

bool hasExtension(std::string_view name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (name == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))))
            return true;
    return false;
}

// Reads RGBA rows bottom up, in bands, and hands each row to `row` with its number from the top.
template <class T, class Row>
void readRows(int width, int height, GLenum type, const Row& row) {
    const int band = std::clamp(4 * 1024 * 1024 / width, 1, height);
    std::vector<T> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(band) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int bottom = 0; bottom < height; bottom += band) {
        const int rows = std::min(band, height - bottom);
        glReadPixels(0, bottom, width, rows, GL_RGBA, type, pixels.data());
        for (int i = 0; i < rows; ++i)
            row(height - 1 - bottom - i,
                &pixels[static_cast<std::size_t>(i) * static_cast<std::size_t>(width) * 4]);
    }
}

template <class T>
std::vector<T> readRgb(int width, int height, GLenum type) {
    const std::size_t rowLength = static_cast<std::size_t>(width) * 3;
    std::vector<T> rgb(rowLength * static_cast<std::size_t>(height));
    readRows<T>(width, height, type, [&rgb, rowLength, width](int fromTop, const T* rgba) {
        T* out = &rgb[static_cast<std::size_t>(fromTop) * rowLength];
        for (int x = 0; x < width; ++x, rgba += 4)
            out = std::copy_n(rgba, 3, out);
    });
    return rgb;
}

}  // namespace

RenderTarget::RenderTarget(int width, int height, PixelFormat format, bool countNonfinite)
    : width_(width), height_(height), format_(format) {
    if (format == PixelFormat::floats && !hasExtension("GL_EXT_color_buffer_float"))
        throw NoRenderer("this driver cannot draw into 32-bit floats; expected GL_EXT_color_buffer_float. "
                         "Write a .png, or use Mesa's software driver (LIBGL_ALWAYS_SOFTWARE=1).");
    GLint limit = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    if (width > limit || height > limit)
        throw NoRenderer("this driver draws at most " + std::to_string(limit) +
                         " pixels each way, asked for " + std::to_string(width) + "x" +
                         std::to_string(height) + "; choose a smaller --size.");
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(countNonfinite ? 3 : 2, renderbuffers_);
    bind();
    const auto attach = [&](GLuint renderbuffer, GLenum pixels, GLenum place) {
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        glRenderbufferStorage(GL_RENDERBUFFER, pixels, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, renderbuffer);
    };
    attach(renderbuffers_[0], format == PixelFormat::floats ? GL_RGBA32F : GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(renderbuffers_[1], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
    if (countNonfinite)
        attach(renderbuffers_[2], GL_RGBA8, GL_COLOR_ATTACHMENT1);
    const GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(countNonfinite ? 2 : 1, places);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        glGetError() == GL_OUT_OF_MEMORY) {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(3, renderbuffers_);
        throw NoRenderer("the driver has no memory for a frame of " + std::to_string(width) + "x" +
                         std::to_string(height) + "; choose a smaller --size.");
    }
}

RenderTarget::~RenderTarget() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(3, renderbuffers_);
}

image::Frame RenderTarget::read() const {
    bind();
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    if (format_ == PixelFormat::floats)
        return {width_, height_, readRgb<float>(width_, height_, GL_FLOAT)};
    return {width_, height_, readRgb<std::uint8_t>(width_, height_, GL_UNSIGNED_BYTE)};
}

std::array<std::uint8_t, 3> RenderTarget::pixel(int x, int y) const {
    GLint before = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);  // only that: what is drawn into stays
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    std::array<std::uint8_t, 4> rgba{};
    glReadPixels(x, height_ - 1 - y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
    return {rgba[0], rgba[1], rgba[2]};
}

void RenderTarget::write(const image::Frame& frame) {
    const image::Bytes codes = image::toBytes(frame);
    std::vector<std::uint8_t> upwards;  // the target's first row is the lowest
    upwards.reserve(codes.size());
    const auto row = static_cast<std::ptrdiff_t>(frame.width) * 3;
    for (auto end = codes.end(); end != codes.begin(); end -= row)
        upwards.insert(upwards.end(), end - row, end);
    GLuint texture = 0, reading = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, frame.width, frame.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 upwards.data());
    glGenFramebuffers(1, &reading);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reading);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    bind();
    glDeleteFramebuffers(1, &reading);
    glDeleteTextures(1, &texture);
}

void RenderTarget::show() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

long long RenderTarget::countNonfinite() const {
    bind();
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    long long count = 0;
    readRows<std::uint8_t>(width_, height_, GL_UNSIGNED_BYTE, [this, &count](int, const std::uint8_t* rgba) {
        for (int x = 0; x < width_; ++x)
            count += rgba[x * 4] != 0;
    });
    return count;
}

}  // namespace render
