// Unit tests of the difference between frames, on pictures whose differences are known by hand.
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace {

using image::Bytes;
using image::compare;
using image::Difference;
using image::Floats;
using image::Frame;

const float nan = std::numeric_limits<float>::quiet_NaN();
const float inf = std::numeric_limits<float>::infinity();
const double infinity = std::numeric_limits<double>::infinity();

Frame grey(int width, int height) {
    return {width, height, Floats(static_cast<std::size_t>(width * height * 3), 0.5F)};
}

// The frame with one number changed; all are binary fractions, so that differences are exact.
Frame with(Frame frame, std::size_t index, float value) {
    std::get<Floats>(frame.pixels)[index] = value;
    return frame;
}

TEST(Compare, EqualFrames) {
    const Difference d = compare(grey(3, 2), grey(3, 2));
    EXPECT_EQ(d.worst, 0);
    EXPECT_EQ(d.mean, 0);
    EXPECT_EQ(d.rms, 0);
    EXPECT_EQ(d.psnr, infinity);
    EXPECT_EQ(d.pixels, 6U);
    EXPECT_EQ(d.above, 0U);
    EXPECT_EQ(d.nonfinite, 0U);
}

TEST(Compare, KnownDifferences) {
    // 3x2: pixel (1, 0) green +0.25, pixel (2, 1) blue -0.5, pixel (0, 1) red +0.125.
    const Frame expected = grey(3, 2);
    const Frame found = with(with(with(expected, 4, 0.75F), 17, 0.0F), 9, 0.625F);
    const Difference d = compare(expected, found, 0.125);
    EXPECT_EQ(d.maximum, (std::array<double, 3>{0.125, 0.25, 0.5}));
    EXPECT_EQ(d.worst, 0.5);
    EXPECT_DOUBLE_EQ(d.mean, 0.875 / 18);
    const double rms = std::sqrt((0.0625 + 0.25 + 0.015625) / 18);
    EXPECT_DOUBLE_EQ(d.rms, rms);
    EXPECT_DOUBLE_EQ(d.psnr, -20 * std::log10(rms));
    EXPECT_EQ(d.above, 2U);  // 0.125 is not above 0.125
    EXPECT_EQ(d.x, 2);
    EXPECT_EQ(d.y, 1);
    EXPECT_EQ(d.expected, (std::array<double, 3>{0.5, 0.5, 0.5}));
    EXPECT_EQ(d.found, (std::array<double, 3>{0.5, 0.5, 0.0}));
}

TEST(Compare, FirstOfEquallyWorstPixels) {
    const Frame expected = grey(2, 2);
    const Difference d = compare(expected, with(with(expected, 9, 1.0F), 3, 0.0F));
    EXPECT_EQ(d.x, 1);
    EXPECT_EQ(d.y, 0);
}

TEST(Compare, OneCodeIsExactlyOneCode) {
    // As floats, 1/255 apart would come out on either side of 1/255.
    for (int code = 0; code < 255; ++code) {
        const auto low = static_cast<std::uint8_t>(code);
        const auto high = static_cast<std::uint8_t>(code + 1);
        const Difference d = compare({1, 1, Bytes{low, low, low}}, {1, 1, Bytes{low, high, low}}, 1.0 / 255);
        EXPECT_EQ(d.worst, 1.0 / 255) << code;
        EXPECT_EQ(d.above, 0U) << code;
    }
    const Difference two = compare({1, 1, Bytes{7, 7, 7}}, {1, 1, Bytes{7, 7, 9}}, 1.0 / 255);
    EXPECT_EQ(two.above, 1U);
    EXPECT_EQ(two.found[2], 9.0 / 255);
}

TEST(Compare, CodesAgainstTheirFloats) {
    Frame codes = {16, 16, Bytes(768)};
    for (std::size_t i = 0; i < 768; ++i) {
        std::get<Bytes>(codes.pixels)[i] = static_cast<std::uint8_t>(i);
    }
    EXPECT_EQ(compare(codes, {16, 16, image::toFloats(codes)}).worst, 0);
}

TEST(Compare, NanIsADifferenceOnEitherSideAndOnBoth) {
    const Frame number = grey(2, 1);
    const Frame bad = with(number, 5, nan);
    for (const auto& [a, b] : {std::pair(number, bad), std::pair(bad, number), std::pair(bad, bad)}) {
        const Difference d = compare(a, b, 1e30);
        EXPECT_EQ(d.worst, infinity);
        EXPECT_EQ(d.maximum[2], infinity);
        EXPECT_EQ(d.maximum[0], 0);
        EXPECT_EQ(d.mean, infinity);
        EXPECT_EQ(d.rms, infinity);
        EXPECT_EQ(d.psnr, -infinity);
        EXPECT_EQ(d.above, 1U);
        EXPECT_EQ(d.nonfinite, 1U);
        EXPECT_EQ(d.x, 1);
    }
}

TEST(Compare, Infinities) {
    const Frame up = with(grey(1, 1), 0, inf);
    const Frame down = with(grey(1, 1), 0, -inf);
    EXPECT_EQ(compare(up, up).worst, 0);
    EXPECT_EQ(compare(up, up).nonfinite, 1U);
    EXPECT_EQ(compare(up, down).worst, infinity);
    EXPECT_EQ(compare(up, grey(1, 1)).worst, infinity);
}

TEST(Compare, MaskChoosesPixels) {
    const Frame expected = grey(2, 2);
    const Frame found = with(with(expected, 0, 1.0F), 9, 0.75F);
    const Bytes mask = {0, 1, 0, 255};
    const Difference d = compare(expected, found, 0, mask);
    EXPECT_EQ(d.pixels, 2U);
    EXPECT_EQ(d.worst, 0.25);
    EXPECT_EQ(d.x, 1);
    EXPECT_EQ(d.y, 1);
    EXPECT_DOUBLE_EQ(d.mean, 0.25 / 6);
}

std::string errorOf(const Frame& a, const Frame& b, const Bytes& mask) {
    try {
        compare(a, b, 0, mask);
    } catch (const image::Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Compare, Refuses) {
    EXPECT_NE(errorOf(grey(2, 1), grey(1, 2), {}).find("expected 2x1, found 1x2"), std::string::npos);
    EXPECT_NE(errorOf(grey(2, 1), grey(2, 1), {1}).find("the mask has 1 entries; expected none or 2"),
              std::string::npos);
    EXPECT_NE(errorOf(grey(2, 1), grey(2, 1), {0, 0}).find("no pixel to compare"), std::string::npos);
    EXPECT_NE(errorOf({2, 1, Floats(5)}, grey(2, 1), {}).find("holds 5 numbers; expected 6"),
              std::string::npos);
    EXPECT_NE(errorOf(grey(2, 1), {0, 0, Floats()}, {}).find("at least 1x1"), std::string::npos);
}

}  // namespace
