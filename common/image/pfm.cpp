// PFM: a header of three lines, then 32-bit floats and nothing else: a file whose size is known before it is written.
// SPDX-License-Identifier: MIT
#include "image/encoders.hpp"
#include "image/temporary_file.hpp"

#include <bit>
#include <cerrno>

namespace image {

void encodePfm(std::FILE* file, const Frame& frame) {
    static_assert(std::endian::native == std::endian::little, "-1.0 in the header says little endian");
    Floats converted;
    const Floats* floats = std::get_if<Floats>(&frame.pixels);
    if (floats == nullptr) {
        converted = toFloats(frame);
        floats = &converted;
    }
    const std::size_t row = static_cast<std::size_t>(frame.width) * 3;
    bool good = std::fprintf(file, "PF\n%d %d\n-1.0\n", frame.width, frame.height) > 0;
    for (int y = frame.height; good && y-- > 0;) {  // the format's first row is the lowest
        const float* first = floats->data() + static_cast<std::size_t>(y) * row;
        good = std::fwrite(first, sizeof(float), row, file) == row;
    }
    if (!good) {
        throwWriteError(errno);
    }
}

}  // namespace image
