// SHA-256, in hexadecimal.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace grader {

/// 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace grader
