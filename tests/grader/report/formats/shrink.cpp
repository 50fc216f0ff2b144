// By libpng's simplified interface: OpenImageIO would take longer to load than a whole report to write.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/shrink.hpp"

#include <png.h>
#include <vector>

namespace grader {

namespace {

constexpr png_uint_32 largest = 8192;  // pixels each way

struct Pixels {
    png_uint_32 width = 0, height = 0;
    std::vector<png_byte> rgb;
};

Pixels read(const std::string& png) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Pixels pixels;
    if (!png_image_begin_read_from_memory(&image, png.data(), png.size()))
        return pixels;
    image.format = PNG_FORMAT_RGB;
    if (image.width <= largest && image.height <= largest) {
        pixels.rgb.resize(PNG_IMAGE_SIZE(image));
        if (png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr)) {
            pixels.width = image.width;
            pixels.height = image.height;
        }
    }
    png_image_free(&image);
    return pixels;
}

Pixels half(const Pixels& whole) {
    Pixels small{whole.width / 2, whole.height / 2, {}};
    small.rgb.reserve(std::size_t{small.width} * small.height * 3);
    const std::size_t row = std::size_t{whole.width} * 3;
    for (std::size_t y = 0; y < small.height; ++y)
        for (std::size_t x = 0; x < small.width; ++x)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const png_byte* corner = &whole.rgb[2 * y * row + 2 * x * 3 + channel];
                small.rgb.push_back(
                    static_cast<png_byte>((corner[0] + corner[3] + corner[row] + corner[row + 3] + 2) / 4));
            }
    return small;
}

}  // namespace

std::string halved(const std::string& png) {
    const Pixels whole = read(png);
    if (whole.width < 2 || whole.height < 2)
        return "";
    const Pixels small = half(whole);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = small.width;
    image.height = small.height;
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string result(size, '\0');
    if (!png_image_write_to_memory(&image, result.data(), &size, 0, small.rgb.data(), 0, nullptr))
        return "";
    result.resize(size);
    return result;
}

}  // namespace grader
