// What can go wrong between a plan and a picture.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace render {

/// There is no way to draw here: no EGL, no driver, no float target, a frame larger than the driver's limit. what() says what was
/// tried and what to install. Programs leave with status 3.
class NoRenderer : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A shader file that is missing or does not compile. what() says file:line, the driver's message and the lines around it.
class ShaderError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace render
