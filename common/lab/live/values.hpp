// Values of controls as text: what commands, state files and widgets say.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/color.hpp"
#include "three/vector3.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace lab {

/// "0xDD6666" where each channel is a whole code of 255, else "r,g,b": reads back as the same doubles.
std::string colorText(const THREE::Color& color);
/// Reads "0xDD6666", "r,g,b" (1 is full, each from 0 to 1e36), and what CSS knows: "#d66", "orange". Throws UsageError.
THREE::Color readColor(std::string_view text);

/// "x,y,z" with numbers that read back as the same doubles.
std::string vectorText(const THREE::Vector3& vector);
std::string numbersText(const std::vector<double>& numbers);
/// Reads numbers with commas between them, each at most 1e36 in size; `least` to `most` of them. Throws UsageError.
std::vector<double> readNumbers(std::string_view text, std::size_t least, std::size_t most);
THREE::Vector3 readVector(std::string_view text);
/// Reads a number from `min` to `max`. Throws UsageError.
double readNumber(std::string_view text, double min, double max);

}  // namespace lab
