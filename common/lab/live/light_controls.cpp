// The table of what can be moved: lights and materials.
// SPDX-License-Identifier: MIT
#include "lab/live/session.hpp"

#include "lab/failure.hpp"
#include "lab/live/values.hpp"
#include "three/geometry_builder.hpp"
#include "three/validate.hpp"

#include <algorithm>

namespace lab {

using THREE::Color;
using THREE::Vector3;

namespace {

constexpr std::size_t mostMaterials = 16;  // more are no panel, and can be written into the scene
constexpr double largest = 1e36;

// A control of a value that may be given to an object in place of its own, `now`.
// `find` gives the place of the value; it makes one if there is none, and that is no harm.
template <class T, class Find, class ToText, class Read>
Control given(const std::string& name, WidgetKind kind, const std::string& group, lighting::Text help,
              const Find& find, const T& now, const ToText& text, const Read& read) {
    return {.name = name,
            .kind = kind,
            .group = group,
            .help = help,
            .get = [find, &now, text] { return find() ? text(*find()) : text(now); },
            .set = [find, read](const std::string& value) { find() = read(value); },
            .moved = [find] { return find().has_value(); },
            .reset = [find] { find().reset(); }};
}

double readIntensity(const std::string& text) { return readNumber(text, 0, largest); }

Control number(Control control, double max, double step) {
    control.max = max;
    control.step = step;
    return control;
}

std::string onOff(bool on) { return on ? "on" : "off"; }

bool readOnOff(const std::string& text) {
    if (text != "on" && text != "off")
        throw UsageError("expected on or off, found '" + text + "'");
    return text == "on";
}

Vector3 readDirection(const std::string& text) {
    const Vector3 v = readVector(text);
    if (!(v.length() > 0))
        throw UsageError("expected a direction that is not 0,0,0; found '" + text + "'");
    return v;
}

}  // namespace

void Session::addLightControls() {
    for (std::size_t i = 0; i < std::min(lights_.size(), mostControlledLights); ++i)
        addControlsOf(*lights_[i], static_cast<int>(i) + 1);
}

void Session::addControlsOf(THREE::Light& one, int number) {
    const std::string name = "light " + std::to_string(number), group = name;
    const auto override = [this, &one]() -> LightOverride& { return view_.overrides.lights[&one]; };
    table.add(given<bool>(
        name + " on", WidgetKind::toggle, group,
        {"accesa", "on"}, [override]() -> auto& { return override().on; }, one.visible, onOff, readOnOff));
    table.add(given<Color>(
        name + " color", WidgetKind::color, group,
        {"colore di L", "colour of L"}, [override]() -> auto& { return override().color; }, one.color,
        colorText, readColor));
    table.add(
        lab::number(given<double>(
                        name + " intensity", WidgetKind::number, group,
                        {"intensità", "intensity"}, [override]() -> auto& { return override().intensity; },
                        one.intensity, THREE::numberText, readIntensity),
                    std::max(2.0, 4 * one.intensity), 0.05));
    const auto place = [override]() -> auto& { return override().position; };
    if (dynamic_cast<THREE::DirectionalLight*>(&one) != nullptr) {
        table.add(given<Vector3>(name + " direction", WidgetKind::vector, group,
                                 {"direzione ω", "direction ω"}, place, one.position, vectorText,
                                 readDirection));
    } else if (auto* const point = dynamic_cast<THREE::PointLight*>(&one)) {
        table.add(given<Vector3>(name + " position", WidgetKind::vector, group,
                                 {"posizione P_L", "position P_L"}, place, one.position, vectorText,
                                 readVector));
        table.add(
            lab::number(given<double>(
                            name + " decay", WidgetKind::number, group,
                            {"esponente k", "exponent k"}, [override]() -> auto& { return override().decay; },
                            point->decay, THREE::numberText, readIntensity),
                        4, 0.1));
    }
}

void Session::addMaterialControls() {
    std::vector<THREE::Material*> materials;
    std::vector<std::string> names;
    view_.scene().traverse([&](THREE::Object3D& object) {
        const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object);
        if (mesh == nullptr || !mesh->material || materials.size() >= mostMaterials ||
            std::find(materials.begin(), materials.end(), mesh->material.get()) != materials.end())
            return;
        materials.push_back(mesh->material.get());
    });
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const std::string name = "material " + std::to_string(i + 1);
        THREE::Material& one = *materials[i];
        const auto override = [this, &one]() -> MaterialOverride& { return view_.overrides.materials[&one]; };
        table.add(given<Color>(
            name + " color", WidgetKind::color, "materials",
            {"colore base D", "base colour D"}, [override]() -> auto& { return override().color; }, one.color,
            colorText, readColor));
        auto* const phong = dynamic_cast<THREE::MeshPhongMaterial*>(&one);
        if (phong == nullptr)
            continue;
        table.add(given<Color>(
            name + " specular", WidgetKind::color, "materials",
            {"colore del riflesso K_S", "colour of the highlight K_S"},
            [override]() -> auto& { return override().specular; }, phong->specular, colorText, readColor));
        table.add(lab::number(
            given<double>(
                name + " shininess", WidgetKind::number, "materials",
                {"lucidità s", "shininess s"}, [override]() -> auto& { return override().shininess; },
                phong->shininess, THREE::numberText, readIntensity),
            200, 1));
    }
}

}  // namespace lab
