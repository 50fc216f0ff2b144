// Finds the kit and the lab's own files.
// SPDX-License-Identifier: MIT
#include "grader/confine/builder.hpp"
#include "image/home.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <unistd.h>

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

// Whether every user may read it.
bool isOpen(const fs::path& path) {
    const auto may = [](const fs::path& one, fs::perms what) {
        return (fs::status(one).permissions() & what) == what;
    };
    if (!may(path, fs::perms::others_read)) {
        return false;
    }
    for (fs::path folder = path.parent_path(); folder != folder.root_path(); folder = folder.parent_path()) {
        if (!may(folder, fs::perms::others_exec)) {
            return false;
        }
    }
    return true;
}

// A folder that goes with the last Kit that uses it.
class Copy {
  public:
    Copy() {
        std::string name = (fs::temp_directory_path() / "lambert-grade-kit-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) {
            throw std::runtime_error(name + ": " + std::strerror(errno) +
                                     "; the kit must be copied there for all to read");
        }
        folder_ = name;
    }
    ~Copy() {
        std::error_code ignored;
        if (::getpid() == owner_) {  // not in a forked worker
            fs::remove_all(folder_, ignored);
        }
    }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;

    fs::path add(const fs::path& from, const char* name) const {
        fs::copy(from, folder_ / name, fs::copy_options::recursive);
        return folder_ / name;
    }
    void open() const {
        const fs::perms read = fs::perms::group_read | fs::perms::others_read,
                        enter = fs::perms::group_exec | fs::perms::others_exec;
        fs::permissions(folder_, read | enter, fs::perm_options::add);
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
            fs::permissions(entry, entry.is_directory() ? read | enter : read, fs::perm_options::add);
        }
    }

  private:
    fs::path folder_;
    pid_t owner_ = ::getpid();
};

void openToAll(Kit& kit) {
    if (::geteuid() != 0 || (isOpen(kit.library) && isOpen(kit.includes / "lab/lab.hpp") &&
                             isOpen(kit.compiled / "lab/lab.hpp.gch"))) {
        return;
    }
    const auto copy = std::make_shared<Copy>();
    kit.library = copy->add(kit.library, "liblambert_lab_kit.so");
    kit.includes = copy->add(kit.includes, "include");
    kit.compiled = copy->add(kit.compiled, "kit");
    copy->open();
    kit.copy = copy;
}

}  // namespace

std::string fileBytes(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("cannot read " + path.string() + "; build or install it there");
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

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
    openToAll(kit);
    return kit;
}

std::string programBytes(const std::string& name) { return fileBytes(image::home() / "bin" / name); }

std::map<std::string, std::string> labShaders() {
    const fs::path folder = found(image::home() / "share/lambert-lab/shaders", "folder of shaders");
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            texts[entry.path().lexically_relative(folder).string()] = fileBytes(entry.path());
        }
    }
    return texts;
}

}  // namespace grader
