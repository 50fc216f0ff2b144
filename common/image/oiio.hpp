// Reads pictures of any format through OpenImageIO, for tests, graders and benchmarks: what renders must not.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

#include <string>

namespace image {

// The picture as floats R, G, B, top row first, in the file's own values: no colour conversion, codes over
// 255 in 8-bit formats (toBytes gives the codes back exactly). Channels named R, G, B are taken, else the
// first three, else the first for all three; alpha is dropped, colours are not multiplied by it. Throws Error
// with path and reason for what cannot be read, is larger than 16384 either way (before memory is taken), or
// is cropped, deep or a volume.
Frame readFrame(const std::string& path);

// The texts that the file carries, in its order. Keys are those given to write() for .png and .exr; other
// formats keep theirs in ImageDescription. Throws Error as readFrame does.
Metadata readMetadata(const std::string& path);

}  // namespace image
