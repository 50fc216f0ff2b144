// Puts the three pictures beside each other.
// SPDX-License-Identifier: MIT
#include "grader/check/trio.hpp"

#include "image/write.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace grader {

namespace {

constexpr int gap = 8;
constexpr double smallest = 0.3;  // of a window's height
constexpr std::array<const char*, 3> roles{"yours", "expected", "difference"};

// Between the four codes around a place, so that a picture of another size is neither coarse nor ragged.
std::uint8_t between(const image::Bytes& codes, int width, int height, double x, double y,
                     std::size_t channel) {
    x = std::clamp(x, 0.0, width - 1.0);
    y = std::clamp(y, 0.0, height - 1.0);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, width - 1), y1 = std::min(y0 + 1, height - 1);
    const auto at = [&](int column, int row) {
        return static_cast<double>(codes[static_cast<std::size_t>(row * width + column) * 3 + channel]);
    };
    const double fx = x - x0, fy = y - y0;
    const double above = at(x0, y0) * (1 - fx) + at(x1, y0) * fx,
                 below = at(x0, y1) * (1 - fx) + at(x1, y1) * fx;
    return static_cast<std::uint8_t>(std::lround(above * (1 - fy) + below * fy));
}

class Sheet {
  public:
    Sheet(int width, int height, std::uint8_t ground)
        : width_(width), height_(height),
          codes_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, ground) {}

    void put(const image::Frame& frame, int left, int top, int size) {
        const auto& codes = std::get<image::Bytes>(frame.pixels);
        const double scaleX = static_cast<double>(frame.width) / size;
        const double scaleY = static_cast<double>(frame.height) / size;
        each(left, top, size, [&](int x, int y, std::uint8_t* pixel) {
            for (std::size_t c = 0; c < 3; ++c)
                pixel[c] = between(codes, frame.width, frame.height, (x + 0.5) * scaleX - 0.5,
                                   (y + 0.5) * scaleY - 0.5, c);
        });
    }
    void cross(int left, int top, int size) {
        constexpr std::uint8_t ground = 112, line = 176;
        const int half = std::max(1, size / 128);
        each(left, top, size, [&](int x, int y, std::uint8_t* pixel) {
            const bool on = std::abs(x - y) <= half || std::abs(x + y - size + 1) <= half;
            std::fill_n(pixel, 3, on ? line : ground);
        });
    }
    image::Frame take() { return {width_, height_, std::move(codes_)}; }

  private:
    template <class Paint>
    void each(int left, int top, int size, const Paint& paint) {
        for (int y = std::max(0, -top); y < size && top + y < height_; ++y)
            for (int x = std::max(0, -left); x < size && left + x < width_; ++x)
                paint(x, y, &codes_[static_cast<std::size_t>((top + y) * width_ + left + x) * 3]);
    }

    int width_, height_;
    image::Bytes codes_;
};

bool isWrong(const Report& report, const Trio& trio) {
    if (trio.pictures[0].width == 0)
        return true;
    return std::any_of(report.checks.begin(), report.checks.end(), [&](const Check& check) {
        return check.status != CheckStatus::pass && std::find(check.images.begin(), check.images.end(),
                                                              trio.part + "-expected") != check.images.end();
    });
}

// "yours (view 1)": what stands in the parentheses.
std::string viewIn(const std::string& label) {
    const std::size_t open = label.find('('), close = label.rfind(')');
    return open == std::string::npos || close < open ? "" : label.substr(open + 1, close - open - 1);
}

}  // namespace

std::vector<Trio> triosOf(const Graded& graded) {
    std::vector<Trio> trios;
    for (const char* part : {"lesson", "terms"}) {
        Trio trio{part, "", {}};
        for (const Picture& picture : graded.pictures)
            for (std::size_t i = 0; i < roles.size(); ++i)
                if (picture.image.id == std::string(part) + "-" + roles[i]) {
                    image::Frame& frame = trio.pictures[i];
                    frame = {picture.image.width, picture.image.height, picture.codes};
                    if (picture.codes.empty())
                        frame.pixels =
                            image::toBytes({frame.width, frame.height, image::Floats(picture.pixels)});
                    if (i == 1)
                        trio.view = viewIn(picture.image.label);
                }
        if (trio.pictures[1].width > 0)
            trios.push_back(std::move(trio));
    }
    std::stable_partition(trios.begin(), trios.end(),
                          [&](const Trio& trio) { return isWrong(graded.report, trio); });
    return trios;
}

Places placesIn(int width, int height, int above, int below) {
    Places places;
    const int high = std::max(height - above - below, static_cast<int>(height * smallest));
    places.size = std::max(1, std::min((width - 4 * gap) / 3, high));
    const int all = 3 * places.size + 2 * gap, first = (width - all) / 2;
    for (int i = 0; i < 3; ++i)
        places.left[static_cast<std::size_t>(i)] = first + i * (places.size + gap);
    places.top = above;
    return places;
}

image::Frame drawn(const Trio* trio, int width, int height, const Places& places, bool light) {
    Sheet sheet(width, height, light ? 226 : 38);
    for (std::size_t i = 0; trio != nullptr && i < 3; ++i)
        if (trio->pictures[i].width > 0)
            sheet.put(trio->pictures[i], places.left[i], places.top, places.size);
        else
            sheet.cross(places.left[i], places.top, places.size);
    return sheet.take();
}

image::Frame pictureOf(const Trio& trio) {
    Places places;
    places.size = trio.pictures[1].width;
    places.top = gap;
    for (int i = 0; i < 3; ++i)
        places.left[static_cast<std::size_t>(i)] = gap + i * (places.size + gap);
    return drawn(&trio, 3 * places.size + 4 * gap, places.size + 2 * gap, places, false);
}

void writePicture(const std::string& file, const Trio& trio, const Report& report) {
    image::write(file, pictureOf(trio),
                 {{"lesson", report.lesson}, {"shows", "mine, expected, difference: " + oneLine(trio.view)}});
}

}  // namespace grader
