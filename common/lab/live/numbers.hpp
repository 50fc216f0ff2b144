// Numbers and vectors as the probe writes them: rounded to significant digits, a decimal point in every
// language.
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace lab {

/// With so many significant digits, 1 to 17: "0.62", "1e-07"; never "-0".
std::string significant(double value, int digits);
/// "(x, y, z)"
std::string significant(const glm::dvec3& v, int digits);

/// Without rounding's dust: parts of 1e-12 of the largest one, or of `size`, or less are 0.
glm::dvec3 dusted(const glm::dvec3& v, double size = 0);

/// For the eye: dusted, with three significant digits.
std::string shortText(const glm::dvec3& v);
/// Two decimals, or two significant digits where that would be too few; whole numbers as such: "0.62",
/// "0.0037", "1".
std::string shortText(double value);
/// A colour: two decimals each, whole ones as such: "(1.00, 0.53, 0.33)", "(1, 1, 1)".
std::string colorText(const glm::dvec3& v);

}  // namespace lab
