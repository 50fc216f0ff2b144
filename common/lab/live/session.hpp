// Session: a lesson while it is shown, with everything that can be moved about it. Knows no window: the same session draws
// in a window and, from a state file, without one.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/control.hpp"
#include "lab/live/probe.hpp"
#include "lab/view.hpp"
#include "lighting/views.hpp"

#include <memory>
#include <string>
#include <vector>

namespace lab {

/// Of more lights than this, those that come later have no controls; nor can more be added by hand.
inline constexpr std::size_t mostControlledLights = 256;

/// What stands left of the divider; on its right is the picture as it is.
enum class Split {
    off,
    term,  ///< the same without the term that was switched last; on the right it is on
    lesson  ///< the lesson before this one, in the slides' order
};

/// One side of the picture: what is drawn from a column on, up to another.
struct Side {
    View* view;
    lighting::Settings settings;
    int firstColumn, endColumn;
};

class Session {
  public:
    /// A session as the command line wants it. Throws UsageError where its --state cannot be had.
    Session(View& view, const Options& options);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    ControlTable table;
    lighting::Switches switches;
    lighting::ViewMode mode = lighting::ViewMode::final;
    RendererKind renderer;
    double time;  ///< seconds
    int only = 0;  ///< the number of the light that shines alone; 0: all do
    Split split = Split::off;
    double divider = 0.5;  ///< where it stands, as a share of the width
    lighting::Term lastTerm = lighting::Term::ambient;  ///< that was switched
    int chosenLight = 1;  ///< the one that keys, arrows and curves are about
    std::optional<SurfacePoint> pin;  ///< of the probe

    bool playing = false;  ///< the animation runs
    bool follow = false;  ///< the probe follows the mouse
    bool helpers = false;  ///< lights are shown, and can be grabbed
    bool legend = false;  ///< keys and what was left out are shown
    bool panel = true;  ///< the controls are shown
    bool lightTheme = false;  ///< the theme for weak projectors
    double fontSize = 16;
    Language language;

    View& view() { return view_; }
    const View& view() const { return view_; }
    /// Directional, point and ambient lights in the order of the scene; the first has number 1.
    const std::vector<THREE::Light*>& lights() const { return lights_; }
    /// Adds "directional", "point" or "ambient" and returns its number.
    int addLight(const std::string& kind);
    /// Takes out a light that was added. Throws UsageError for the lesson's own.
    void removeLight(int number);

    /// All settings of the picture but for its sides.
    lighting::Settings settings() const;
    /// The picture's sides for this width in pixels: one, or two. `before`: the view of the lesson before this one, if there is one now.
    std::vector<Side> sides(int width, View* before);
    /// Moves scene and camera to the time, for a picture of this size. Throws THREE::SceneError.
    void update(int width, int height) {
        width_ = width;
        height_ = height;
        updateNow();
    }
    /// The same for the size before.
    void updateNow();

    State state() const { return table.state(); }
    /// Makes it so. Throws UsageError; then everything is as it was.
    void apply(const State& state);
    /// Back to how it started.
    void reset();
    const char* say(const lighting::Text& text) const { return lab::say(text, language); }

  private:
    void makeTable();
    void addPictureControls();
    void addEvaluationControls();
    void addLightControls();
    void addControlsOf(THREE::Light& light, int number);
    void addMaterialControls();
    void addWindowControls();
    void addSceneControls();
    void addMarkControls();
    void addTermControls();
    std::vector<THREE::Light*> lightsOfScene();
    const THREE::Light* lightOfView() const;
    THREE::Vector3 placeInView();
    std::string addedKinds() const;
    void setAddedKinds(const std::string& kinds);
    void removeAdded();

    View& view_;
    const Options& options_;
    State start_;
    int width_ = 512, height_ = 512;
    std::vector<THREE::Light*> lights_;
    std::vector<std::unique_ptr<THREE::Light>> added_;
};

}  // namespace lab
