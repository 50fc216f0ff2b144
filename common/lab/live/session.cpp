// What a session is, and its lights.
// SPDX-License-Identifier: MIT
#include "lab/live/session.hpp"

#include "lab/failure.hpp"
#include "lab/live/state_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

Session::Session(View& view, const Options& options)
    : switches(options.switches), renderer(options.renderer), time(options.time),
      lightTheme(options.lightTheme), fontSize(options.fontSize), language(options.language), view_(view),
      options_(options) {
    makeTable();
    if (!options.state.empty())
        for (const auto& [name, value] : readState(options.state, options.lesson).controls) {
            Control* const control = table.find(name);
            if (control == nullptr || !control->saved)
                throw UsageError(options.state + ": controls: unknown control '" + name + "'; " +
                                 options.lesson + " has no such thing to set");
            try {
                table.give(*control, value);
            } catch (const UsageError& error) {
                throw UsageError(options.state + ": controls: " + error.what());
            }
        }
    start_ = table.state();
}

Session::~Session() { removeAdded(); }

std::vector<THREE::Light*> Session::lightsOfScene() {
    std::vector<THREE::Light*> found;
    view_.scene().traverse([&found](THREE::Object3D& object) {
        if (auto* const light = dynamic_cast<THREE::Light*>(&object))
            found.push_back(light);
    });
    return found;
}

void Session::updateNow() {
    view_.update(time, width_, height_);
    if (lightsOfScene() == lights_)
        return;
    makeTable();  // an animation has added lights, or taken some out
    const int count = static_cast<int>(lights_.size());
    chosenLight = std::clamp(chosenLight, 1, std::max(1, count));
    only = std::min(only, count);
}

std::string Session::addedKinds() const {
    std::string kinds;
    for (const auto& one : added_)
        kinds += (kinds.empty() ? "" : ",") +
                 std::string(one->type()).substr(0, std::string(one->type()).size() - 5);
    std::transform(kinds.begin(), kinds.end(), kinds.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return kinds.empty() ? "none" : kinds;
}

// To the upper right of the picture's middle, somewhat nearer than what is looked at.
THREE::Vector3 Session::placeInView() {
    const Orbit& orbit = view_.orbit();
    const THREE::PerspectiveCamera& camera = view_.camera();
    const double half = orbit.distance() * std::tan(camera.fov * std::numbers::pi / 360) / camera.zoom;
    const glm::dmat4& axes = camera.matrixWorld.elements;
    const auto axis = [&axes](int i) { return THREE::Vector3(glm::dvec3(axes[i])).normalize(); };
    return THREE::Vector3(orbit.target())
        .add(axis(0).multiplyScalar(0.4 * half))
        .add(axis(1).multiplyScalar(0.4 * half))
        .add(axis(2).multiplyScalar(0.25 * orbit.distance()));
}

namespace {

void expectRoom(std::size_t lights) {
    if (lights >= mostControlledLights)
        throw UsageError("light add: found " + std::to_string(lights) + " lights; expected fewer than " +
                         std::to_string(mostControlledLights) + " to add one by hand");
}

std::unique_ptr<THREE::Light> lightOfKind(const std::string& kind) {
    if (kind == "directional")
        return std::make_unique<THREE::DirectionalLight>(0xFFFFFF, 0.5);
    if (kind == "point")
        return std::make_unique<THREE::PointLight>(0xFFFFFF, 0.5);
    if (kind == "ambient")
        return std::make_unique<THREE::AmbientLight>(0x202020);
    throw UsageError("light add: expected directional, point or ambient, found '" + kind + "'");
}

}  // namespace

int Session::addLight(const std::string& kind) {
    expectRoom(lights_.size());
    std::unique_ptr<THREE::Light> made = lightOfKind(kind);
    if (kind == "directional")
        made->position.set(1, 2, 2);
    view_.scene().add(*made);
    if (kind == "point")
        view_.overrides.lights[made.get()].position = placeInView();
    added_.push_back(std::move(made));
    makeTable();
    chosenLight = static_cast<int>(lights_.size());
    return chosenLight;
}

void Session::removeLight(int number) {
    if (number < 1 || number > static_cast<int>(lights_.size()))
        throw UsageError("light " + std::to_string(number) + ": expected a light from 1 to " +
                         std::to_string(lights_.size()));
    const THREE::Light* const which = lights_[static_cast<std::size_t>(number - 1)];
    const auto mine =
        std::find_if(added_.begin(), added_.end(), [which](const auto& one) { return one.get() == which; });
    if (mine == added_.end())
        throw UsageError("light " + std::to_string(number) +
                         " is the lesson's own: switch it off instead (light " + std::to_string(number) +
                         " on off)");
    view_.putBack();
    view_.overrides.lights.erase(mine->get());
    added_.erase(mine);
    only = 0;
    makeTable();
    chosenLight = std::clamp(chosenLight, 1, std::max(1, static_cast<int>(lights_.size())));
}

void Session::removeAdded() {
    view_.putBack();  // which would write into lights that are gone
    for (const auto& light : added_)
        view_.overrides.lights.erase(light.get());
    added_.clear();
}

// All are made anew, once it is known that all can be: else what is there stays.
void Session::setAddedKinds(const std::string& kinds) {
    std::vector<std::string> wanted;
    for (std::size_t begin = 0; kinds != "none" && begin <= kinds.size();) {
        const std::size_t end = std::min(kinds.find(',', begin), kinds.size());
        wanted.push_back(kinds.substr(begin, end - begin));
        lightOfKind(wanted.back());
        expectRoom(lights_.size() - added_.size() + wanted.size() - 1);
        begin = end + 1;
    }
    removeAdded();
    makeTable();
    const int chosen = chosenLight;
    for (const std::string& kind : wanted)
        addLight(kind);
    chosenLight = std::clamp(chosen, 1, std::max(1, static_cast<int>(lights_.size())));
    only = std::min(only, static_cast<int>(lights_.size()));
}

lighting::Settings Session::settings() const {
    lighting::Settings settings = view_.settings(switches);
    settings.view = mode;
    settings.only = only > 0 ? lights_[static_cast<std::size_t>(only - 1)] : nullptr;
    if (settings.only == nullptr && lighting::info(mode).needsLight)
        settings.only = lightOfView();
    return settings;
}

// Views of one light's factors show the chosen one, or one that has such a factor.
const THREE::Light* Session::lightOfView() const {
    const auto serves = [this](const THREE::Light* light) {
        const bool point = dynamic_cast<const THREE::PointLight*>(light) != nullptr;
        return light->visible && (point || (dynamic_cast<const THREE::DirectionalLight*>(light) != nullptr &&
                                            mode != lighting::ViewMode::attenuation));
    };
    const auto chosen = static_cast<std::size_t>(chosenLight) - 1;
    if (chosen < lights_.size() && serves(lights_[chosen]))
        return lights_[chosen];
    const auto first = std::find_if(lights_.begin(), lights_.end(), serves);
    return first == lights_.end() ? nullptr : *first;
}

std::vector<Side> Session::sides(int width, View* before) {
    const lighting::Settings whole = settings();
    if (split == Split::off || (split == Split::lesson && before == nullptr))
        return {{&view_, whole, 0, width}};
    const int middle = static_cast<int>(std::lround(std::clamp(divider, 0.0, 1.0) * width));
    std::vector<Side> sides{{&view_, whole, 0, middle}, {&view_, whole, middle, width}};
    if (split == Split::term) {
        sides[0].settings.terms = switches.terms.without(lastTerm);
        sides[1].settings.terms = switches.terms.with(lastTerm);
    } else {
        sides[0].view = before;
        sides[0].settings = before->settings(switches);
        sides[0].settings.view = mode;
    }
    std::erase_if(sides, [](const Side& side) { return side.firstColumn >= side.endColumn; });
    return sides;
}

void Session::apply(const State& wanted) {
    const State before = table.state();
    try {
        table.apply(wanted);
    } catch (const UsageError&) {
        table.apply(before);
        throw;
    }
}

void Session::reset() {
    playing = false;
    apply(start_);
}

}  // namespace lab
