// Loads the window module on first need.
// SPDX-License-Identifier: MIT
#include "lab/window.hpp"

#include <cstdlib>
#include <dlfcn.h>

namespace lab {

std::unique_ptr<Window> openWindow(int width, int height, const std::string& title, std::string& reason) {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    if (!set("DISPLAY") && !set("WAYLAND_DISPLAY")) {
        reason = "DISPLAY is not set";
        return nullptr;
    }
    void* module =
        dlopen("liblambert_window.so", RTLD_NOW | RTLD_LOCAL);  // found through the program's RUNPATH
    if (module == nullptr) {
        reason = dlerror();
        return nullptr;
    }
    const auto open = reinterpret_cast<OpenWindowFunction>(dlsym(module, "lambertOpenWindow"));
    if (open == nullptr) {
        reason = dlerror();
        return nullptr;
    }
    return std::unique_ptr<Window>(open(width, height, title.c_str(), reason));
}

}  // namespace lab
