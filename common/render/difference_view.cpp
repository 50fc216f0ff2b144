// Codes apart, and their colours.
// SPDX-License-Identifier: MIT
#include "render/difference_view.hpp"

#include "lighting/views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace render {

namespace {

using Code = std::array<std::uint8_t, 3>;

// The colour for each number of codes.
std::array<Code, 256> colors() {
    std::array<Code, 256> table{};
    for (const lighting::LegendEntry& entry : lighting::legend(lighting::ViewMode::difference)) {
        Code color;
        for (int i = 0; i < 3; ++i)
            color[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(entry.color[i] * 255));
        std::fill(table.begin() + static_cast<std::ptrdiff_t>(*entry.value), table.end(), color);
    }
    return table;
}

std::string size(const image::Frame& frame) {
    return std::to_string(frame.width) + "x" + std::to_string(frame.height);
}

}  // namespace

DifferenceView differenceView(const image::Frame& a, const image::Frame& b) {
    if (a.width != b.width || a.height != b.height)
        throw image::Error("two pictures to be compared are " + size(a) + " and " + size(b) +
                           "; expected one size. Draw both again.");
    const image::Bytes first = image::toBytes(a), second = image::toBytes(b);
    const std::array<Code, 256> table = colors();
    DifferenceView view;
    image::Bytes pixels;
    pixels.reserve(first.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < first.size(); i += 3) {
        int apart = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            apart = std::max(apart, std::abs(first[c] - second[c]));
        differing += apart > 0 ? 1 : 0;
        if (apart > view.largest) {
            view.largest = apart;
            view.x = static_cast<int>(i / 3) % a.width;
            view.y = static_cast<int>(i / 3) / a.width;
        }
        const Code& color = table[static_cast<std::size_t>(apart)];
        pixels.insert(pixels.end(), color.begin(), color.end());
    }
    view.share = static_cast<double>(differing) * 3 / static_cast<double>(first.size());
    view.frame = {a.width, a.height, std::move(pixels)};
    return view;
}

}  // namespace render
