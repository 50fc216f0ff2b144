// Where a frame is drawn when it is not a window: 8-bit or float pixels that can be read back.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

#include <GLES3/gl3.h>
#include <array>
#include <cstdint>

namespace render {

/// What the pixels of a target are. floats: RGBA32F, linear and unclamped; codes: RGBA8, as a screen's.
enum class PixelFormat { codes, floats };

/// A framebuffer of its own, with depth and, where asked for, a second target for the count of nonfinite pixels.
class RenderTarget {
  public:
    /// Throws NoRenderer if the driver cannot: the size is over its limit, or it has no float targets.
    RenderTarget(int width, int height, PixelFormat format, bool countNonfinite);
    ~RenderTarget();
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;

    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }
    int width() const { return width_; }
    int height() const { return height_; }
    PixelFormat format() const { return format_; }
    bool countsNonfinite() const { return renderbuffers_[2] != 0; }
    /// The picture, top row first.
    image::Frame read() const;
    /// One of its pixels as an 8-bit code; 0,0 is the top left, and it must be inside. Of a target of codes only.
    std::array<std::uint8_t, 3> pixel(int x, int y) const;
    /// Puts a picture of the same size, top row first, into it; as 8-bit codes.
    void write(const image::Frame& frame);
    /// Copies it into the window whose context is current, which is bound then.
    void show() const;
    /// How many pixels of the second target are marked.
    long long countNonfinite() const;

  private:
    int width_;
    int height_;
    PixelFormat format_;
    GLuint framebuffer_ = 0;
    GLuint renderbuffers_[3] = {0, 0, 0};  // colour, depth, nonfinite marks
};

}  // namespace render
