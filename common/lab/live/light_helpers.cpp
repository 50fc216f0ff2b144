// Squares and octahedra.
// SPDX-License-Identifier: MIT
#include "lab/live/light_helpers.hpp"

#include "three/matrix4.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace lab {

using THREE::Vector3;

namespace {

constexpr double sphereShare = 1.0 / 3;  // of the picture, on either side of the focus
constexpr double wayToTheEye = 0.7;

// Turned as three.js's lookAt turns it: its z axis points at the focus.
void addSquare(LightHelper& helper, const Vector3& focus, double half) {
    const THREE::Matrix4 turned = THREE::Matrix4().lookAt(focus, helper.place, helper.light->up);
    const glm::dvec3 x(turned.elements[0]), y(turned.elements[1]), middle = helper.place;
    const glm::dvec3 corners[] = {middle + (y - x) * half, middle + (x + y) * half, middle + (x - y) * half,
                                  middle - (x + y) * half};
    for (std::size_t i = 0; i < 4; ++i)
        helper.segments.push_back({corners[i], corners[(i + 1) % 4]});
    helper.segments.push_back({helper.place, focus});
}

void addOctahedron(LightHelper& helper, double radius) {
    const glm::dvec3 middle = helper.place;
    const glm::dvec3 round[] = {{radius, 0, 0}, {0, 0, radius}, {-radius, 0, 0}, {0, 0, -radius}};
    for (std::size_t i = 0; i < 4; ++i) {
        helper.segments.push_back({middle + round[i], middle + round[(i + 1) % 4]});
        for (const double pole : {radius, -radius})
            helper.segments.push_back({middle + glm::dvec3(0, pole, 0), middle + round[i]});
    }
}

}  // namespace

double helperRadius(const THREE::PerspectiveCamera& camera, const Vector3& focus) {
    const Projection projection(camera);
    const double height = projection.lengthAt(focus, 1);
    return std::min(sphereShare * height * std::min(1.0, camera.aspect),
                    wayToTheEye * glm::length(glm::dvec3(focus) - projection.eye()));
}

std::vector<LightHelper> lightHelpers(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                                      const Vector3& focus, double size) {
    const Projection projection(camera);
    const double radius = helperRadius(camera, focus);
    std::vector<LightHelper> helpers;
    for (const NumberedLight& numbered : numberedLights(scene)) {
        if (!numbered.visible)
            continue;
        LightHelper helper{numbered.number, numbered.light, {}, {}};
        const auto* const sun = dynamic_cast<const THREE::DirectionalLight*>(numbered.light);
        if (sun != nullptr)
            helper.place = Vector3(focus).add(sun->directionTowardsLight().multiplyScalar(radius));
        else if (dynamic_cast<const THREE::PointLight*>(numbered.light) != nullptr)
            helper.place = numbered.light->matrixWorld.position();
        else
            continue;
        const double half = projection.lengthAt(helper.place, size);
        if (!(half > 0) || (sun != nullptr && !(radius > 0)))
            continue;
        if (sun != nullptr)
            addSquare(helper, focus, half);
        else
            addOctahedron(helper, half);
        helpers.push_back(std::move(helper));
    }
    return helpers;
}

LightMarks lightMarks(const std::vector<LightHelper>& helpers, const THREE::PerspectiveCamera& camera,
                      std::optional<int> chosen, Language language) {
    const Projection projection(camera);
    LightMarks marks;
    for (const LightHelper& helper : helpers) {
        const bool isChosen = helper.number == chosen;
        for (const Segment& segment : helper.segments)
            if (const auto stroke =
                    projection.stroke(segment.from, segment.to, isChosen ? Ink::chosen : Ink::light, false,
                                      isChosen ? 2.5 : 1.5))
                marks.strokes.push_back(*stroke);
        const std::optional<PanelPoint> place = projection.point(helper.place);
        if (!place || !inPicture(*place))
            continue;
        const bool directional = dynamic_cast<const THREE::DirectionalLight*>(helper.light) != nullptr;
        const lighting::Text help =
            directional ? lighting::Text{"luce direzionale: trascina per girarla attorno alla scena",
                                         "directional light: drag to turn it about the scene"}
                        : lighting::Text{"luce posizionale: trascina per spostarla nel piano dello schermo",
                                         "point light: drag to move it in the plane of the screen"};
        marks.handles.push_back(
            {"light " + std::to_string(helper.number), *place,
             lightTitle(helper.number, helper.light->name, language) + "\n" + say(help, language), isChosen});
    }
    return marks;
}

}  // namespace lab
