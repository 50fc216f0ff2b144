// Draws cells and text with OpenImageIO.
// SPDX-License-Identifier: MIT
#include "stability/picture.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <filesystem>
#include <stdexcept>

namespace stability {

namespace {

using Color = std::array<float, 3>;
constexpr Color black{0.1F, 0.1F, 0.1F}, white{1, 1, 1}, grey{0.88F, 0.88F, 0.9F}, dark{0.25F, 0.28F, 0.35F};
constexpr Color green{0.78F, 0.93F, 0.78F}, red{0.96F, 0.6F, 0.58F}, orange{1, 0.84F, 0.55F};
constexpr const char* plainFont = "DejaVuSans";
constexpr const char* boldFont = "DejaVuSans-Bold";

constexpr std::array<int, columns> widths{36, 196, 214, 150, 112, 118, 104, 104, 92, 118, 78, 54};
constexpr int margin = 10, rowHeight = 19, headHeight = 24, legendHeight = 56, textSize = 12;

class Canvas {
  public:
    Canvas(int width, int height) : image_(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8)) {
        box(0, 0, width, height, white);
    }
    void box(int x, int y, int width, int height, const Color& color) {
        OIIO::ImageBufAlgo::fill(image_, {color.data(), 3}, OIIO::ROI(x, x + width, y, y + height));
    }
    // From x on, no wider than `width`: smaller letters where it does not fit.
    void text(int x, int baseline, int width, const std::string& words, const Color& color,
              const char* font = plainFont) {
        int size = textSize;
        while (size > 7 && OIIO::ImageBufAlgo::text_size(words, size, font).width() > width)
            --size;
        if (!OIIO::ImageBufAlgo::render_text(image_, x, baseline, words, size, font, {color.data(), 3}))
            throw std::runtime_error("cannot draw text: " + image_.geterror() +
                                     "; install fonts-dejavu-core");
    }
    void write(const std::string& path) {
        const std::string partial = path + ".partial.png";
        if (!image_.write(partial))
            throw std::runtime_error("cannot write " + path + ": " + image_.geterror());
        std::filesystem::rename(partial, path);
    }

  private:
    OIIO::ImageBuf image_;
};

Color background(Peer::Verdict verdict, const Color& otherwise) {
    return verdict == Peer::ok          ? green
           : verdict == Peer::wrong     ? orange
           : verdict == Peer::notFinite ? red
                                        : otherwise;
}

void drawLegend(Canvas& canvas, int width) {
    canvas.text(margin, 21, width, "Numerical stability: what goes wrong in floats, row by row", black,
                boldFont);
    const std::array<std::pair<Color, const char*>, 3> meanings{
        {{green, "right, within one code (ours: within its bound)"},
         {orange, "off by more than one code, or a bad number taken without a word"},
         {red, "NaN or infinite"}}};
    int x = margin;
    for (const auto& [color, meaning] : meanings) {
        canvas.box(x, 32, 26, 14, color);
        canvas.text(x + 32, 43, width, meaning, black);
        x += 58 + OIIO::ImageBufAlgo::text_size(meaning, textSize, plainFont).width();
    }
    canvas.text(x, 43, width, "u = 2^-24, A = 16/255 ambient light, S: the sum with all cosines 1", black);
}

void drawLine(Canvas& canvas, const Line& line, int y, const Color& paper) {
    int x = margin;
    for (std::size_t column = 0; column < columns; ++column) {
        const Cell& cell = line[column];
        canvas.box(x, y, widths[column] - 1, rowHeight - 1, background(cell.verdict, paper));
        canvas.text(x + 4, y + 13, widths[column] - 9, cell.text, black, column == id ? boldFont : plainFont);
        x += widths[column];
    }
}

}  // namespace

void drawTable(const std::vector<Line>& lines, const std::string& path) {
    int width = 2 * margin;
    for (const int column : widths)
        width += column;
    Canvas canvas(width, legendHeight + headHeight + static_cast<int>(lines.size()) * rowHeight + margin);
    drawLegend(canvas, width);
    canvas.box(margin, legendHeight, width - 2 * margin, headHeight, dark);
    int x = margin;
    for (std::size_t column = 0; column < columns; ++column) {
        canvas.text(x + 4, legendHeight + 16, widths[column] - 9, titles[column], white, boldFont);
        x += widths[column];
    }
    int y = legendHeight + headHeight;
    for (std::size_t i = 0; i < lines.size(); ++i, y += rowHeight) {
        drawLine(canvas, lines[i], y, i % 2 == 0 ? white : grey);
    }
    canvas.write(path);
}

}  // namespace stability
