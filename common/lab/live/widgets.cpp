// Widgets of each group of controls.
// SPDX-License-Identifier: MIT
#include "lab/live/widgets.hpp"

#include "lab/equation.hpp"
#include "lab/live/keys.hpp"
#include "lab/live/values.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <utility>

namespace lab {

namespace {

using lighting::Text;

struct GroupRow {
    const char* id;
    Text title;
    bool open;
};

// In the order of slide 4: the picture, the lights, the materials, and how it is all evaluated.
const GroupRow groups[] = {
    {"sliders", {"cursori", "sliders"}, true},        {"picture", {"immagine", "picture"}, true},
    {"terms", {"termini", "terms"}, false},           {"lights", {"luci", "lights"}, true},
    {"materials", {"materiali", "materials"}, false}, {"evaluation", {"calcolo", "evaluation"}, false},
    {"window", {"finestra", "window"}, false},
};

Widget widgetOf(const Session& session, const Control& control) {
    Widget widget{.kind = control.kind,
                  .command = control.name,
                  .label = session.say(control.help),
                  .value = control.get()};
    if (control.kind == WidgetKind::number) {
        widget.numbers[0] = readNumber(widget.value, -1e300, 1e300);
    } else if (control.kind == WidgetKind::color) {
        const THREE::Color color = readColor(widget.value);
        widget.numbers = {color.r, color.g, color.b};
    } else if (control.kind == WidgetKind::vector) {
        const THREE::Vector3 v = readVector(widget.value);
        widget.numbers = {v.x, v.y, v.z};
    }
    widget.min = control.min;
    widget.max = control.max;
    widget.step = control.step;
    if (control.kind == WidgetKind::choice)
        for (const ControlChoice& choice : control.choices)
            widget.choices.push_back(
                {choice.name, choice.words.en != nullptr ? session.say(choice.words) : choice.name});
    for (const char* change : {" toggle", " next", " up"})
        if (widget.key.empty())
            widget.key = keyFor(control.name + change);
    widget.help = control.name;
    widget.tone = control.moved() ? Tone::active : Tone::plain;
    return widget;
}

Widget action(const Session& session, const char* command, const Text& label) {
    return {.kind = WidgetKind::action,
            .command = command,
            .label = session.say(label),
            .value = {},
            .key = keyFor(command),
            .help = command};
}

// Lights have a group each, named as the scene names them: the first ones, and the chosen one.
std::vector<WidgetGroup> lightGroups(Session& session) {
    std::vector<WidgetGroup> out;
    constexpr std::size_t shown = 16;
    for (std::size_t i = 0; i < session.lights().size(); ++i) {
        if (i >= shown && static_cast<int>(i) + 1 != session.chosenLight)
            continue;
        const std::string id = "light " + std::to_string(i + 1);
        const THREE::Light& light = *session.lights()[i];
        const std::string kind = dynamic_cast<const THREE::DirectionalLight*>(&light) != nullptr
                                     ? session.say({"direzionale", "directional"})
                                 : dynamic_cast<const THREE::PointLight*>(&light) != nullptr
                                     ? session.say({"posizionale", "point"})
                                     : session.say({"ambiente", "ambient"});
        const bool chosen = static_cast<int>(i) + 1 == session.chosenLight;
        WidgetGroup group{std::string(chosen ? "▸ " : "") + session.say({"luce ", "light "}) +
                              std::to_string(i + 1) + ": " + kind +
                              (light.name.empty() ? "" : " " + light.name),
                          {},
                          i < 3,
                          id};
        for (const Control& control : session.table.all())
            if (control.group == id)
                group.widgets.push_back(widgetOf(session, control));
        if (!group.widgets.empty())
            out.push_back(std::move(group));
    }
    return out;
}

void addActions(Session& session, const std::string& id, std::vector<Widget>& into) {
    if (id == "lights") {
        into.push_back(action(session, "light add point", {"+ luce posizionale", "+ point light"}));
        into.push_back(
            action(session, "light add directional", {"+ luce direzionale", "+ directional light"}));
        into.push_back(
            action(session, "light chosen remove", {"toglie la luce scelta", "takes the chosen light out"}));
    } else if (id == "window") {
        const std::pair<const char*, Text> buttons[] = {
            {"previous", {"lezione prima", "lesson before"}},
            {"next", {"lezione dopo", "lesson after"}},
            {"undo", {"annulla", "undo"}},
            {"redo", {"rifà", "redo"}},
            {"reset", {"come all'inizio", "as at the start"}},
            {"shot", {"immagine e stato", "picture and state"}},
            {"save", {"salva lo stato", "save the state"}},
            {"cost", {"quanto costa una luce", "what a light costs"}},
            {"fullscreen", {"tutto lo schermo", "full screen"}}};
        for (const auto& [command, label] : buttons)
            into.push_back(action(session, command, label));
    }
}

}  // namespace

std::vector<WidgetGroup> widgetGroups(Session& session, const PanelFacts& facts) {
    std::vector<WidgetGroup> out;
    const auto& sliders = session.view().controls().sliders();
    const std::string chosen =
        sliders.empty()
            ? ""
            : "slider " + sliders[static_cast<std::size_t>(std::clamp(facts.chosenSlider, 0,
                                                                      static_cast<int>(sliders.size()) - 1))]
                              .name;
    for (const GroupRow& row : groups) {
        WidgetGroup group{session.say(row.title), {}, row.open, row.id};
        for (const Control& control : session.table.all())
            if (control.group == row.id) {
                group.widgets.push_back(widgetOf(session, control));
                if (control.name == chosen)
                    group.widgets.back().key = "← →";
            }
        addActions(session, row.id, group.widgets);
        if (row.id == std::string("lights")) {
            std::vector<WidgetGroup> lights = lightGroups(session);
            std::move(lights.begin(), lights.end(), std::back_inserter(out));
        }
        if (!group.widgets.empty())
            out.push_back(std::move(group));
    }
    return out;
}

}  // namespace lab
