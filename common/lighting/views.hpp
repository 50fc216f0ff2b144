// What a frame can show besides the lit scene: each factor and each addend of the equation by itself, and where it goes wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/terms.hpp"
#include "three/lights.hpp"
#include "three/scene.hpp"

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lighting {

struct Settings;

/// What a frame shows. The factors are those of one light (viewLight); where their term is off, its neutral element.
enum class ViewMode {
    final,  ///< P, the lit scene
    albedo,  ///< D
    cosine,  ///< n . w, negative values in a hue
    clamp,  ///< max(0, n . w) in grey
    lightColor,  ///< L
    attenuation,  ///< f(d), on a logarithmic scale
    directional,  ///< the sum of the directional lights' addends alone
    point,  ///< the sum of the point lights' addends alone
    ambient,  ///< D (x) L_A alone
    specular,  ///< the highlights alone: as if D were black
    red,  ///< the red channel of P in grey (slide 26)
    green,  ///< the green channel
    blue,  ///< the blue channel
    normals,  ///< 0.5 + 0.5 n, world space
    w,  ///< 0.5 + 0.5 w, world space
    bands,  ///< n . w in steps of 0.1, the negative ones hatched
    overexposed,  ///< P dimmed, with marks where a channel is above 1 (slide 39)
    exaggerated,  ///< P with `exaggeration` times the ambient light (slide 41)
    difference  ///< of two frames, which the caller draws (render/difference_view.hpp): a frame of it is P
};
inline constexpr int viewCount = 19;

/// What a view's legend is like.
enum class LegendKind {
    none,  ///< colours are what they are
    ramp,  ///< colours between two entries mean values between theirs
    steps,  ///< every entry is a range from its value on
    axes,  ///< an entry is a direction; channels are coordinates
    marks  ///< every entry is a colour with a meaning
};

/// A row of the table.
struct ViewInfo {
    ViewMode view;
    const char* name;  ///< as users type it: "light_color"
    const char* slides;  ///< where the lecture has what it shows
    Text meaning;  ///< what it shows
    bool needsLight;  ///< shows nothing without a directional or a point light
    LegendKind legend;
};

/// The rows, in the order of ViewMode.
const std::array<ViewInfo, viewCount>& views();
const ViewInfo& info(ViewMode view);
/// The view of that name. Throws std::invalid_argument that names the word and lists the views.
ViewMode parseView(std::string_view name);

/// A colour of a view and what it means.
struct LegendEntry {
    glm::dvec3 color;  ///< as pixels have it, 0 to 1
    std::optional<double> value;  ///< the number that it stands for: a factor, or how many channels
    Text text;  ///< what it means besides; null where the number is enough
};

/// What the colours of a view mean; empty where they are what they are. On a ramp, by ascending value.
std::vector<LegendEntry> legend(ViewMode view);

/// Whether lit surfaces show a quantity of the equation instead of P: albedo to attenuation, normals, w, bands. Such views are per
/// fragment whatever Shading is, and of world space vectors whatever Space is: that a space changes nothing is for P to show.
bool isData(ViewMode view);
/// Whether it is the sum with some of its addends only: directional, point, ambient, specular.
bool isAddend(ViewMode view);
/// Whether switching the term cannot change the view, whatever the scene is.
bool hides(ViewMode view, Term term);

/// The light whose factors are seen: settings.only, else the first visible directional or point light of the scene. Null where there is
/// none, and where settings.only is no such light.
const THREE::Light* viewLight(const THREE::Scene& scene, const Settings& settings);

/// The settings that a view asks for: the terms, lights, space and shading that it shows.
Settings settingsFor(const THREE::Scene& scene, const Settings& settings);
/// What is behind everything in a view, where the scene's background is `color`.
glm::dvec3 backgroundFor(ViewMode view, const glm::dvec3& color);

inline constexpr double exaggeration = 8;  ///< times the ambient light, in ViewMode::exaggerated
inline constexpr double dimmed = 0.35;  ///< what stays of P in ViewMode::overexposed
/// A channel above it is overexposed: its 8-bit code would be above 255.
inline constexpr double overexposedFrom = 1 + 0.5 / 255;
/// What is behind everything in data views: no colour of a scale.
inline constexpr glm::dvec3 noSurface{0x17 / 255.0, 0x1C / 255.0, 0x29 / 255.0};
/// What has no value in data views: unlit meshes, and all where there is no light.
inline constexpr glm::dvec3 noValue{0x2B / 255.0, 0x31 / 255.0, 0x40 / 255.0};

}  // namespace lighting
