// Color, as in three.js r146 without colour management: 0xFF8855 means (1, 0x88/255, 0x55/255).
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace THREE {

/// What a CSS colour may be given as: a literal, a std::string, a std::string_view; never the number 0.
template <class S>
concept Text = std::convertible_to<const S&, std::string_view>;

/// An RGB triple of doubles, linear, 1 = full; what the slides call D, L or P (slide 27).
/// https://threejs.org/docs/#api/en/math/Color
class Color {
  public:
    double r = 1;  ///< red, 0..1 for what a display shows; lights may exceed 1
    double g = 1;  ///< green
    double b = 1;  ///< blue

    Color() = default;
    /// From 0xRRGGBB; only the lower 24 bits count, as in three.js.
    Color(std::uint32_t hex) { set(hex); }
    /// From a CSS colour, see set(std::string_view).
    template <Text S>
    Color(const S& css) {
        set(std::string_view(css));
    }
    Color(double red, double green, double blue) : r(red), g(green), b(blue) {}

    /// From 0xRRGGBB: each byte divided by 255, nothing else (no sRGB decoding).
    Color& set(std::uint32_t hex);
    /// From a CSS name ("orange"), "#rgb", "#rrggbb", "rgb(255, 136, 85)", "rgb(100%, 53%, 33%)" or
    /// "hsl(20, 100%, 67%)". Throws std::invalid_argument that names the text and the accepted forms.
    Color& set(std::string_view css);
    /// From three numbers, 1 = full.
    Color& set(double red, double green, double blue);
    Color& setHex(std::uint32_t hex) { return set(hex); }
    Color& setRGB(double red, double green, double blue) { return set(red, green, blue); }
    /// From a CSS name or notation, as three.js's setStyle.
    Color& setStyle(std::string_view css) { return set(css); }
    /// All three channels the same: a grey.
    Color& setScalar(double grey) { return set(grey, grey, grey); }
    /// Hue, saturation and lightness, each 0..1 (the hue wraps round).
    Color& setHSL(double hue, double saturation, double lightness);

    /// 0xRRGGBB; each channel is clamped to 0..1 and rounded to the nearest code.
    std::uint32_t getHex() const;
    /// The same as six hexadecimal digits in lower case, without '#'.
    std::string getHexString() const;

    Color& add(const Color& other);
    /// Component by component: the slides' "product with a cross in a circle" (slide 27).
    Color& multiply(const Color& other);
    Color& multiplyScalar(double factor);
    /// Towards `other`: t = 0 leaves this colour, t = 1 gives the other.
    Color& lerp(const Color& other, double t);
    bool equals(const Color& other) const { return r == other.r && g == other.g && b == other.b; }
};

inline bool operator==(const Color& a, const Color& b) { return a.equals(b); }

}  // namespace THREE
