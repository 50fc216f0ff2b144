// Difference statistics in double, and the picture of a difference.
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"

#include "image/write.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace image {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Pixel values to compare. Two frames of codes are compared as whole numbers and divided afterwards, so that
// one code is 1.0 / 255 exactly everywhere and a threshold of one code means what it says.
struct Values {
    Floats expected;
    Floats found;
    double white;  // the value that stands for 1

    Values(const Frame& a, const Frame& b) : white(1) {
        const auto* codesA = std::get_if<Bytes>(&a.pixels);
        const auto* codesB = std::get_if<Bytes>(&b.pixels);
        if (codesA != nullptr && codesB != nullptr) {
            expected.assign(codesA->begin(), codesA->end());
            found.assign(codesB->begin(), codesB->end());
            white = 255;
        } else {
            expected = toFloats(a);
            found = toFloats(b);
        }
    }
};

double distance(double expected, double found) {
    if (expected == found) {  // equal infinities too
        return 0;
    }
    const double difference = std::abs(expected - found);
    return std::isnan(difference) ? infinity : difference;
}

std::string sizeOf(const Frame& frame) {
    return std::to_string(frame.width) + "x" + std::to_string(frame.height);
}

void checkPair(const Frame& expected, const Frame& found) {
    check(expected);
    check(found);
    if (expected.width != found.width || expected.height != found.height) {
        throw Error("cannot compare frames of different sizes: expected " + sizeOf(expected) + ", found " +
                    sizeOf(found) + "; render both with the same --size");
    }
}

std::size_t pixelsOf(const Frame& frame) {
    return static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
}

void checkMask(std::span<const std::uint8_t> mask, const Frame& frame) {
    const std::size_t count = pixelsOf(frame);
    if (!mask.empty() && mask.size() != count) {
        throw Error("the mask has " + std::to_string(mask.size()) + " entries; expected none or " +
                    std::to_string(count) + ", one a pixel; make it for frames of " + sizeOf(frame));
    }
    const auto chosen = [](std::uint8_t entry) { return entry != 0; };
    if (!mask.empty() && std::none_of(mask.begin(), mask.end(), chosen)) {
        throw Error("the mask leaves no pixel to compare; expected at least one; check what it masks");
    }
}

}  // namespace

Difference compare(const Frame& expected, const Frame& found, double threshold,
                   std::span<const std::uint8_t> mask) {
    checkPair(expected, found);
    const std::size_t count = pixelsOf(expected);
    checkMask(mask, expected);
    const Values values(expected, found);
    Difference result;
    double sum = 0;
    double squares = 0;
    std::size_t worstPixel = count;  // none yet
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        if (!mask.empty() && mask[pixel] == 0) {
            continue;
        }
        double largest = 0;
        bool finite = true;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double a = values.expected[pixel * 3 + channel];
            const double b = values.found[pixel * 3 + channel];
            const double difference = distance(a, b) / values.white;
            finite = finite && std::isfinite(a) && std::isfinite(b);
            sum += difference;
            squares += difference * difference;
            result.maximum[channel] = std::max(result.maximum[channel], difference);
            largest = std::max(largest, difference);
        }
        ++result.pixels;
        result.above += largest > threshold ? 1 : 0;
        result.nonfinite += finite ? 0 : 1;
        if (worstPixel == count || largest > result.worst) {
            worstPixel = pixel;
            result.worst = largest;
        }
    }
    result.mean = sum / (3.0 * static_cast<double>(result.pixels));
    result.rms = std::sqrt(squares / (3.0 * static_cast<double>(result.pixels)));
    result.psnr = -20 * std::log10(result.rms);
    result.x = static_cast<int>(worstPixel % static_cast<std::size_t>(expected.width));
    result.y = static_cast<int>(worstPixel / static_cast<std::size_t>(expected.width));
    for (std::size_t channel = 0; channel < 3; ++channel) {
        result.expected[channel] = values.expected[worstPixel * 3 + channel] / values.white;
        result.found[channel] = values.found[worstPixel * 3 + channel] / values.white;
    }
    return result;
}

void writeDifferencePicture(const std::string& path, const Frame& expected, const Frame& found, float gain) {
    checkPair(expected, found);
    const Floats a = toFloats(expected);
    const Floats b = toFloats(found);
    const auto width = static_cast<std::size_t>(expected.width);
    Floats picture(a.size() * 3);
    const auto put = [&picture](std::size_t pixel, const std::array<float, 3>& color) {
        const bool finite = std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
        const std::array<float, 3> magenta = {1, 0, 1};
        std::copy_n((finite ? color : magenta).begin(), 3,
                    picture.begin() + static_cast<std::ptrdiff_t>(pixel * 3));
    };
    for (std::size_t i = 0; i < a.size(); i += 3) {
        const std::size_t pixel = i / 3;
        const std::size_t left = (pixel / width) * width * 3 + pixel % width;
        std::array<float, 3> difference = {};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            difference[channel] = gain * std::abs(a[i + channel] - b[i + channel]);
        }
        put(left, {a[i], a[i + 1], a[i + 2]});
        put(left + width, {b[i], b[i + 1], b[i + 2]});
        put(left + 2 * width, difference);
    }
    write(path, {expected.width * 3, expected.height, std::move(picture)}, {});
}

}  // namespace image
