// An OpenGL ES 3.0 context without a window or a display.
// SPDX-License-Identifier: MIT
#pragma once

namespace render {

/// Current on the thread that made it, until destroyed. Surfaceless EGL first, then the first EGL device that works;
/// neither touches a window system.
class HeadlessContext {
  public:
    /// Throws NoRenderer with what was tried, each with its reason, and the packages to install.
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

  private:
    void* display_ = nullptr;  // EGLDisplay; EGL's headers stay out of this one
    void* context_ = nullptr;  // EGLContext
};

}  // namespace render
