// Xlib's handler, where GLFW has loaded Xlib.
// SPDX-License-Identifier: MIT
#include "lab/window/window_lost.hpp"

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>

namespace lab {

namespace {

int lost(void*) {
    const char* const name = std::getenv("DISPLAY");
    std::fprintf(stderr,
                 "lambert_window: the display %s is gone, and the window with it; start the program again "
                 "where there is "
                 "a display, or draw a picture without one: --frame FILE\n",
                 name != nullptr ? name : "");
    std::_Exit(3);
}

}  // namespace

void handleLostDisplay() {
    using Handler = int (*)(void*);
    using SetHandler = Handler (*)(Handler);
    // By its name: under Wayland there is no Xlib, and this module should not need it.
    if (void* const set = dlsym(RTLD_DEFAULT, "XSetIOErrorHandler"))
        reinterpret_cast<SetHandler>(set)(lost);
}

}  // namespace lab
