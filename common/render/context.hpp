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

/// A second context that shares shaders and programs with the one that is current where it is made; for another thread.
class SharedContext {
  public:
    /// usable() is false where the driver has none.
    SharedContext();
    ~SharedContext();
    SharedContext(const SharedContext&) = delete;
    SharedContext& operator=(const SharedContext&) = delete;

    bool usable() const { return context_ != nullptr; }
    /// Makes it current on the calling thread. False if the driver refuses.
    bool makeCurrent();
    /// Gives it back; call it on the thread where it is current.
    void release();

  private:
    void* display_ = nullptr;  // EGLDisplay
    void* context_ = nullptr;  // EGLContext
    void* surface_ = nullptr;  // EGLSurface of a few pixels in the window's own format, or none
};

}  // namespace render
