// The three formats that `image` writes itself, and how it reaches the others. Internal to common/image.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

#include <cstdio>
#include <string>

namespace image {

// Each writes a checked frame to an open file and throws Error when that fails; the caller closes the file.
void encodePng(std::FILE* file, const Frame& frame, const Metadata& metadata);
void encodeExr(std::FILE* file, const Frame& frame, const Metadata& metadata);
void encodePfm(std::FILE* file, const Frame& frame);  // has no place for metadata

// The module's file name and its one C entry. It encodes the frame in the format of `extension` (lower case,
// with its dot) to memory: on a full disk some of OpenImageIO's writers report success and one ends the
// process. Answers whether all went well; if not, `reason` says why, since no exception should cross from a
// module.
inline constexpr const char* oiioModule = "liblambert_image_oiio.so";
inline constexpr const char* oiioEntry = "lambertImageOiioEncode";
using OiioEncode = bool(const char* extension, const Frame* frame, const Metadata* metadata,
                        std::vector<unsigned char>* encoded, std::string* reason);

}  // namespace image
