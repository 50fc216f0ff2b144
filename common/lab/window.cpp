// Loads the window module on first need.
// SPDX-License-Identifier: MIT
#include "lab/window.hpp"

#include "image/home.hpp"

#include <cstdlib>

namespace lab {

std::shared_ptr<Window> openWindow(int width, int height, const std::string& title, std::string& reason) {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    if (!set("DISPLAY") && !set("WAYLAND_DISPLAY")) {
        reason = "DISPLAY is not set";
        return nullptr;
    }
    void* const entry = image::loadModule("liblambert_window.so", "lambertOpenWindow", reason);
    if (entry == nullptr)
        return nullptr;
    const auto open = reinterpret_cast<OpenWindowFunction>(entry);
    std::shared_ptr<Window> window;
    open(width, height, title.c_str(), window, reason);
    return window;
}

}  // namespace lab
