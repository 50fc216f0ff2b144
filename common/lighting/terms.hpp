// What can be switched about the lighting equation: its symbols, in one table for keys, options, panel, shaders and tests,
// and where and how it is evaluated.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/materials.hpp"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lighting {

/// A text that people read, in both languages of the lab.
struct Text {
    const char* it = nullptr;
    const char* en = nullptr;
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

/// Where the equation is evaluated (slide 33, "varianti e ottimizzazioni").
enum class Shading {
    pixel,  ///< at each fragment, with the interpolated normal
    vertex,  ///< at each vertex; what comes out is interpolated (Gouraud)
    flat  ///< at each fragment, with one normal for the whole triangle, as material.flatShading
};

/// The space that points and vectors of the equation are in (slide 33): the same picture.
enum class Space { world, view };

/// What takes normals out of object space (slide 33).
enum class NormalTransform {
    inverseTranspose,  ///< the normal matrix: they stay at right angles to the surface
    model  ///< the model matrix alone, as the slide words it: wrong where a mesh is stretched in one direction
};

/// What a user can switch about the equation.
struct Switches {
    TermSet terms;
    Shading shading = Shading::pixel;
    Space space = Space::world;
    NormalTransform normals = NormalTransform::inverseTranspose;
    std::optional<THREE::SpecularModel> specular;  ///< instead of each material's own model

    Switches(TermSet on = TermSet::all()) : terms(on) {}
    bool operator==(const Switches&) const = default;
};

/// Reads --terms: "all", "none", a list of names to keep ("cosine,albedo"), or of changes to `start` ("-clamp,+ambient").
/// Throws std::invalid_argument that names the word and lists the terms.
TermSet parseTerms(std::string_view list, TermSet start);

}  // namespace lighting
