// What a row of the stability suite builds: a plane that faces the camera, under lights, whose middle pixel is judged.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stability {

inline constexpr double A = 16 / 255.0;  ///< the lecture's ambient light, 0x101010

/// A light of a row; its place is relative to the plane's centre, world space.
struct Lamp {
    enum Kind { sun, bulb } kind = bulb;
    glm::dvec3 place{0, 0, 1};  ///< of a bulb; the direction towards a sun
    double intensity = 1;
    double decay = 0;  ///< k
    double distance = 0;  ///< window, 0: none
    glm::dvec3 color{1};
};
inline Lamp sun(const glm::dvec3& towards, double intensity = 1) {
    return {Lamp::sun, towards, intensity, 0, 0, glm::dvec3(1)};
}
/// Straight above the plane's centre.
inline Lamp bulb(double d, double k, double intensity = 1, double distance = 0) {
    return {Lamp::bulb, {0, 0, d}, intensity, k, distance, glm::dvec3(1)};
}

/// How far a result may be from the truth.
struct Bound {
    enum Unit { uS, ulp, code, exact } unit = uS;
    double value = 16;

    std::string text() const;
    /// As a difference; S is the sum with every cosine taken as 1.
    double tolerance(long double truth, long double S) const;
};
inline constexpr Bound exactly{Bound::exact, 0};

/// A highlight.
struct Gloss {
    glm::dvec3 specular{1};  ///< K_S
    double shininess = 30;  ///< s
    THREE::SpecularModel model = THREE::SpecularModel::phong;
};

/// A plane with its middle pixel: by default white, 6 x 6, seen from 2 away, ambient light only.
struct Setup {
    std::vector<Lamp> lamps{};
    double ambient = A;
    glm::dvec3 albedo{1};
    std::array<glm::dvec3, 4> normals{
        {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};  ///< object space, any length
    bool generatedNormals = false;  ///< computeVertexNormals() instead
    double size = 1;  ///< factor of the plane and of the camera's distance from it
    glm::dvec3 eye{0, 0, 2};  ///< where the camera is, from the centre, if `size` is 1 and nothing turned
    glm::dvec3 centre{0};  ///< of the plane, world space
    THREE::Quaternion turn{};  ///< of the plane and the camera
    bool placeInVertices = false;  ///< centre and turn are in the vertices, not in the mesh's place
    std::function<void(THREE::Mesh&)> pose{};  ///< what else is done to the mesh
    /// Where the user looks, world space, if that is not the plane's centre.
    std::optional<glm::dvec3> focus{};
    int pixels = 65;  ///< each way; odd, so that the middle one sees the plane's centre
    Bound bound{};
    std::optional<Gloss> gloss{};  ///< none: the plane is matt
    bool perVertex = false;  ///< Shading::vertex
    bool jumps = false;  ///< the truth jumps here: rounding in view space may fall to the other side
    std::optional<double> expected{};  ///< of `channel`; none: only what the reference says
    int channel = 0;  ///< the one that is shown; the others are judged all the same
    /// Not empty: the scene is refused, and the message holds these words.
    std::vector<std::string> refused{};
};

/// A setup that was built; `size` stands for the setup's own.
class Stage {
  public:
    explicit Stage(const Setup& setup, double size);

    THREE::Scene scene;
    THREE::BufferGeometry geometry;
    THREE::MeshPhongMaterial material;  ///< matt unless the setup has a gloss
    THREE::Mesh mesh{geometry, material};
    THREE::PerspectiveCamera camera{53.13010235415598};
    support::DrawOptions options;

    int middle() const { return options.width / 2; }  ///< row and column of the middle pixel
    /// What THREE::validate says against it; empty: nothing.
    std::string refusal();
    /// The plan with all matrices up to date; the scene must be valid.
    lighting::FramePlan plan();

  private:
    void addPlane(const Setup& setup, double size);
    void look(const Setup& setup, double size);
    void addLamp(const Lamp& lamp, const glm::dvec3& centre, std::size_t number);

    THREE::AmbientLight ambient_;
    std::vector<std::unique_ptr<THREE::Light>> lights_;
};

/// What the reference's equation says at the middle of the plane, in long double. S: with every cosine and power taken as 1.
struct Truth {
    glm::vec<3, long double> P, S;
};
Truth truth(Stage& stage);

/// The middle fragment of mesh.vert and mesh.frag, or gouraud.vert and gouraud.frag, on the CPU in strict IEEE.
struct Twin {
    glm::vec3 P;
    bool nonfinite;
};
Twin twin(Stage& stage);

/// Everything that was measured of a setup. Values are those of its channel.
struct Measured {
    double expected = 0, twin = 0, gl = 0;
    double error =
        -1;  ///< the worst of all channels and runs, in units of u S; negative: the bound is in codes
    double spaces = 0;  ///< the most that a pixel differs in view space, relative to the frame's brightest
    std::vector<std::string> failures;  ///< what misses the bound, with its numbers
};
/// Runs a setup on the CPU's twin and on the graphics driver, against the reference and the closed value. Where the
/// plane is not of ordinary size, several times: with a focus as far as lesson programs would have it, with an ordinary
/// one (so that the plan does not change the unit of length) and, the twin alone, with a plane of ordinary size. Each
/// time in view space as well (Space::view).
Measured measure(const Setup& setup);

}  // namespace stability
