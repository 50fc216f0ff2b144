// Fuzz target: any bytes as a Wavefront .obj; what follows a line "%mtl" is the file m.mtl beside it.
// SPDX-License-Identifier: MIT
#include "fuzz/property.hpp"
#include "fuzz/scene_property.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace {

// Where m.mtl stands, for as long as the process lives.
class Folder {
  public:
    Folder() { std::filesystem::create_directories(path_); }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string file(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("lambert_fuzz_obj_" + std::to_string(::getpid()));
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Folder folder;
    static const std::string separator = "\n%mtl\n";
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t end = text.find(separator);
    const std::string mtl = folder.file("m.mtl");
    std::error_code ignored;
    std::filesystem::remove(mtl, ignored);
    if (end != std::string::npos)
        std::ofstream(mtl, std::ios::binary) << text.substr(end + separator.size());
    const std::string file = folder.file("mesh.obj");
    fuzz::checkScene([&] { return THREE::parseObj(text.substr(0, end), file); }, "/");
    return 0;
}
