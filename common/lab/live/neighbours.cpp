// What may come next.
// SPDX-License-Identifier: MIT
#include "lab/live/neighbours.hpp"

#include "lab/switches.hpp"

#include <functional>
#include <vector>

namespace lab {

namespace {

using lighting::FramePlan;
using lighting::Settings;

constexpr std::size_t mostLights = 24, mostObjects = 1000;

class Neighbours {
  public:
    explicit Neighbours(Session& session) : session_(session), now_(session.settings()) {}

    std::optional<FramePlan> plan(std::size_t number) {
        left_ = number;
        withTerms();
        withSwitches();
        withLights();
        withViews();
        return std::move(found_);
    }

  private:
    // The one that is asked for is planned; the others are only counted.
    bool isNext() { return !found_ && left_-- == 0; }

    void offer(const Settings& settings) {
        if (isNext())
            found_ = lighting::planFrame(session_.view().scene(), session_.view().camera(), settings);
    }

    void withTerms() {
        for (const lighting::TermInfo& row : lighting::terms()) {
            Settings settings = now_;
            settings.terms = settings.terms.toggled(row.term);
            offer(settings);
        }
        Settings all = now_;
        all.terms = lighting::TermSet::all();
        offer(all);
    }

    void withSwitches() {
        for (const Switch& row : switchTable()) {
            Settings settings = now_;
            row.next(settings);
            offer(settings);
        }
    }

    // One switched, and one more of each kind.
    void withLights() {
        for (THREE::Light* const light : session_.lights()) {
            light->visible = !light->visible;
            offer(now_);
            light->visible = !light->visible;
        }
        THREE::DirectionalLight sun(0xFFFFFF, 0.5);
        THREE::PointLight bulb(0xFFFFFF, 0.5);
        THREE::AmbientLight sky(0x202020);
        for (THREE::Light* const light : std::initializer_list<THREE::Light*>{&bulb, &sun, &sky}) {
            light->position.set(1, 2, 2);
            session_.view().scene().add(*light);
            light->updateMatrixWorld();
            offer(now_);
            session_.view().scene().remove(*light);
        }
    }

    void withViews() {
        for (const lighting::ViewInfo& row : lighting::views()) {
            Settings settings = now_;
            settings.view = row.view;
            offer(settings);
        }
    }

    Session& session_;
    Settings now_;
    std::size_t left_ = 0;
    std::optional<FramePlan> found_;
};

bool isSmall(const Session& session) {
    std::size_t objects = 0;
    session.view().scene().traverse([&objects](const THREE::Object3D&) { ++objects; });
    return objects <= mostObjects && session.lights().size() <= mostLights;
}

}  // namespace

std::optional<FramePlan> neighbourPlan(Session& session, std::size_t number) {
    return isSmall(session) ? Neighbours(session).plan(number) : std::nullopt;
}

}  // namespace lab
