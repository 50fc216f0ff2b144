// The table of controls as JSON.
// SPDX-License-Identifier: MIT
#include "lab/live/control_json.hpp"

#include "lab/live/keys.hpp"

#include <nlohmann/json.hpp>

namespace lab {

namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(WidgetKind kind) {
    switch (kind) {
    case WidgetKind::toggle:
        return "toggle";
    case WidgetKind::choice:
        return "choice";
    case WidgetKind::number:
        return "number";
    case WidgetKind::color:
        return "color";
    case WidgetKind::vector:
        return "vector";
    case WidgetKind::action:
        break;
    }
    return "text";
}

Json words(const lighting::Text& text) {
    return {{"it", text.it != nullptr ? text.it : ""}, {"en", text.en != nullptr ? text.en : ""}};
}

Json jsonOf(const Control& control) {
    Json json;
    json["name"] = control.name;
    json["kind"] = nameOf(control.kind);
    json["group"] = control.group;
    json["help"] = words(control.help);
    json["value"] = control.get();
    json["own"] = !control.moved();
    json["saved"] = control.saved;
    if (control.kind == WidgetKind::number) {
        json["min"] = control.min;
        json["max"] = control.max;
        json["step"] = control.step;
    }
    for (const ControlChoice& choice : control.choices) {
        Json one = words(choice.words);
        one["name"] = choice.name;
        json["choices"].push_back(std::move(one));
    }
    for (const char* change : {" toggle", " next", " up"})
        if (const std::string key = keyFor(control.name + change); !key.empty())
            json["key"] = key;
    return json;
}

}  // namespace

std::string controlsJson(const ControlTable& table) {
    Json all = Json::array();
    for (const Control& control : table.all())
        all.push_back(jsonOf(control));
    return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace lab
