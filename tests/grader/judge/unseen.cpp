// Each mesh and light of a lesson left out in turn: does any view show it?
// SPDX-License-Identifier: MIT
#include "grader/judge/unseen.hpp"

#include "grader/judge/scene_difference.hpp"
#include "three/lights.hpp"

#include <algorithm>
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

// Whether each object of the scene is seen in this frame; adds to what other frames showed.
void look(const ExpectedFrame& frame, std::map<std::string, bool>& seen) {
    const auto scene = std::make_shared<THREE::LoadedScene>(THREE::ObjectLoader().parse(
        THREE::toJSON(*frame.scene().scene, frame.scene().camera), "the lesson's scene"));
    for (THREE::Object3D* object : meshesAndLights(*scene->scene)) {
        object->visible = false;
        const std::vector<std::string> objects = lacking(*frame.scene().scene, *scene->scene);
        const bool news =
            std::any_of(objects.begin(), objects.end(), [&](const std::string& name) { return !seen[name]; });
        if (news) {
            const ExpectedFrame without(scene, frame.size(), lighting::Switches(), "");
            const bool shows = !compare(frame, without.pixels()).right();
            for (const std::string& name : objects)
                seen[name] = seen[name] || shows;
        }
        object->visible = true;
    }
}

}  // namespace

std::vector<std::string> unseen(const Rubric& rubric, const std::vector<ExpectedFrame>& frames) {
    std::map<std::string, bool> seen;
    for (const ExpectedFrame& frame : frames)
        look(frame, seen);
    std::vector<std::string> all;
    const Aspects aspects = compareScenes(*frames.front().scene().scene, *frames.front().scene().scene);
    const auto asksFor = [&](const StepCheck& step, const std::string& object) {
        return std::any_of(aspects.begin(), aspects.end(), [&](const auto& aspect) {
            return aspect.first.starts_with(object + ".") && isMeant(step.aspects, aspect.first);
        });
    };
    for (const StepCheck& step : rubric.steps)
        for (const auto& [object, shown] : seen)
            if (step.isNew && !shown && asksFor(step, object))
                all.push_back(object + " of step " + step.id);
    return all;
}

}  // namespace grader
