// Compiled into programs that are built outside the lab, by its CMake package: tells them where the lab is.
// SPDX-License-Identifier: MIT
#include "image/home.hpp"

namespace {

[[maybe_unused]] const bool said = (image::setHome(LAMBERT_LAB_HOME), true);

}  // namespace
