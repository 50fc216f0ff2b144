// What the tests of frames and files share: a directory for each test, and frames that are hard to get right.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

namespace image_tests {

namespace fs = std::filesystem;
using image::Bytes;
using image::Floats;
using image::Frame;
using image::Metadata;

inline const float infinite = std::numeric_limits<float>::infinity();
inline const float notANumber = std::numeric_limits<float>::quiet_NaN();

// Every format that the messages promise, with our own two first.
inline const std::vector<std::string> extensions = {".png", ".exr", ".tif",  ".jpg", ".hdr", ".bmp",
                                                    ".tga", ".ppm", ".webp", ".gif", ".dpx"};

inline std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void putContents(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

// Each test works in an empty directory of its own.
class Image : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "test-image-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        directory = pattern;
        fs::current_path(directory);
    }
    void TearDown() override {
        fs::current_path(fs::temp_directory_path());
        fs::remove_all(directory);
    }

    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(directory)) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    fs::path directory;
};

// All codes, and no symmetry by which a flip or a swap of channels could hide.
inline Frame codes() {
    Frame frame = {17, 31, Bytes(17 * 31 * 3)};
    Bytes& bytes = std::get<Bytes>(frame.pixels);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
    }
    return frame;
}

// Random bits, and first the numbers that a careless writer would change.
inline Frame wildFloats() {
    using Limits = std::numeric_limits<float>;
    Floats floats = {-1.5F,
                     2.25F,
                     Limits::denorm_min(),
                     -Limits::denorm_min(),
                     Limits::min() / 3,
                     Limits::max(),
                     infinite,
                     -infinite,
                     -0.0F,
                     1.0F / 3};
    std::mt19937 random(2);
    while (floats.size() < 13 * 40 * 3) {  // 40 rows: more than one block of an EXR
        const std::uint32_t bits = static_cast<std::uint32_t>(random());
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        floats.push_back(std::isnan(value) ? 0.1F : value);
    }
    return {13, 40, floats};
}

}  // namespace image_tests
