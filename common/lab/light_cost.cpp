// Draws and times.
// SPDX-License-Identifier: MIT
#include "lab/light_cost.hpp"

#include <algorithm>
#include <chrono>

namespace lab {

double median(std::vector<double> values) {
    if (values.empty())
        return 0;
    std::sort(values.begin(), values.end());
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

double LightCost::each() const { return lights == 0 ? 0 : (median(with) - median(without)) / lights; }

LightCost measureLights(View& view, render::Renderer& renderer, const lighting::Switches& switches,
                        double time, const render::FrameRequest& request, int frames,
                        const std::function<void(int)>& done) {
    using Clock = std::chrono::steady_clock;
    lighting::Switches dark = switches;
    dark.terms = dark.terms.without(lighting::Term::directional).without(lighting::Term::point);
    view.update(time, request.width, request.height);
    const lighting::FramePlan plan = view.plan(switches);
    LightCost cost;
    cost.lights = static_cast<int>(plan.directional.size() + plan.point.size());
    const auto draw = [&](const lighting::Switches& how, std::vector<double>& times) {
        const Clock::time_point start = Clock::now();
        view.update(time, request.width, request.height);
        renderer.renderOnly(view.scene(), view.camera(), view.settings(how), request);
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    };
    // Frame after frame of a kind, as a still window draws them, after one that compiles its shader.
    const auto drawAll = [&](const lighting::Switches& how, std::vector<double>& times) {
        draw(how, times);
        times.clear();
        for (int i = 0; i < frames; ++i) {
            draw(how, times);
            if (done)
                done(static_cast<int>(cost.with.size() + cost.without.size()) / 2);
        }
    };
    drawAll(switches, cost.with);
    drawAll(dark, cost.without);
    return cost;
}

}  // namespace lab
