// The pixel probe: a point of a surface, and everything that the equation makes of it, in double.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/panel.hpp"
#include "lighting/reference/reference.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lab {

/// A point that stays on its surface while the camera orbits and the mesh moves (slide 13: the same colour
/// from every angle).
struct SurfacePoint {
    const THREE::Mesh* mesh = nullptr;  ///< compared only, never read: it may be gone
    std::size_t triangle = 0;  ///< of its geometry
    glm::dvec3 weights{0};  ///< of the triangle's corners; they add up to 1
};

/// What one directional or point light adds to the point. World space.
struct ProbeLight {
    int number = 0;  ///< as numberedLights counts
    std::string name;  ///< may be empty
    bool directional = false;
    bool counted = true;  ///< false: the sum that it belongs to is off
    lighting::reference::Addend<double> addend{};  ///< as if it were counted; its `light` is the scene's
    double decay = 0, distance = 0;  ///< of a point light: k, and where its window ends (0: none)
    glm::dvec3 diffuse{0};  ///< max(0, n . w) f(d) D (x) L
    glm::dvec3 highlight{0};  ///< f(d) K_S max(0, R . v)^s (x) L, or three.js's model
};

/// All about a pixel or a point. World space.
struct ProbeReport {
    /// The pixel where the point is seen; 0,0 is the top left. None where nothing of it is seen.
    std::optional<std::array<int, 2>> pixel;
    bool centre = true;  ///< the point is what the pixel's very centre shows: what the driver evaluates, too
    std::optional<PanelPoint>
        place;  ///< where it is in the picture, also hidden or beside it; none behind the eye
    std::optional<SurfacePoint> point;  ///< none: the background
    lighting::reference::Sight sight = lighting::reference::Sight::visible;
    std::string mesh;  ///< THREE::describe's name of it
    lighting::reference::Probe<double> probe;  ///< the sum; probe.P is not clamped
    std::vector<ProbeLight>
        lights;  ///< in the order of the scene; without ambient and invisible ones; none where unlit
    std::vector<int> ambientLights;  ///< numbers of the visible ambient lights
    glm::dvec3 ambientLight{0};  ///< L_A
    lighting::Switches switches;
    glm::dvec3 clamped{0};  ///< P as a screen shows it, 0 to 1
    std::array<std::uint8_t, 3> code{};  ///< P in 8 bits
    std::optional<std::array<std::uint8_t, 3>> drawn;  ///< what the driver drew in `pixel`, if it is known

    bool shines() const { return probe.lit && probe.gloss.shines(); }
    bool on(lighting::Term term) const { return switches.terms.has(term); }
    /// The light of that number, or null.
    const ProbeLight* light(int number) const;
};

/// Answers questions about a picture without drawing it. What it needs of the scene is copied when it is
/// first asked after see(), some 3 ms for 50,000 triangles; a pixel then takes some 0.02 ms.
class Prober {
  public:
    /// Looks anew: to be called after every change of scene, camera, switches or size, before the next
    /// question. Costs nothing by itself. The scene must be up to date and valid (THREE::validate), its
    /// matrices too, and stay until the last question.
    void see(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
             const lighting::Switches& switches, int width, int height);

    /// The point of a surface under a pixel's exact centre; none: the background, or no pixel of the picture.
    std::optional<SurfacePoint> point(int x, int y);
    /// What a pixel shows; none outside the picture and before see().
    std::optional<ProbeReport> at(int x, int y);
    /// The equation at a point, seen or not; none where its mesh is not drawn, has no such triangle any more,
    /// or before see().
    std::optional<ProbeReport> at(const SurfacePoint& point);

  private:
    using Reference = lighting::reference::Reference<double>;
    using Surface = lighting::reference::Surface<double>;
    const Reference* reference();
    bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
    ProbeReport report(const Surface& surface);
    void addLights(const Surface& surface, ProbeReport& report);

    const THREE::Scene* scene_ = nullptr;
    const THREE::PerspectiveCamera* camera_ = nullptr;
    lighting::Switches switches_;
    int width_ = 0, height_ = 0;
    std::optional<Reference> reference_;
};

}  // namespace lab
