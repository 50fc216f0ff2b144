// Chooses the format, checks the target, and loads the OpenImageIO module if the format is none of ours.
// SPDX-License-Identifier: MIT
#include "image/write.hpp"

#include "image/encoders.hpp"
#include "image/home.hpp"
#include "image/temporary_file.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <unistd.h>

namespace image {

namespace {

namespace fs = std::filesystem;

// Where the bytes go: the path itself, or what it links to. Throws Error if nothing may be put there.
fs::path findTarget(const std::string& path) {
    if (path.empty()) {
        throw Error("the path is empty; expected a file name such as frame.png; give one");
    }
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status) || path.back() == '/') {
        throw Error("it is a directory; expected a file name; add one, such as " +
                    (fs::path(path) / "frame.png").string());
    }
    if (!fs::exists(status)) {
        return path;
    }
    if (!fs::is_regular_file(status)) {  // renaming over /dev/null would destroy it
        throw Error(
            "it is a device, a pipe or a socket; expected a regular file; write a file and copy it there");
    }
    if (::access(path.c_str(), W_OK) != 0) {  // renaming would replace a write-protected file unasked
        const int reason = errno;
        throw Error(systemReason(reason) + "; expected a file that you may replace; choose another name");
    }
    return fs::canonical(path);
}

std::string lowerExtension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    if (extension.size() < 2) {
        throw Error("the name has no extension, which chooses the format; expected .png, .exr, .pfm, .tif, "
                    ".jpg, .hdr or "
                    "another that OpenImageIO writes; add one");
    }
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

void check(const Metadata& metadata) {
    const std::string allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
    for (const auto& [key, value] : metadata) {
        if (key.empty() || key.size() > 79 || key.find_first_not_of(allowed) != std::string::npos) {
            throw Error("the metadata key '" + key +
                        "' fits no format; expected 1 to 79 of A-Z a-z 0-9 _ - .; rename it");
        }
        if (value.find('\0') != std::string::npos) {
            throw Error("the metadata value of '" + key + "' holds a NUL; expected text; remove the NUL");
        }
    }
}

OiioEncode* loadEncoder() {
    std::string reason;
    void* const entry = loadModule(oiioModule, oiioEntry, reason);
    if (entry == nullptr) {
        throw Error(std::string("this format needs the module ") + oiioModule + ", which does not load: " +
                    reason + "; build or install it there, or write .png, .exr or .pfm");
    }
    return reinterpret_cast<OiioEncode*>(entry);
}

void encodeThroughModule(std::FILE* file, const std::string& extension, const Frame& frame,
                         const Metadata& metadata) {
    std::vector<unsigned char> encoded;
    std::string reason;
    if (!loadEncoder()(extension.c_str(), &frame, &metadata, &encoded, &reason)) {
        throw Error(reason);
    }
    if (std::fwrite(encoded.data(), 1, encoded.size(), file) != encoded.size()) {
        throwWriteError(errno);
    }
}

void writeOrThrow(const std::string& path, const Frame& frame, const Metadata& metadata) {
    const fs::path target = findTarget(path);
    const std::string extension = lowerExtension(path);
    check(frame);
    check(metadata);
    TemporaryFile file(target);
    if (extension == ".png") {
        encodePng(file.stream(), frame, metadata);
    } else if (extension == ".exr") {
        encodeExr(file.stream(), frame, metadata);
    } else if (extension == ".pfm") {
        encodePfm(file.stream(), frame);
    } else {
        encodeThroughModule(file.stream(), extension, frame, metadata);
    }
    file.commit();
}

}  // namespace

void write(const std::string& path, const Frame& frame, const Metadata& metadata) {
    try {
        writeOrThrow(path, frame, metadata);
    } catch (const Error& error) {
        throw Error("cannot write '" + path + "': " + error.what());
    } catch (const std::exception& error) {  // OpenEXR's own, or no memory
        throw Error("cannot write '" + path + "': " + error.what() +
                    "; expected a picture that fits the format and memory; try .png or a smaller --size");
    }
}

void writeText(const std::string& path, const std::string& text) {
    try {
        TemporaryFile file(findTarget(path));
        if (std::fwrite(text.data(), 1, text.size(), file.stream()) != text.size()) {
            throwWriteError(errno);
        }
        file.commit();
    } catch (const Error& error) {
        throw Error("cannot write '" + path + "': " + error.what());
    }
}

}  // namespace image
