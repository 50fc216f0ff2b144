// PNGs at half their size. Internal to tests/grader/report.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace grader {

/// The PNG with half the pixels each way, every one the mean of four; "" if it cannot be read or is down to one pixel.
std::string halved(const std::string& png);

}  // namespace grader
