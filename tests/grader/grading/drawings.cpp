// Command lines of the lab's programs.
// SPDX-License-Identifier: MIT
#include "grader/grading/drawings.hpp"

#include "three/validate.hpp"

#include <cstdio>
#include <stdexcept>

namespace grader {

namespace {

constexpr const char* lampFile = "lamp.json";
const std::string lampInside = std::string("in/") + lampFile;

// 4 MB of JSON can ask for 30,000 knots of 5 million vertices; the grader draws them outside all walls. Lessons have a few.
void refuseHuge(const THREE::Scene& scene) {
    constexpr std::size_t mostVertices = 2'000'000, mostObjects = 2000;
    std::size_t vertices = 0, objects = 0;
    scene.traverse([&](const THREE::Object3D& object) {
        ++objects;
        const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object);
        const auto* positions =
            mesh == nullptr || !mesh->geometry ? nullptr : mesh->geometry->getAttribute("position");
        vertices += positions == nullptr ? 0 : positions->count();
    });
    if (objects > mostObjects || vertices > mostVertices)
        throw std::runtime_error(
            "the scene is too large: expected at most 2000 objects and 2000000 vertices, found " +
            std::to_string(objects) + " and " + std::to_string(vertices));
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
    for (const std::string& option : optionsOf(view, lampInside))
        line += " " + option;
    return line;
}

Dump dumpAt(const Confinement& confinement, const Kit& kit, Drawing drawing, const View& view) {
    drawing.words = optionsOf(view, lampInside);
    const std::string size = std::to_string(drawing.width) + "x" + std::to_string(drawing.height);
    drawing.words.insert(drawing.words.end(), {"--size", size});
    return dumpScene(confinement, kit, drawing, view.time);
}

std::shared_ptr<const THREE::LoadedScene> loadScene(const std::string& json) {
    auto scene = std::make_shared<THREE::LoadedScene>(THREE::ObjectLoader().parse(json, "scene"));
    if (scene->camera == nullptr)
        throw std::runtime_error("the scene has no camera");
    refuseHuge(*scene->scene);
    scene->scene->updateMatrixWorld();
    THREE::validate(*scene->scene, *scene->camera);
    return scene;
}

}  // namespace grader
