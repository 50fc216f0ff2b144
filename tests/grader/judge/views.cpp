// Hidden views from a seed.
// SPDX-License-Identifier: MIT
#include "grader/judge/views.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>

namespace grader {

namespace {

std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4f", x + 0.0);  // no -0.0000
    return buffer;
}

// The library's distributions differ between machines; the engine does not.
double between(std::mt19937_64& engine, double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
}

// A place around what is looked at, and --camera's text for it.
std::string camera(const Rubric& rubric, std::mt19937_64& engine) {
    constexpr double turn = 6.283185307179586;
    const double azimuth = between(engine, rubric.azimuth[0], rubric.azimuth[1]) * turn / 360;
    const double height = between(engine, rubric.height[0], rubric.height[1]) * turn / 360;
    const double distance = between(engine, rubric.distance[0], rubric.distance[1]);
    const auto& at = rubric.lookAt;
    return text(at[0] + distance * std::sin(azimuth) * std::cos(height)) + "," +
           text(at[1] + distance * std::sin(height)) + "," +
           text(at[2] + distance * std::cos(azimuth) * std::cos(height)) + "," + text(at[0]) + "," +
           text(at[1]) + "," + text(at[2]) + "," + text(rubric.fov);
}

std::string nameOf(int number, const Variant& variant, const Rubric& rubric, bool italian) {
    std::string name = (italian ? "vista " : "view ") + std::to_string(number);
    if (&variant != &rubric.variants.front())
        name += ", " + variant.id;
    return name;
}

}  // namespace

std::vector<View> hiddenViews(const Rubric& rubric, std::uint64_t seed, bool italian) {
    std::mt19937_64 engine(seed);
    std::vector<View> views;
    for (int i = 1; i <= rubric.views; ++i) {
        const std::string from = camera(rubric, engine);
        const double time = std::round(between(engine, 0, rubric.seconds) * 1000) / 1000;
        const std::vector<std::string> place{"--camera", from, "--jitter",
                                             std::to_string(engine() % 1'000'000'000)};
        for (const Variant& variant : rubric.variants) {
            View view{nameOf(i, variant, rubric, italian), &variant, place, time};
            view.options.insert(view.options.end(), variant.options.begin(), variant.options.end());
            views.push_back(std::move(view));
        }
    }
    return views;
}

std::vector<View> publicViews(const Rubric& rubric, bool italian) {
    std::vector<View> views;
    for (const Variant& variant : rubric.variants)
        views.push_back({nameOf(1, variant, rubric, italian), &variant, variant.options, 0});
    return views;
}

std::vector<std::string> optionsOf(const View& view, const std::string& lampFile) {
    std::vector<std::string> options = view.options;
    if (view.variant->lamp)
        options.insert(options.end(), {"--state", lampFile});
    return options;
}

std::string lampState(const std::string& lesson, int size) {
    const nlohmann::json state{{"lambert_lab", 1},
                               {"program", lesson},
                               {"size", {size, size}},
                               {"controls", {{"added lights", "directional"}}}};
    return state.dump() + "\n";
}

}  // namespace grader
