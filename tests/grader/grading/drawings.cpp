// Command lines of the lab's programs.
// SPDX-License-Identifier: MIT
#include "grader/grading/drawings.hpp"

#include "three/validate.hpp"

#include <cstdio>
#include <stdexcept>

namespace grader {

namespace {

constexpr const char* lampFile = "lamp.json";

std::vector<std::string> optionsOf(const View& view) {
    std::vector<std::string> options = view.options;
    if (view.variant->lamp)
        options.insert(options.end(), {"--state", std::string("in/") + lampFile});
    return options;
}

}  // namespace

Drawing drawingOf(const Rubric& rubric, std::string program,
                  const std::map<std::string, std::string>& shaders) {
    Drawing drawing;
    drawing.program = std::move(program);
    drawing.shaders = shaders;
    drawing.files = {{lampFile, lampState(rubric.lesson, rubric.size)}};
    drawing.width = drawing.height = rubric.size;
    return drawing;
}

std::map<std::string, std::string> shadersToTryIn(std::map<std::string, std::string> lab) {
    std::string& text = lab["terms/point.glsl"];
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>("max(cosine_divisor(d2) * power, 1e-30)",
                                              "max(cosine_divisor(d2), 1e-30)"),
          {"clamp_cosine(share) * D", "f * clamp_cosine(share) * D"}}) {
        const std::size_t at = text.find(from);
        if (at == std::string::npos)
            throw std::runtime_error("terms/point.glsl: expected '" + from +
                                     "' in it; shadersToTryIn must follow it");
        text.replace(at, from.size(), to);
    }
    return lab;
}

std::string lineOf(const View& view) {
    char time[32];
    std::snprintf(time, sizeof time, "%.17g", view.time);
    std::string line = std::string("--time ") + time;
    for (const std::string& option : optionsOf(view))
        line += " " + option;
    return line;
}

Dump dumpAt(const Confinement& confinement, const Kit& kit, Drawing drawing, const View& view, int slot) {
    drawing.words = optionsOf(view);
    const std::string size = std::to_string(drawing.width) + "x" + std::to_string(drawing.height);
    drawing.words.insert(drawing.words.end(), {"--size", size});
    return dumpScene(confinement, kit, drawing, view.time, slot);
}

std::shared_ptr<const THREE::LoadedScene> loadScene(const std::string& json) {
    auto scene = std::make_shared<THREE::LoadedScene>(THREE::ObjectLoader().parse(json, "scene"));
    if (scene->camera == nullptr)
        throw std::runtime_error("the scene has no camera");
    scene->scene->updateMatrixWorld();
    THREE::validate(*scene->scene, *scene->camera);
    return scene;
}

}  // namespace grader
