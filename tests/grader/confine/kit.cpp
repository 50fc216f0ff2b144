// Finds the kit and the lab's own files.
// SPDX-License-Identifier: MIT
#include "grader/confine/builder.hpp"
#include "image/home.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace grader {

namespace fs = std::filesystem;

namespace {

fs::path found(const fs::path& path, const char* what) {
    std::error_code error;
    fs::path real = fs::canonical(path, error);  // links of the build tree lead to the sources
    if (error) {
        throw std::runtime_error(std::string("the grader's ") + what + " is missing: expected " +
                                 path.string() + "; build the target kit, or install the lab again");
    }
    return real;
}

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("cannot read " + path.string() + "; build or install it there");
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Kit findKit() {
    const fs::path home = image::home();
    Kit kit;
    kit.compiled = found(home / "share/lambert-lab/kit", "compiled header");
    kit.includes = found(home / "include/lambert-lab", "folder of headers");
    kit.library = found(home / "lib/lambert-lab/liblambert_lab_kit.so", "library");
    std::ifstream file(found(kit.compiled / "kit.txt", "list of flags"));
    std::getline(file, kit.compiler);
    for (std::string flag; std::getline(file, flag);) {
        kit.flags.push_back(flag);
    }
    return kit;
}

std::string programBytes(const std::string& name) { return contents(image::home() / "bin" / name); }

std::map<std::string, std::string> labShaders() {
    const fs::path folder = found(image::home() / "share/lambert-lab/shaders", "folder of shaders");
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            texts[entry.path().lexically_relative(folder).string()] = contents(entry.path());
        }
    }
    return texts;
}

}  // namespace grader
