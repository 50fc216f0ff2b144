// Each mesh and light of a lesson left out in turn: does any view show it?
// SPDX-License-Identifier: MIT
#include "grader/judge/unseen.hpp"

#include "grader/judge/scene_difference.hpp"
#include "three/lights.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace grader {

namespace {

std::vector<THREE::Object3D*> meshesAndLights(THREE::Scene& scene) {
    std::vector<THREE::Object3D*> all;
    scene.traverse([&](THREE::Object3D& object) {
        const bool either =
            dynamic_cast<THREE::Mesh*>(&object) != nullptr || dynamic_cast<THREE::Light*>(&object) != nullptr;
        if (either && object.visible)
            all.push_back(&object);
    });
    return all;
}

// What the scene lacks without something: "directional[0]".
std::vector<std::string> lacking(const THREE::Scene& whole, const THREE::Scene& without) {
    constexpr std::string_view present = ".present";
    std::vector<std::string> objects;
    for (const auto& [name, aspect] : compareScenes(whole, without))
        if (!aspect.right && name.ends_with(present))
            objects.push_back(name.substr(0, name.size() - present.size()));
    return objects;
}

bool asksFor(const StepCheck& step, const std::string& object, const Aspects& aspects) {
    return step.isNew && std::any_of(aspects.begin(), aspects.end(), [&](const auto& aspect) {
               return aspect.first.starts_with(object + ".") && isMeant(step.aspects, aspect.first);
           });
}

// What this frame shows of the objects that are asked for; adds to what other frames showed.
void look(const ExpectedFrame& frame, const std::function<bool(const std::string&)>& isAskedFor,
          std::map<std::string, bool>& seen) {
    const THREE::LoadedScene& whole = frame.scene();
    const auto scene = std::make_shared<THREE::LoadedScene>(
        THREE::ObjectLoader().parse(THREE::toJSON(*whole.scene, whole.camera), "the lesson's scene"));
    for (THREE::Object3D* object : meshesAndLights(*scene->scene)) {
        object->visible = false;
        std::vector<std::string> open = lacking(*whole.scene, *scene->scene);
        std::erase_if(open, [&](const std::string& name) { return !isAskedFor(name) || seen[name]; });
        if (!open.empty()) {
            const ExpectedFrame without(scene, frame.size(), lighting::Switches(), "");
            for (const std::string& name : open)
                seen[name] = !compare(frame, without.pixels()).right();
        }
        object->visible = true;
    }
}

}  // namespace

std::vector<std::string> unseen(const Rubric& rubric, const std::vector<ExpectedFrame>& frames) {
    const THREE::Scene& whole = *frames.front().scene().scene;
    const Aspects aspects = compareScenes(whole, whole);
    const auto isAskedFor = [&](const std::string& object) {
        return std::any_of(rubric.steps.begin(), rubric.steps.end(),
                           [&](const StepCheck& step) { return asksFor(step, object, aspects); });
    };
    std::map<std::string, bool> seen;
    for (const ExpectedFrame& frame : frames)
        look(frame, isAskedFor, seen);
    std::vector<std::string> all;
    for (const StepCheck& step : rubric.steps)
        for (const auto& [object, shown] : seen)
            if (!shown && asksFor(step, object, aspects))
                all.push_back(object + " of step " + step.id);
    return all;
}

}  // namespace grader
