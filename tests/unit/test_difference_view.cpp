// What two pictures differ by, as a picture.
// SPDX-License-Identifier: MIT
#include "lighting/views.hpp"
#include "render/difference_view.hpp"

#include <gtest/gtest.h>

namespace {

using image::Bytes;
using image::Frame;

// The colour of a pixel, as the legend has it for this number of codes.
glm::dvec3 colorFor(int codes) {
    glm::dvec3 color{-1};
    for (const lighting::LegendEntry& entry : lighting::legend(lighting::ViewMode::difference))
        if (codes >= *entry.value)
            color = entry.color;
    return color;
}

TEST(DifferenceView, HasTheLegendsColours) {
    const int apart[] = {0, 1, 2, 3, 4, 7, 8, 31, 32, 255};
    const Frame a{10, 1, Bytes(30, 0)};
    Frame b = a;
    for (std::size_t i = 0; i < 10; ++i)
        std::get<Bytes>(b.pixels)[i * 3 + i % 3] = static_cast<std::uint8_t>(apart[i]);
    const render::DifferenceView view = render::differenceView(a, b);
    const auto& pixels = std::get<Bytes>(view.frame.pixels);
    for (std::size_t i = 0; i < 10; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(pixels[i * 3 + c], 255 * colorFor(apart[i])[static_cast<int>(c)], 1e-9) << apart[i];
    EXPECT_EQ(view.largest, 255);
    EXPECT_EQ(view.x, 9);
    EXPECT_EQ(view.y, 0);
    EXPECT_DOUBLE_EQ(view.share, 0.9);
    EXPECT_TRUE(render::differenceView(b, a).frame.pixels == view.frame.pixels) << "either way round";
}

TEST(DifferenceView, OfTheLargestChannelAndTheFirstPixel) {
    const Frame a{2, 2, Bytes(12, 100)},
        b{2, 2, Bytes{100, 100, 100, 99, 105, 98, 95, 100, 100, 100, 100, 100}};
    const render::DifferenceView view = render::differenceView(a, b);
    EXPECT_EQ(view.largest, 5);
    EXPECT_EQ(view.x, 1);
    EXPECT_EQ(view.y, 0);
    EXPECT_DOUBLE_EQ(view.share, 0.5);
}

TEST(DifferenceView, EqualAndUnequal) {
    const Frame codes{1, 2, Bytes{0, 128, 255, 1, 2, 3}};
    const render::DifferenceView same = render::differenceView(codes, {1, 2, image::toFloats(codes)});
    EXPECT_EQ(same.largest, 0);
    EXPECT_EQ(same.share, 0);
    EXPECT_EQ(std::get<Bytes>(same.frame.pixels), Bytes(6, 0));
    EXPECT_THROW(render::differenceView(codes, {2, 1, Bytes(6, 0)}), image::Error);
}

}  // namespace
