// The catalogue of named misconceptions: how students get the lighting equation wrong (or right in other words), each as a
// small program of its own, and the frames that such programs would draw.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace grader {

/// A light as a student meets it, before anything is computed from it. World space.
struct Lamp {
    bool point;  ///< false: directional
    glm::dvec3 position;  ///< of the object; P_L of a point light
    glm::dvec3 towards;  ///< directional: position minus target, of any length
    glm::dvec3 color;
    double intensity;
    double decay;  ///< k of f(d) = 1 / d^k
    double distance;  ///< where three.js's window reaches 0; 0: no window

    glm::dvec3 L() const { return color * intensity; }
};

/// Everything that a student could have used at one point of a lit surface. World space unless said otherwise.
struct WrongInput {
    glm::dvec3 n;  ///< the right unit normal
    glm::dvec3 Q;  ///< the point
    glm::dvec3 D;  ///< base colour
    glm::dvec3 emitted;  ///< the material's own light
    glm::dvec3 specular;  ///< K_S: the colour of the highlight; black: none
    double shininess;  ///< s: the highlight's exponent
    double facing;  ///< -1 where the back is seen of a material that turns its normals round, else 1
    std::array<glm::dvec3, 3> corners;  ///< of the triangle, object space
    std::array<glm::dvec3, 3>
        normals;  ///< there, unit, object space; the triangle's own where the mesh is flat
    glm::dvec3 weights;  ///< of the corners; they add up to 1
    glm::dmat4 model;  ///< object space to world space
    glm::dmat4 view;  ///< world space to view space
    glm::dmat4 clip;  ///< world space to clip space
    glm::dvec3 eye;
    std::vector<Lamp>
        lamps;  ///< as the lab's shaders loop over them: directional lights, point lights by their exponent
    glm::dvec3 ambient;  ///< L_A

    glm::dvec3 centre() const { return glm::dvec3(model[3]); }  ///< of the mesh: its own origin
    /// Unit vector from the scene towards the camera, against its line of sight: the z axis of view space.
    glm::dvec3 cameraAxis() const { return {view[0].z, view[1].z, view[2].z}; }
    bool shines() const { return specular != glm::dvec3(0); }  ///< whether there is a highlight to get wrong
};

/// An equation with a name. Most are wrong; some are right in other words and must never be punished.
struct Misconception {
    const char* id;  ///< "A1", "F5L"
    const char* name;  ///< in words, as a report says it
    int firstLesson;  ///< the number of the first lesson that teaches what it gets wrong
    glm::dvec3 (*evaluate)(const WrongInput&);  ///< P of one point, not clamped
    bool right = false;  ///< an equivalent way of writing the slides' equation
};

/// The whole table, in the order of its ids; the right ones ("R1", ...) at the end.
const std::vector<Misconception>& misconceptions();
/// One row. Throws std::out_of_range that names an id that is not there.
const Misconception& misconception(const std::string& id);

/// Rows that no picture can tell apart, everywhere or where something holds.
struct MisconceptionClass {
    std::vector<std::string> ids;
    const char* when;  ///< the condition in words, "always" if there is none
    bool (*holds)(const WrongInput&);  ///< the condition at one point
};
const std::vector<MisconceptionClass>& misconceptionClasses();

/// A scene as the right equation and every wrong one draw it. Only lit surfaces differ: a background or an unlit material
/// has no equation that could be wrong. Highlights are the slides', around R, whatever model a material asks for.
class WrongFrames {
  public:
    /// Sizes in pixels; the camera's own aspect is used. The scene must be valid and have no mesh without volume
    /// (scale 0): some misconceptions divide by it.
    /// With `every` above 1 only each so-many-th lit pixel becomes a point; the others of a frame stay right.
    WrongFrames(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera, int width, int height,
                std::size_t every = 1);

    /// R, G, B of each pixel, top row first, not clamped: the slides' equation, by the reference in doubles.
    const std::vector<float>& truth() const { return truth_; }
    /// The frame that `equation` draws.
    std::vector<float> frame(const Misconception& equation) const;
    /// 1 for a pixel that counts: none within a pixel of an edge, where rasterisers may differ.
    const std::vector<std::uint8_t>& counted() const { return counted_; }
    /// The points of lit surfaces that are seen.
    const std::vector<WrongInput>& points() const { return points_; }
    /// The pixel of each point, counted from the top left.
    const std::vector<std::size_t>& pixels() const { return pixels_; }
    /// Whether `a` and `b` are in a class whose condition holds at every point.
    bool sameClass(const Misconception& a, const Misconception& b) const;

  private:
    std::vector<float> truth_;
    std::vector<std::uint8_t> counted_;
    std::vector<WrongInput> points_;
    std::vector<std::size_t> pixels_;  // of each point
};

/// How far two frames are from each other on a screen, which clamps to [0,1]; NaN is 255 codes from everything.
struct Apart {
    double codes = 0;  ///< largest difference in 8-bit codes, not rounded
    double share = 0;  ///< of the counted pixels, those with a channel that differs by more than 2 codes

    /// What a grader may rely on: at least 0.2 % of the pixels.
    bool clearly() const { return share >= 0.002; }
};
Apart apart(const std::vector<float>& a, const std::vector<float>& b,
            const std::vector<std::uint8_t>& counted);

}  // namespace grader
