// Finds the lab's own files, and loads its modules.
// SPDX-License-Identifier: MIT
#include "image/home.hpp"

#include <dlfcn.h>
#include <system_error>

namespace image {

namespace {

// In a function, so that it is there whichever static object is made first.
std::string& said() {
    static std::string folder;
    return folder;
}

}  // namespace

std::filesystem::path home() {
    if (!said().empty()) {
        return said();
    }
    // Of a lesson's module, which another program loaded: lib/lambert-lab/lesson_03....so knows where it is.
    Dl_info here{};
    if (::dladdr(reinterpret_cast<void*>(&home), &here) != 0 && here.dli_fname != nullptr) {
        const std::filesystem::path file = here.dli_fname;
        if (file.extension() == ".so") {
            return file.parent_path().parent_path().parent_path();
        }
    }
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
}

void setHome(std::string folder) { said() = std::move(folder); }

void* loadModule(const std::string& file, const char* entry, std::string& reason) {
    const std::string path = (home() / "lib/lambert-lab" / file).string();
    void* const module = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const address = module != nullptr ? ::dlsym(module, entry) : nullptr;
    if (address == nullptr) {
        reason = ::dlerror();
    }
    return address;
}

}  // namespace image
