// View: a lesson's scene as the command line wants it seen, ready to be planned for any time.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/app.hpp"
#include "lab/controls.hpp"
#include "lab/jitter.hpp"
#include "lab/live/overrides.hpp"
#include "lab/options.hpp"
#include "lab/orbit.hpp"
#include "lighting/frame_plan.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace lab {

/// Scene, camera and animation of one program, with --camera, --jitter, --decay and --no-skip applied. When it goes, camera,
/// jitter and exponents are as it found them; an animation puts everything else right itself, being a function of the time.
class View {
  public:
    /// `middle` is worldBounds' centre before any animation moved the scene; without one, as the scene is now.
    View(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const Animation& animation,
         const Options& options, Controls& controls, const std::optional<THREE::Vector3>& middle = {});
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    /// Moves everything to `time` (seconds) and to the sliders, takes the readings, fits the camera to the picture's size and checks the scene.
    /// Throws THREE::SceneError.
    void update(double time, int width, int height);
    /// Takes off what update() has put on the scene: jitter, overrides, `decay`. To be called before a light is taken out of it.
    void putBack();
    /// The plan of what update() made, with these switches.
    lighting::FramePlan plan(const lighting::Switches& switches) const;
    /// What plan() plans with.
    lighting::Settings settings(const lighting::Switches& switches) const;

    const THREE::Scene& scene() const { return scene_; }
    THREE::Scene& scene() { return scene_; }
    Controls& controls() { return controls_; }
    const Controls& controls() const { return controls_; }
    const THREE::PerspectiveCamera& camera() const { return camera_; }
    bool animated() const { return animation_ != nullptr; }
    /// The exponent of every point light from the next update on, or none: each light's own.
    std::optional<double> decay;
    /// What was given to lights and materials by hand; put on by the next update.
    Overrides overrides;
    double lightCut;  ///< --light-cut, 8-bit codes
    /// For the mouse. Jitter is taken back first, so that a drag is not lost with it.
    Orbit& orbit() {
        jitter_.undo();
        return orbit_;
    }
    const Orbit& orbit() const { return orbit_; }

    /// --jitter's seed, or none; from the next update on.
    const std::optional<std::uint64_t>& jitter() const { return seed_; }
    void setJitter(std::optional<std::uint64_t> seed);

    /// "px,py,pz,tx,ty,tz,fov" of the camera without jitter: what setCamera() reads, to the same bits.
    std::string cameraText();
    /// As --camera, with the same errors (UsageError).
    void setCamera(const std::string& text);
    /// Whether it is not where the program put it.
    bool cameraMoved();
    void resetCamera();

  private:
    struct Start {  // the camera, as it was found
        explicit Start(const THREE::PerspectiveCamera& camera);
        void putBack(THREE::PerspectiveCamera& camera) const;
        THREE::Vector3 position;
        THREE::Quaternion quaternion;
        THREE::Euler rotation;
        double fov, aspect;
    };
    void moveTo(const CameraOption& wanted);

    THREE::Scene& scene_;
    THREE::PerspectiveCamera& camera_;
    const Animation& animation_;
    const Options& options_;
    Controls& controls_;
    Start start_;
    THREE::Vector3 ownTarget_;  // what the camera orbits unless --camera says so
    Orbit orbit_;
    std::optional<std::uint64_t> seed_;
    Jitter jitter_;
    std::vector<std::pair<THREE::PointLight*, double>> ownDecays_;  // of the lights that `decay` overrides
};

/// A sphere around everything that is drawn, in world space; radius 0 if there is nothing. Matrices must be up to date.
THREE::Sphere worldBounds(const THREE::Scene& scene);

/// Puts the camera where the whole scene is in view, from above its right front, and sets near and far to it.
void bringIntoView(THREE::PerspectiveCamera& camera, const THREE::Scene& scene);

}  // namespace lab
