// What is timed: the lab's frame of a scene, and a hand-written program's frame of the same mesh from the same place.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/probe.hpp"
#include "render/gl_renderer.hpp"
#include "three/three.hpp"

#include <memory>
#include <string>
#include <vector>

namespace bench {

/// A scene of its own with a camera, to which meshes and lights are added.
struct Stage {
    THREE::Scene scene;
    THREE::PerspectiveCamera camera{36};

    /// The camera looks at the origin from `distance` away, a little from above.
    explicit Stage(double distance = 6.2);
    THREE::Mesh& mesh(THREE::BufferGeometry& geometry, THREE::Material& material);
    THREE::PointLight& point(const THREE::Vector3& position, double intensity, double distance, double decay);
    /// The lecture's lights: a directional, a point light with k = 0, an ambient one.
    void lectureLights();
    /// Point lights with k = 2 on a sphere of radius 4 about the origin, the same for the same number; together as bright as 10 / n each.
    void lightsAround(int n);
    /// n point lights with k = 2 that fill the box from -half to half evenly, each reaching `distance`.
    void lightsWithin(int n, const THREE::Vector3& half, double distance);
};

/// The lab's frames of a stage, by a renderer of their own: what it keeps from frame to frame is this scene's. Context and
/// stage must outlive it.
class Ours {
  public:
    Ours(Stage& stage, int width, int height, render::Compile when = render::Compile::atOnce);
    /// A frame as a lesson draws it: matrices, validation, plan, draw, wait.
    void draw();
    /// The same, read back: 8-bit codes.
    image::Frame frame();
    /// Eight frames, fewer of slow ones, so that whatever a renderer decides for what stands still is decided.
    void settle();
    /// How many pixels are not black.
    int covered();
    const Stage& stage() const { return stage_; }
    lighting::Settings settings;
    render::GlRenderer renderer;

  private:
    void update();
    Stage& stage_;
    render::FrameRequest request_;
};

/// All meshes of a stage as a hand-written program draws them, with one fragment shader and its own uniforms.
class Probe {
  public:
    /// Takes geometries, places and camera from the stage as they stand. `fragmentShader` reads `in vec3 n, Q` (world space)
    /// and writes `out vec4 c`; an empty one clears only.
    Probe(Stage& stage, int width, int height, const std::string& fragmentShader);
    ~Probe();
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;
    /// A frame, waited for.
    void draw();
    /// For setting uniforms; in use after construction.
    GLuint program() const { return program_; }
    /// Draws and reads back, as Ours::frame.
    image::Frame frame();

  private:
    struct Placed {
        std::size_t mesh;
        std::vector<float> clip, place, turn;
    };
    probe::Target target_;
    GLuint program_ = 0;
    GLint clip_ = -1, place_ = -1, turn_ = -1;
    std::vector<probe::Mesh> meshes_;
    std::vector<Placed> placed_;
};

/// A fragment shader of one colour: the driver's floor.
extern const char* const flatShader;
/// The lecture's lights as uniforms w, L1, P2, L2, LA under a base colour D: row (c) of the yardsticks.
extern const char* const lectureShader;
/// n point lights with k = 2 in a loop over uniform arrays P, L: row (d).
std::string loopShader(int n);

/// Sets what lectureShader or loopShader reads from the lights of the stage; the base colour is that of its first mesh.
void setLights(const Probe& probe, const Stage& stage);

/// The largest difference of two frames of one size, in codes.
int codesApart(const image::Frame& a, const image::Frame& b);

}  // namespace bench
