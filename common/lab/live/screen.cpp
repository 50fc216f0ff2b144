// The picture in the window.
// SPDX-License-Identifier: MIT
#include "lab/live/screen.hpp"

#include "image/write.hpp"
#include "lab/controls.hpp"
#include "lab/light_cost.hpp"
#include "lab/live/neighbours.hpp"
#include "lab/live/picture.hpp"
#include "render/error.hpp"
#include "render/shader_source.hpp"
#include "three/validate.hpp"

#include <filesystem>
#include <utility>

namespace lab {

namespace fs = std::filesystem;

Screen::Screen(const Options& options, Window& window)
    : shaders_(options.shaders), program_(options.lesson), window_(window),
      gl_(render::findShaderDirectory(options.shaders), render::Compile::aside), aside_([this] {
          evaluated_ = true;
          window_.wake();
      }) {
    gl_.onCompiled([this] {
        compiled_ = true;
        window_.wake();
    });
}

bool Screen::size(int& width, int& height) const {
    int w = 0, h = 0;
    window_.framebufferSize(w, h);
    if (w < 1 || h < 1)
        return false;
    width = w;
    height = h;
    return true;
}

bool Screen::draw(Session& session, View* before, bool changed) {
    int width = 0, height = 0;
    if (!size(width, height))
        return false;
    if (changed || width != width_ || height != height_) {
        width_ = width;
        height_ = height;
        prepared_ = 0;
        bringUp(session);
        follow(session, before, width, height);
        const std::vector<Side> sides = session.sides(width, before);
        drawByDriver(sides);
        differs_ = session.mode == lighting::ViewMode::difference;
        evaluatedSides_.clear();
        difference_.reset();
        asked_.clear();
        aside_.cancel();
        if (differs_ || session.renderer == RendererKind::reference) {
            asked_ = sides;
            askReference();
        }
    }
    evaluated_ = false;
    takeReference();
    gl_.showPicture();
    return true;
}

// Where nothing can be drawn any more, as by a camera that was dragged too far, everything is again as it was drawn last.
void Screen::bringUp(Session& session) {
    State now = session.state();
    try {
        session.update(width_, height_);
        drawnState_ = std::move(now);
    } catch (const THREE::SceneError&) {
        if (!drawnState_)
            throw;
        session.playing = false;
        session.apply(*drawnState_);
        session.update(width_, height_);
    }
}

void Screen::drawByDriver(std::span<const Side> sides) {
    std::vector<lighting::FramePlan> plans;
    std::vector<render::Part> parts;
    plans.reserve(sides.size());
    for (const Side& side : sides) {
        plans.push_back(lighting::planFrame(side.view->scene(), side.view->camera(), side.settings));
        parts.push_back({&plans.back(), &side.settings, side.firstColumn, side.endColumn});
    }
    compiled_ = false;
    byDriver_ = true;
    drawn_.skipped.clear();  // objects that may be gone by now
    try {
        waiting_ = !gl_.drawPicture(parts, width_, height_);
        problem_.reset();
        if (!waiting_)
            drawn_ = gl_.stats();
    } catch (const render::ShaderError& error) {
        waiting_ = false;
        problem_ = error.what();
    }
}

void Screen::askReference() {
    const Side& side = asked_[evaluatedSides_.size()];
    aside_.ask(side.view->scene(), side.view->camera(), side.settings, {width_, height_});
}

// Once all sides are there, they are the picture.
void Screen::takeReference() {
    if (asked_.empty())
        return;
    std::optional<image::Frame> frame = aside_.take();
    if (!frame)
        return;
    evaluatedSides_.push_back(std::move(*frame));
    if (evaluatedSides_.size() < asked_.size())
        return askReference();
    image::Frame whole = std::move(evaluatedSides_[0]);
    if (asked_.size() == 2)
        whole = render::sideBySide(whole, evaluatedSides_[1], asked_[1].firstColumn);
    if (differs_) {
        difference_ = render::differenceView(drawSides(asked_, gl_, {width_, height_}), whole);
        whole = difference_->frame;
    }
    gl_.setPicture(whole);
    byDriver_ = false;
    asked_.clear();
}

std::optional<std::array<std::uint8_t, 3>> Screen::pixel(const Session& session, int x, int y) {
    const bool isP = session.mode == lighting::ViewMode::final && session.only == 0;
    if (!isP || waiting_ || !byDriver_ || problem_ || x < 0 || y < 0 || x >= width_ || y >= height_)
        return std::nullopt;
    return gl_.pixel(x, y);
}

Screen::News Screen::news() {
    if (waiting_ && compiled_)
        return News::picture;
    return evaluated_ ? News::panel : News::none;
}

bool Screen::prepare(Session& session) {
    if (waiting_ || width_ == 0)
        return false;
    const std::optional<lighting::FramePlan> plan = neighbourPlan(session, prepared_);
    if (!plan)
        return false;
    ++prepared_;
    gl_.prepare(*plan);
    return true;
}

std::vector<std::string> Screen::shaderFolders() const {
    std::vector<std::string> folders;
    for (const std::string& folder : {render::findShaderDirectory(""), shaders_})
        if (!folder.empty()) {
            folders.push_back(folder);
            folders.push_back(folder + "/terms");
        }
    return folders;
}

std::optional<std::string> Screen::reload(const std::string& file) {
    const std::string extension = fs::path(file).extension().string();
    if (extension != ".glsl" && extension != ".vert" && extension != ".frag")
        return std::nullopt;
    std::string wrong;
    if (gl_.reload(wrong))
        problem_.reset();
    else
        problem_ = wrong;
    return wrong;
}

void Screen::write(Session& session, View* before, const std::string& file, int width, int height) {
    render::Renderer& renderer =
        session.renderer == RendererKind::gl ? static_cast<render::Renderer&>(gl_) : reference_;
    writePicture(session, before, renderer, reference_, file, {width, height, wantsFloats(file)}, program_);
}

std::string Screen::lightCost(Session& session) {
    int width = 960, height = 600;
    size(width, height);
    const bool byDriver = session.renderer == RendererKind::gl;
    render::Renderer& renderer = byDriver ? static_cast<render::Renderer&>(gl_) : reference_;
    const LightCost cost = measureLights(session.view(), renderer, session.switches, session.time,
                                         {width, height}, byDriver ? 7 : 1);
    return std::to_string(cost.lights) + session.say({" luci: ", " lights: "}) +
           valueText(median(cost.with)) + session.say({" ms; senza: ", " ms; without: "}) +
           valueText(median(cost.without)) + session.say({" ms; ogni luce: ", " ms; each light: "}) +
           valueText(cost.each()) + " ms";
}

std::optional<PanelLegend> Screen::legend(const Session& session) const {
    if (!differs_ && session.renderer == RendererKind::gl)
        return std::nullopt;
    if (!asked_.empty())
        return PanelLegend{session.say({"il riferimento: ", "the reference: "}) +
                               std::to_string(static_cast<int>(100 * aside_.share())) + " %",
                           {}};
    if (!differs_ || !difference_)
        return std::nullopt;
    PanelLegend legend{std::string(session.say({"differenza dal riferimento, codici; la maggiore: ",
                                                "difference to the reference, codes; the largest: "})) +
                           std::to_string(difference_->largest) + " (" + std::to_string(difference_->x) +
                           ", " + std::to_string(difference_->y) + "); " +
                           valueText(100 * difference_->share) +
                           session.say({" % dei pixel", " % of the pixels"}),
                       {}};
    for (const lighting::LegendEntry& entry : lighting::legend(lighting::ViewMode::difference))
        legend.entries.push_back({{entry.color.x, entry.color.y, entry.color.z},
                                  entry.text.en != nullptr ? session.say(entry.text)
                                  : entry.value            ? valueText(*entry.value)
                                                           : std::string()});
    return legend;
}

}  // namespace lab
