// Scene files as text: reading them whole, and saying where in them something is wrong.
// SPDX-License-Identifier: MIT
#include "three/scene_file.hpp"

#include "three/validate.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace THREE {

std::string readSceneFile(const std::string& file) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status))
        throw SceneError(
            file + ": expected a scene file, found " +
            (error && error != std::errc::no_such_file_or_directory ? error.message() : "no such file") +
            "; check the name and the folder you are in");
    if (fs::is_directory(status))
        throw SceneError(file + ": expected a scene file, found a folder; name a file inside it");
    if (!fs::is_regular_file(status))  // a device or pipe may never end
        throw SceneError(file + ": expected an ordinary file, found a device, pipe or socket; save it first");
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error && size > largestSceneFile)
        throw SceneError(file + ": expected a scene of at most 1 GiB, found " + std::to_string(size) +
                         " bytes; split or simplify it");
    if (!error && size == 0)
        throw SceneError(file + ": expected a scene, found an empty file; save or export it again");
    std::ifstream in(file, std::ios::binary);
    if (error || !in)
        throw SceneError(file + ": cannot be read, found " +
                         (error ? error.message() : std::strerror(errno)) + "; check its permissions");
    std::string text(static_cast<std::size_t>(size), '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (static_cast<std::size_t>(in.gcount()) != text.size())
        throw SceneError(file + ": expected " + std::to_string(size) + " bytes, found only " +
                         std::to_string(in.gcount()) + " readable; is it still being written?");
    return text;
}

std::string placeIn(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lineEnd = before.rfind('\n');
    const std::size_t column =
        lineEnd == std::string_view::npos ? before.size() : before.size() - lineEnd - 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

std::string printable(std::string_view text, std::size_t most) {
    static const char* const digits = "0123456789abcdef";
    std::string out;
    for (const char c : text) {
        if (out.size() >= most)
            return out + "...";
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f)
            out += c;
        else
            out += std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
    }
    return out;
}

}  // namespace THREE
