// The mouse on the picture.
// SPDX-License-Identifier: MIT
#include "lab/live/gestures.hpp"

#include "lab/live/values.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace lab {

void Gestures::moveCamera(const Event& event) {
    const State before = session_.state();
    Orbit& orbit = session_.view().orbit();
    if (event.kind == Event::Kind::wheel) {
        orbit.zoom(event.dy);
        return commands_.changed(before, "wheel");
    }
    const bool pans = event.kind == Event::Kind::pan;
    const Clock::time_point now = Clock::now();
    const double passed =
        std::max(std::chrono::duration<double>(now - std::exchange(last_, now)).count(), 1e-3);
    fling_ = Fling{event.dx / passed, event.dy / passed, pans};
    coasting_ = false;
    pans ? orbit.pan(event.dx, event.dy) : orbit.rotate(event.dx, event.dy);
    commands_.changed(before, "orbit");
}

void Gestures::release() {
    commands_.endGesture();
    drag_.reset();
    constexpr std::chrono::milliseconds heldStill{60};
    if (fling_ && Clock::now() - last_ < heldStill) {
        session_.view().orbit().fling(fling_->dx, fling_->dy, fling_->pans);
        coasting_ = true;
    }
    fling_.reset();
}

bool Gestures::coast(double seconds) {
    coasting_ = coasting_ && session_.view().orbit().coast(seconds);
    return coasting_;
}

std::string Gestures::moveLight(const Event& event) {
    const auto& lights = session_.lights();
    const std::size_t digits = std::min(event.text.find(' '), event.text.size() - 1) + 1;  // "light 2"
    std::size_t number = 0;
    std::from_chars(event.text.data() + digits, event.text.data() + event.text.size(), number);
    if (number < 1 || number > lights.size())
        return {};
    THREE::Light& light = *lights[number - 1];
    if (!drag_ || dragged_ != &light)
        drag_.emplace(light, session_.view().camera(), std::as_const(session_).view().orbit().target());
    dragged_ = &light;
    session_.chosenLight = static_cast<int>(number);
    const THREE::Vector3 before = light.position;
    if (!drag_->to({event.x, event.y}))
        return {};
    const THREE::Vector3 there =
        std::exchange(light.position, before);  // the command moves it, so that it can be undone and saved
    const bool directional = dynamic_cast<THREE::DirectionalLight*>(&light) != nullptr;
    return "light " + std::to_string(number) + (directional ? " direction " : " position ") +
           vectorText(there);
}

}  // namespace lab
