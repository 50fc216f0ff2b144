// A frame whose every pixel has a colour of one's choice.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"

#include <glm/vec3.hpp>
#include <vector>

namespace stability {

/// The same picture in floats and as the driver stored it in 8 bits. Pixels stand in the order of their values.
struct Grid {
    image::Frame floats;
    image::Bytes codes;
};
/// At most 256 values, each a small unlit mesh under one pixel's centre; the rest is black.
Grid drawGrid(const std::vector<glm::vec3>& values);

}  // namespace stability
