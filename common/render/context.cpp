// EGL without a surface: Mesa's surfaceless platform, else EGL devices.
// SPDX-License-Identifier: MIT
#include "render/context.hpp"

#include "render/error.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <cstdio>
#include <string>
#include <string_view>

namespace render {

namespace {

constexpr EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};

std::string eglError() {
    char text[16];
    std::snprintf(text, sizeof text, "0x%04X", static_cast<unsigned>(eglGetError()));
    return std::string("EGL error ") + text;
}

bool has(const char* extensions, std::string_view name) {
    const std::string padded = " " + std::string(extensions != nullptr ? extensions : "") + " ";
    return padded.find(" " + std::string(name) + " ") != std::string::npos;
}

// Makes an ES 3.0 context current on this display. Returns the reason if it cannot.
std::string makeCurrent(EGLDisplay display, EGLContext& context) {
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return "eglInitialize: " + eglError();
    if (!has(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return "EGL_KHR_surfaceless_context is missing";
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &count) == EGL_FALSE || count == 0)
        return "no configuration for OpenGL ES 3";
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT)
        return "no OpenGL ES 3.0 context: " + eglError();
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
        const std::string reason = "eglMakeCurrent: " + eglError();
        eglDestroyContext(display, context);
        return reason;
    }
    return {};
}

}  // namespace

HeadlessContext::HeadlessContext() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto getPlatformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    std::string tried;
    const auto attempt = [&](const char* what, EGLenum platform, void* native) {
        const EGLDisplay display = getPlatformDisplay(platform, native, nullptr);
        const std::string reason =
            display == EGL_NO_DISPLAY ? "no display: " + eglError() : makeCurrent(display, context_);
        if (reason.empty()) {
            display_ = display;
            return true;
        }
        if (display != EGL_NO_DISPLAY)
            eglTerminate(display);
        tried += std::string("\n  ") + what + ": " + reason;
        return false;
    };

    if (getPlatformDisplay != nullptr && has(client, "EGL_MESA_platform_surfaceless")) {
        if (attempt("EGL surfaceless platform", EGL_PLATFORM_SURFACELESS_MESA, nullptr))
            return;
    } else {
        tried += "\n  EGL surfaceless platform: not offered by this EGL";
    }
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (getPlatformDisplay != nullptr && queryDevices != nullptr &&
        queryDevices(16, devices, &count) == EGL_TRUE) {
        for (EGLint i = 0; i < count; ++i)
            if (attempt("EGL device", EGL_PLATFORM_DEVICE_EXT, devices[i]))
                return;
    }
    if (count == 0)
        tried += "\n  EGL device platform: no device";
    throw NoRenderer(
        "no way to draw without a window; expected an EGL driver with OpenGL ES 3.0. Tried:" + tried +
        "\n  Install Mesa's software driver (apt-get install libegl-mesa0 libgl1-mesa-dri) and try again, or "
        "draw "
        "without any driver: --renderer reference");
}

HeadlessContext::~HeadlessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

SharedContext::SharedContext() : display_(eglGetCurrentDisplay()) {
    const EGLContext current = eglGetCurrentContext();
    EGLint id = 0, count = 0;
    if (display_ == EGL_NO_DISPLAY || current == EGL_NO_CONTEXT ||
        eglQueryContext(display_, current, EGL_CONFIG_ID, &id) == EGL_FALSE)
        return;
    const EGLint same[] = {EGL_CONFIG_ID, id, EGL_NONE};
    EGLConfig config = nullptr;
    if (eglChooseConfig(display_, same, &config, 1, &count) == EGL_FALSE || count == 0)
        return;
    context_ = eglCreateContext(display_, config, current, version);
    EGLint surfaces = 0;
    eglGetConfigAttrib(display_, config, EGL_SURFACE_TYPE, &surfaces);
    const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    if (context_ != EGL_NO_CONTEXT && (surfaces & EGL_PBUFFER_BIT) != 0)
        surface_ = eglCreatePbufferSurface(display_, config, size);
    eglGetError();  // a refusal above is an answer, not an error of this thread's next call
}

SharedContext::~SharedContext() {
    if (surface_ != EGL_NO_SURFACE)
        eglDestroySurface(display_, surface_);
    if (context_ != EGL_NO_CONTEXT)
        eglDestroyContext(display_, context_);
}

bool SharedContext::makeCurrent() {
    eglBindAPI(EGL_OPENGL_ES_API);
    return usable() && eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
}

void SharedContext::release() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglReleaseThread();
}

}  // namespace render
