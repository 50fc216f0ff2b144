// A lesson-like scene with a session about it and no window: what commands are tried on.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/failure.hpp"
#include "lab/live/commands.hpp"
#include "lab/live/probe_text.hpp"
#include "lab/live/values.hpp"
#include "three/three.hpp"

#include <string>
#include <vector>

namespace support {

/// Keeps what commands asked for.
class FakeHost final : public lab::Host {
  public:
    std::vector<std::string> asked;
    lab::Session* session = nullptr;
    bool isFirst = false;  // of the lessons

    void shot(const std::string& file, int width, int height) override {
        asked.push_back("shot " + file + " " + std::to_string(width) + "x" + std::to_string(height));
    }
    lab::SavedState savedState() override { return {"desk", "", 960, 600, session->state()}; }
    std::string probe(const std::optional<lab::PanelPoint>&) override { return "probe"; }
    void pin(const std::optional<lab::PanelPoint>&) override { asked.emplace_back("pin"); }
    std::string lightCost() override { return "1 ms"; }
    std::string places() override { return "symbol term ambient 1 2\nwidget term ambient 3 4\n"; }
    void fullscreen() override { asked.emplace_back("fullscreen"); }
    void goTo(const std::string& program, const std::vector<std::string>& arguments) override {
        asked.push_back("go " + program + (arguments.empty() ? "" : " " + arguments[0]));
    }
    void expectLessonBefore() override {
        if (isFirst)
            throw lab::UsageError("there is none");
    }
    void leave() override { asked.emplace_back("leave"); }
};

/// The scene of lesson 04 with a box in place of the knot, and a slider.
struct Desk {
    THREE::Scene scene;
    THREE::BoxGeometry box;
    THREE::MeshPhongMaterial material{THREE::Color(0xFF8855)};
    THREE::Mesh mesh{box, material};
    THREE::DirectionalLight sun;
    THREE::PointLight bulb{0xDD6666};
    THREE::AmbientLight sky{0x101010};
    THREE::PerspectiveCamera camera{36};
    lab::Controls sliders;
    const double* strength = nullptr;
    lab::Animation animation;
    lab::Options options;
    std::optional<lab::View> view;
    std::optional<lab::Session> session;
    FakeHost host;
    std::optional<lab::Commands> commands;

    Desk() {
        scene.add(mesh, sun, bulb, sky);
        sun.position.set(0, 3, -2);
        bulb.position.set(2, 1.5, 5);
        camera.position.set(2.2, 2.7, 6.4);
        camera.lookAt(0, 1.2, 0);
        strength = &sliders.add("strength", 1, 0, 5, {"forza", "strength"});
        animation = [this](double t) {
            mesh.rotation.y = t;
            bulb.intensity = *strength;
        };
        options.lesson = "desk";
    }
    /// Begins; options may be changed before.
    Desk& begin() {
        view.emplace(scene, camera, animation, options, sliders);
        session.emplace(*view, options);
        host.session = &*session;
        commands.emplace(*session, host, "desk");
        view->update(0, 96, 60);
        return *this;
    }
    /// A command, and the scene brought up to it.
    std::string say(const std::string& line, bool byHand = false) {
        const std::string answer = commands->run(line, {byHand});
        view->update(session->time, 96, 60);
        return answer;
    }
};

}  // namespace support
