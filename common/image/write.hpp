// Writing a frame to a file, whole or not at all.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

#include <string>

namespace image {

// Writes the frame in the format that the path's extension names, in any case:
//   .png   8-bit RGB, the frame's codes as they are (floats through toBytes); metadata as text chunks
//   .exr   32-bit float R, G, B, linear, not clamped, NaN and infinities kept; metadata as lambert:KEY
//   .pfm   the same floats, not compressed, lowest row first and little endian, as the format says; no metadata
//   other  through OpenImageIO (.tif .jpg .hdr .bmp .tga .ppm .webp .gif .dpx): floats where the format holds
//          them, else codes as for .png; metadata as the image's description where the format has one
// The same frame and metadata give the same bytes. The file appears under its name only when complete; on any
// failure nothing is left behind, what stood there before stays, and an Error says path, reason, and what to
// do next. A symbolic link is followed; a directory, a device or a pipe is refused.
void write(const std::string& path, const Frame& frame, const Metadata& metadata);

// Writes a text to a file with the same promises: whole or not at all, never over a device, links followed.
void writeText(const std::string& path, const std::string& text);

}  // namespace image
