// The symbols of the lighting equation that can be switched: one table for keys, options, panel, shaders and tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lighting {

/// A text that people read, in both languages of the lab.
struct Text {
    const char* it;
    const char* en;
};

/// A symbol of  P = ( sum_i max(0, n . w_i) f(d_i) D (x) L_i ) + D (x) L_A  (slide 42). The number is its key minus 1.
enum class Term { albedo, cosine, clamp, lightColor, attenuation, directional, point, ambient, specular };
inline constexpr int termCount = 9;

/// A row of the table.
struct TermInfo {
    Term term;
    const char* name;  ///< for --terms and JSON: "light_color"
    const char* symbol;  ///< as on the slides, UTF-8
    const char* define;  ///< of the shader: TERM_LIGHT_COLOR
    const char* slides;  ///< where the lecture brings it in
    Text meaning;  ///< what it is
    Text off;  ///< the neutral element that stands in its place when it is off
};

/// The rows in the order of their keys, 1 to 9.
const std::array<TermInfo, termCount>& terms();
const TermInfo& info(Term term);

/// Which symbols are on. A set of Term by value.
class TermSet {
  public:
    static TermSet all() { return TermSet((1U << termCount) - 1); }
    static TermSet none() { return TermSet(0); }

    bool has(Term term) const { return (bits_ >> static_cast<unsigned>(term) & 1U) != 0; }
    TermSet with(Term term) const { return TermSet(bits_ | 1U << static_cast<unsigned>(term)); }
    TermSet without(Term term) const { return TermSet(bits_ & ~(1U << static_cast<unsigned>(term))); }
    TermSet toggled(Term term) const { return has(term) ? without(term) : with(term); }
    unsigned bits() const { return bits_; }
    bool operator==(const TermSet&) const = default;

    /// "all", "none", or the names that are on, separated by commas.
    std::string text() const;

  private:
    explicit TermSet(unsigned bits) : bits_(bits) {}
    unsigned bits_;
};

/// Reads --terms: "all", "none", a list of names to keep ("cosine,albedo"), or of changes to `start` ("-clamp,+ambient").
/// Throws std::invalid_argument that names the word and lists the terms.
TermSet parseTerms(std::string_view list, TermSet start);

}  // namespace lighting
