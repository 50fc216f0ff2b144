// The table of what can be moved: terms, switches, views, sliders, camera, and how the window looks.
// SPDX-License-Identifier: MIT
#include "lab/live/session.hpp"

#include "lab/failure.hpp"
#include "lab/live/pin.hpp"
#include "lab/live/values.hpp"
#include "lab/number.hpp"
#include "lab/switches.hpp"
#include "three/geometry_builder.hpp"

#include <algorithm>

namespace lab {

using lighting::Text;

void Session::makeTable() {
    lights_ = lightsOfScene();
    table.clear();
    addSceneControls();
    addMarkControls();
    addTermControls();
    addPictureControls();
    addEvaluationControls();
    addLightControls();
    addMaterialControls();
    addWindowControls();
}

// Where all is, without a place on the panel. The lights that were added come first: the others bring their controls along.
void Session::addSceneControls() {
    table.add({.name = "added lights",
               .kind = WidgetKind::action,
               .help = {"luci aggiunte a mano", "lights added by hand"},
               .get = [this] { return addedKinds(); },
               .set = [this](const std::string& kinds) { setAddedKinds(kinds); },
               .moved = [this] { return !added_.empty(); },
               .reset = [this] { setAddedKinds("none"); }});
    table.add({.name = "camera",
               .kind = WidgetKind::action,
               .help = {"px,py,pz,tx,ty,tz,fov: dove sta, cosa guarda, apertura in gradi",
                        "px,py,pz,tx,ty,tz,fov: where it stands, what it looks at, angle of view in degrees"},
               .get = [this] { return view_.cameraText(); },
               .set = [this](const std::string& value) { view_.setCamera(value); },
               .moved = [this] { return view_.cameraMoved(); },
               .reset = [this] { view_.resetCamera(); }});
    table.add({.name = "time",
               .kind = WidgetKind::action,
               .help = {"il tempo dell'animazione, in secondi", "the animation's time in seconds"},
               .get = [this] { return THREE::numberText(time); },
               .set = [this](const std::string& value) { time = readNumber(value, -1e36, 1e36); },
               .moved = [this] { return time != 0; },
               .reset = [this] { time = 0; }});
    table.add(
        {.name = "jitter",
         .kind = WidgetKind::action,
         .help = {"seme di piccole variazioni, o none", "seed of small changes, or none"},
         .get = [this] { return view_.jitter() ? std::to_string(*view_.jitter()) : std::string("none"); },
         .set =
             [this](const std::string& value) {
                 const auto seed = number<std::uint64_t>(value);
                 if (!seed && value != "none")
                     throw UsageError("expected none or a whole number from 0 on, found '" + value + "'");
                 view_.setJitter(seed);
             },
         .moved = [this] { return view_.jitter().has_value(); },
         .reset = [this] { view_.setJitter({}); }});
    table.addNumber("light cut", "", {"luce tralasciata, codici a 8 bit", "light left out, 8-bit codes"}, 0,
                    255, view_.lightCut, 0);
}

// What was marked by hand, without a place on the panel either.
void Session::addMarkControls() {
    table.add({.name = "pinned point",
               .kind = WidgetKind::action,
               .help = {"il punto fissato: mesh,triangolo,peso,peso,peso, o none",
                        "the pinned point: mesh,triangle,weight,weight,weight, or none"},
               .get = [this] { return pinText(pin, view_.scene()); },
               .set = [this](const std::string& value) { pin = readPin(value, view_.scene()); },
               .moved = [this] { return pin.has_value(); },
               .reset = [this] { pin.reset(); }});
    table.add({.name = "last term",
               .kind = WidgetKind::action,
               .help = {"il termine toccato per ultimo", "the term that was switched last"},
               .get = [this] { return std::string(lighting::info(lastTerm).name); },
               .set =
                   [this](const std::string& value) {
                       for (const lighting::TermInfo& row : lighting::terms())
                           if (value == row.name) {
                               lastTerm = row.term;
                               return;
                           }
                       throw UsageError("expected the name of a term, found '" + value + "'");
                   },
               .moved = [this] { return split == Split::term; },
               .reset = [] {}});
    table.addNumber("divider", "", {"dove sta il divisorio, 0 ... 1", "where the divider stands, 0 ... 1"}, 0,
                    1, divider, 0.5);
    std::vector<ControlChoice> numbers;
    for (std::size_t i = 1; i <= std::max<std::size_t>(lights_.size(), 1); ++i)
        numbers.push_back({std::to_string(i), {}});
    table.addChoice(
        "chosen light", "", {"la luce scelta", "the chosen light"}, std::move(numbers),
        [this] { return chosenLight - 1; }, [this](int i) { chosenLight = i + 1; }, 0);
}

void Session::addTermControls() {
    for (const lighting::TermInfo& row : lighting::terms()) {
        const lighting::Term term = row.term;
        Control control{.name = std::string("term ") + row.name, .group = "terms", .help = row.meaning};
        control.get = [this, term] { return std::string(switches.terms.has(term) ? "on" : "off"); };
        control.set = [this, term](const std::string& value) {
            if (value != "on" && value != "off")
                throw UsageError("expected on or off, found '" + value + "'");
            switches.terms = value == "on" ? switches.terms.with(term) : switches.terms.without(term);
        };
        control.moved = [this, term] { return !switches.terms.has(term); };
        control.reset = [this, term] { switches.terms = switches.terms.with(term); };
        table.add(std::move(control));
    }
}

void Session::addPictureControls() {
    std::vector<ControlChoice> modes;
    for (const lighting::ViewInfo& row : lighting::views())
        modes.push_back({row.name, row.meaning});
    table.addChoice(
        "view", "picture", {"che cosa mostra l'immagine", "what the picture shows"}, std::move(modes),
        [this] { return static_cast<int>(mode); },
        [this](int i) { mode = static_cast<lighting::ViewMode>(i); }, 0);
    std::vector<ControlChoice> which{{"all", {"tutte le luci", "all lights"}}};
    for (std::size_t i = 1; i <= lights_.size(); ++i)
        which.push_back({std::to_string(i), {}});
    table.addChoice(
        "only light", "picture", {"una luce da sola", "one light alone"}, std::move(which),
        [this] { return only; }, [this](int i) { only = i; }, 0);
    table.addChoice(
        "split", "picture", {"prima e dopo", "before and after"},
        {{"off", {"no", "off"}},
         {"term", {"senza l'ultimo termine | con", "without the last term | with it"}},
         {"lesson", {"la lezione prima | questa", "the lesson before | this one"}}},
        [this] { return static_cast<int>(split); }, [this](int i) { split = static_cast<Split>(i); }, 0);
    for (Slider& slider : view_.controls().sliders()) {
        Control& control = table.addNumber("slider " + slider.name, "sliders", slider.label, slider.min,
                                           slider.max, slider.value, slider.own);
        control.step = slider.step();
    }
}

void Session::addEvaluationControls() {
    for (const Switch& row : switchTable()) {
        std::vector<ControlChoice> choices;
        const bool mayBeOwn = row.get(lighting::Switches()) < 0;
        if (mayBeOwn)
            choices.push_back({"own", {"come vuole il materiale", "the material's own"}});
        for (const Choice& choice : row.choices)
            choices.push_back({choice.name, choice.meaning});
        const int first = mayBeOwn ? -1 : 0;
        table.addChoice(
            std::string(row.option).substr(2), "evaluation", row.what, std::move(choices),
            [this, &row, first] { return row.get(switches) - first; },
            [this, &row, first](int i) { row.set(switches, i + first); },
            row.get(lighting::Switches()) - first);
    }
    table.addChoice(
        "renderer", "evaluation", {"chi disegna", "who draws"},
        {{"gl", {"la scheda grafica, float", "the graphics driver, floats"}},
         {"reference", {"il riferimento, double", "the reference, doubles"}}},
        [this] { return static_cast<int>(renderer); },
        [this](int i) { renderer = static_cast<RendererKind>(i); }, 0);
    table.addChoice("decay", "evaluation",
                    {"esponente k di ogni luce posizionale", "exponent k of every point light"},
                    {{"own", {"quello di ogni luce", "each light's own"}},
                     {"0", {}},
                     {"0.5", {}},
                     {"1", {}},
                     {"1.5", {}},
                     {"2", {}}},
                    {}, {}, 0);
    Control& decay = table.all().back();  // any number may be typed, the list is for the key
    decay.get = [this] { return view_.decay ? THREE::numberText(*view_.decay) : std::string("own"); };
    decay.set = [this](const std::string& value) {
        view_.decay = value == "own" ? std::nullopt : std::optional(readNumber(value, 0, 1e36));
    };
    decay.moved = [this] { return view_.decay.has_value(); };
    decay.reset = [this] { view_.decay.reset(); };
}

void Session::addWindowControls() {
    const auto unsaved = [](Control& control) { control.saved = false; };
    if (view_.animated())
        unsaved(table.addToggle("play", "window", {"il movimento", "the movement"}, playing, false));
    unsaved(table.addToggle("follow", "window", {"i numeri sotto il mouse", "the numbers under the mouse"},
                            follow, false));
    unsaved(table.addToggle("helpers", "window",
                            {"le luci, da prendere col mouse", "the lights, to be grabbed"}, helpers, false));
    unsaved(table.addToggle("keys", "window", {"elenco dei tasti", "the list of keys"}, legend, false));
    unsaved(
        table.addToggle("panel", "window", {"i comandi a destra", "the controls at the right"}, panel, true));
    unsaved(table.addToggle("light theme", "window", {"tema chiaro", "light theme"}, lightTheme, false));
    Control& size = table.addNumber("font size", "window", {"grandezza dei caratteri", "size of the text"},
                                    16, 48, fontSize, 16);
    size.step = 2;
    unsaved(size);
    unsaved(table.addChoice(
        "language", "window", {"lingua", "language"},
        {{"it", {"italiano", "italiano"}}, {"en", {"English", "English"}}},
        [this] { return static_cast<int>(language); }, [this](int i) { language = static_cast<Language>(i); },
        static_cast<int>(options_.language)));
}

}  // namespace lab
