// What one frame needs: the draws, the addends of the sum, and what is left out and why. Plain data, no GL.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/terms.hpp"
#include "lighting/views.hpp"
#include "three/lights.hpp"
#include "three/scene.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

namespace lighting {

/// What the user chose for the frame; scene and camera come beside it.
struct Settings : Switches {
    bool skip =
        true;  ///< false: every draw, light, term, cull and upload that could be dropped is kept (--no-skip)
    bool countNonfinite = false;  ///< count pixels where an operand was NaN or infinite
    double lightCut =
        0;  ///< what point and directional lights may lack at a pixel, 8-bit codes (--light-cut); >= 0
    int constantLights = 256;  ///< sums of more lights have none of them compiled in as constants
    int uniformLights = 256;  ///< more lights than this are in a texture
    glm::dvec3 focus{0};  ///< the point that the camera orbits, world space: the anchor is near it
    double focusDistance = 1;  ///< from the camera to the focus, world units, > 0
    ViewMode view = ViewMode::final;  ///< what the frame shows
    /// The picture as if this light alone were there; null: all lights. Compared with those of the scene, never followed.
    const THREE::Light* only = nullptr;
};

/// An addend of the sum whose direction is the same everywhere (slides 29-30).
struct DirectionalAddend {
    glm::dvec3 w;  ///< unit vector towards the light, lighting space
    glm::dvec3 color;  ///< L = color x intensity
    double intensity;  ///< what stays when light_color is off
    bool dark = false;  ///< adds exactly nothing: only --no-skip keeps it
    const THREE::Light* light = nullptr;  ///< whose addend it is
};

/// An addend whose light comes from a point (slides 29-31).
struct PointAddend {
    glm::dvec3 position;  ///< lighting space
    glm::dvec3 color;  ///< L = color x intensity x 2^exponent, for distances in frame units
    double intensity;  ///< what stays of color when light_color is off
    double decay;  ///< k of f(d) = 1/d^k
    double distance;  ///< where the window reaches 0, frame units; 0: no window
    double exponent = 0;  ///< not 0 only where color would not fit in a float
    bool dark = false;  ///< adds exactly nothing: only --no-skip keeps it
    const THREE::Light* light = nullptr;  ///< whose addend it is
    /// Frame units: beyond it nothing arrives (`distance`), or less than --light-cut lets go of. Infinite: shines everywhere.
    double reach = std::numeric_limits<double>::infinity();
    double cut = 0;  ///< 8-bit codes that a pixel beyond `reach` may lack of it; 0: nothing arrives there
};

/// Which loop of the shader a light is in: 0, 1, 2 for these exponents, 3 for any other.
inline unsigned decayGroup(const PointAddend& light) {
    return light.decay == 0 ? 0 : light.decay == 1 ? 1 : light.decay == 2 ? 2 : 3;
}

/// The point lights of a mesh's sum: numbers of FramePlan::point, ascending. All directional ones are in it, unless it is `empty`.
struct LightSet {
    std::vector<std::uint32_t> point;
    bool empty = false;  ///< no light at all, no ambient either: what is black stays black

    auto operator<=>(const LightSet&) const = default;
};

/// Where a shader has the numbers of its lights from: the same formula and the same bits.
enum class LightStorage {
    constants,  ///< compiled in, but for those that move
    uniforms,
    texture  ///< too many for uniforms
};

/// What decides which shader is compiled: only what this scene has. The point lights stand sorted by exponent.
struct Variant {
    unsigned terms = 0;  ///< TermSet bits, without those that cannot matter here
    bool lit =
        false;  ///< without, all pixels are one colour: unlit materials, and lit ones that no light with a direction reaches
    bool perVertex = false;  ///< the equation is in the vertex shader (Shading::vertex)
    bool blinn = false;  ///< three.js's highlight instead of the slides' R
    bool doubleSided = false;  ///< the normal is turned on back faces
    bool ambient = false;  ///< there is an ambient light
    bool emissive = false;  ///< the material gives off light of its own
    bool window = false;  ///< some point light has a `distance`
    bool scaled = false;  ///< numbers here leave the range of floats: shaders/range.glsl scales them
    bool countNonfinite = false;  ///< writes a second target, see Settings
    int directional = 0;  ///< number of directional lights
    int decay0 = 0;  ///< number of point lights with k = 0
    int decay1 = 0;  ///< ... with k = 1
    int decay2 = 0;  ///< ... with k = 2
    int decayOther = 0;  ///< ... with any other exponent, which goes through pow
    LightStorage storage = LightStorage::uniforms;
    /// Exponents that lights of clusters have, which are not counted above (lighting/light_clusters.hpp): bits 0 to 3 for k = 0, 1, 2,
    /// others.
    unsigned clustered = 0;
    /// What its pixels show where that is neither P nor P with other lights: the data views (isData), where `terms` are those that the view
    /// shows; red, green, blue and overexposed. `final` in all others.
    ViewMode view = ViewMode::final;
    bool longLoops = false;  ///< so many lights that a driver might end a loop over them early

    int point() const { return decay0 + decay1 + decay2 + decayOther; }
    bool has(Term term) const { return (terms >> static_cast<unsigned>(term) & 1U) != 0; }
    void drop(Term term) { terms &= ~(1U << static_cast<unsigned>(term)); }
    auto operator<=>(const Variant&) const = default;
};

/// One mesh to draw. Lighting space is where the equation is evaluated: frame space, which is world space about the anchor in
/// units of FramePlan::unit, or view space in the same units (Space::view). Matrices are formed in double and rounded to
/// float once, by the renderer.
struct Draw {
    const THREE::Mesh* mesh = nullptr;
    glm::dvec3 origin{0};  ///< object space; vertices are uploaded relative to it, which the matrices undo
    glm::dmat4 model;  ///< object space to lighting space
    glm::dmat3 normalMatrix;  ///< normals of object space to lighting space, see THREE::normalMatrix
    glm::dmat4 clip;  ///< object space to clip space
    glm::dvec3 albedo;  ///< D, or the pixel's colour where the variant is not lit
    glm::dvec3 emitted;  ///< added after the sum
    glm::dvec3 specular{0};  ///< K_S; 0 and not Variant::blinn for materials that do not shine
    double shininess = 0;  ///< s
    bool flat = false;  ///< one normal per triangle
    std::size_t lights = 0;  ///< which of FramePlan::lightSets
    Variant variant;
    bool mirrored = false;  ///< the model matrix turns triangles round: front faces are clockwise
    bool outside = false;  ///< of the camera's view: only --no-skip keeps it
    double reach = 0;  ///< from the eye to the farthest point of its bounding sphere, frame units
    double nearestDepth = 0;  ///< of its bounding sphere, view space in frame units; draws are sorted by it
    double farthestDepth = 0;  ///< the same
    THREE::Side side =
        THREE::FrontSide;  ///< which faces are drawn: the material's, or fewer where the others are hidden
};

/// Something that the frame does without: exactly, or within --light-cut.
struct Skipped {
    const THREE::Object3D* object;  ///< a mesh or a light; THREE::describe names it
    Text why;  ///< "its intensity is 0"
    std::string share = {};  ///< what stands before `why`, where only a part is left out: "3/8 "
};

/// Everything that a renderer needs to know of a frame.
struct FramePlan {
    glm::dvec3 background{0};
    glm::dvec3 anchor{0};  ///< world space: the origin that positions are relative to, on a power-of-two grid
    double unit =
        1;  ///< world units in a frame unit: 1, or a power of two where the view is very small or very large
    glm::dvec3 eye{0};  ///< where the camera is, lighting space
    glm::dvec3 ambient{0};  ///< sum of the ambient lights: L_A
    std::vector<DirectionalAddend> directional;
    /// Sorted by exponent: 0, 1, 2, others; scene order within each. Where Variant::clustered is not 0, those with a finite
    /// reach come last, sorted alike.
    std::vector<PointAddend> point;
    std::vector<LightSet> lightSets;  ///< the first has all lights
    std::vector<Draw> draws;  ///< front to back
    std::vector<Skipped> skipped;
    int meshesSkipped = 0;
    int lightsUsed = 0;  ///< ambient ones included
    int lightsSkipped = 0;
    long long pairsSkipped =
        0;  ///< a mesh and a directional or point light that its sum does without, lights skipped as a whole not counted
    int sidesSkipped = 0;  ///< meshes whose back faces are hidden, and not drawn
    double cutCodes =
        0;  ///< what --light-cut really takes from no pixel's sum more of, 8-bit codes: at most what was allowed
    glm::dmat4 lightingToView{1.0};  ///< lighting space to view space, both in frame units
    glm::dmat4 projection{1.0};  ///< view space to clip space
    double near = 0;  ///< the near plane's depth, frame units
    ViewMode view = ViewMode::final;  ///< what the frame shows: Settings::view
    bool litMeshes = false;  ///< some drawn material is lit
    bool emissive = false;  ///< some lit material gives off light of its own
    bool shiny = false;  ///< some drawn material has a highlight
    /// Some light that is not ambient is not white; it may be black, and so be skipped.
    bool lightColorMatters = false;
    bool albedoNotWhite = false;  ///< some lit material's base colour is not (1,1,1)
};

/// Plans a frame. The matrices of scene and camera must be up to date and validated (THREE::validate).
FramePlan planFrame(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                    const Settings& settings);

/// Why switching `term` cannot change the picture of this plan, in both languages; both null if it can.
Text idleReason(Term term, const FramePlan& plan);

}  // namespace lighting
