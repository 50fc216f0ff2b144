// What each command does that is no control's value.
// SPDX-License-Identifier: MIT
#include "image/write.hpp"
#include "lab/failure.hpp"
#include "lab/live/command_words.hpp"
#include "lab/live/commands.hpp"
#include "lab/live/control_json.hpp"
#include "lab/live/programs.hpp"
#include "lab/live/state_file.hpp"
#include "lab/live/values.hpp"

#include <algorithm>
#include <utility>

namespace lab {

std::string Commands::withTerms(Words words) {
    try {
        session_.switches.terms =
            lighting::parseTerms(expectOne(words, "all, none, names, or changes"), session_.switches.terms);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    return "ok terms " + session_.switches.terms.text();
}

std::string Commands::withLight(Words words) {
    if (words.size() == 2 && words[0] == "add")
        return "ok light " + std::to_string(session_.addLight(words[1]));
    if (words.size() == 2 && words[1] == "remove") {
        const int which =
            words[0] == "chosen" ? session_.chosenLight : static_cast<int>(readNumber(words[0], 1, 4096));
        session_.removeLight(which);
        return "ok light " + std::to_string(which) + " removed";
    }
    if (words.size() > 1 && words[0] == "chosen") {
        std::vector<std::string> named(words.begin(), words.end());
        named[0] = std::to_string(session_.chosenLight);
        named.insert(named.begin(), "light");
        if (const std::optional<std::string> answer = control(named))
            return *answer;
    }
    throw UsageError("expected add KIND, N remove, or a light's number and what to set; found '" +
                     joined(words) + "'");
}

std::string Commands::withSlider(Words words) {
    const std::deque<Slider>& sliders = std::as_const(session_).view().controls().sliders();
    if (sliders.empty())
        throw UsageError("this program has no sliders");
    const auto count = static_cast<int>(sliders.size());
    slider_ = std::clamp(slider_, 0, count - 1);
    if (words.size() == 1 && (words[0] == "next" || words[0] == "previous")) {
        slider_ = (slider_ + (words[0] == "next" ? 1 : count - 1)) % count;
        return "ok slider " + sliders[static_cast<std::size_t>(slider_)].name;
    }
    std::vector<std::string> named{"slider", sliders[static_cast<std::size_t>(slider_)].name};
    named.insert(named.end(), words.begin(), words.end());
    return *control(named);
}

std::string Commands::choose(Words words) {
    const int count = static_cast<int>(session_.lights().size());
    if (count == 0)
        throw UsageError("this scene has no lights");
    const std::string& which = expectOne(words, "a light's number, next or previous");
    const int step = which == "next" ? 1 : which == "previous" ? -1 : 0;
    session_.chosenLight = step == 0 ? static_cast<int>(readNumber(which, 1, count))
                                     : (session_.chosenLight - 1 + step + count) % count + 1;
    return "ok chosen light " + std::to_string(session_.chosenLight);
}

std::string Commands::only(Words words) {
    const std::string& which = expectOne(words, "chosen, all, or a light's number");
    const int count = static_cast<int>(session_.lights().size());
    const int wanted = which == "all"      ? 0
                       : which == "chosen" ? session_.chosenLight
                                           : static_cast<int>(readNumber(which, 1, count));
    if (wanted > count)
        throw UsageError("this scene has no lights");
    session_.only = which == "chosen" && session_.only == wanted ? 0 : wanted;
    return "ok only light " + (session_.only == 0 ? std::string("all") : std::to_string(session_.only));
}

std::string Commands::shot(Words words) {
    if (words.empty()) {
        const std::string name = freeName(program_, {".png", ".json"});
        host_.shot(name + ".png", 0, 0);
        image::writeText(name + ".json", stateText(host_.savedState(), false));
        return "ok shot " + name + ".png " + name + ".json";
    }
    int width = 0, height = 0;
    if (words.size() == 2)
        std::tie(width, height) = readSize(words[1]);
    if (words.size() > 2)
        throw UsageError("expected a file name and perhaps WIDTHxHEIGHT, found '" + joined(words) + "'");
    host_.shot(words[0], width, height);
    return "ok shot " + words[0];
}

std::string Commands::save(Words words) {
    const std::string name =
        words.empty() ? freeName(program_ + "-state", {".json"}) + ".json" : expectOne(words, "a file name");
    image::writeText(name, stateText(host_.savedState(), false));
    return "ok save " + name;
}

std::string Commands::load(Words words) {
    const std::string& name = expectOne(words, "the name of a state file");
    session_.apply(readState(name, program_).controls);
    return "ok load " + name;
}

std::string Commands::state(Words words) {
    expectNothing(words);
    return "ok state " + stateText(host_.savedState(), true);
}

std::string Commands::undo(Words words) {
    expectNothing(words);
    const std::optional<State> before = history_.undo(session_.state());
    if (!before)
        throw UsageError("nothing was changed yet");
    session_.apply(*before);
    return "ok undo";
}

std::string Commands::redo(Words words) {
    expectNothing(words);
    const std::optional<State> after = history_.redo(session_.state());
    if (!after)
        throw UsageError("nothing was undone");
    session_.apply(*after);
    return "ok redo";
}

std::string Commands::reset(Words words) {
    expectNothing(words);
    session_.reset();
    return "ok reset";
}

namespace {

std::optional<PanelPoint> pointOf(std::span<const std::string> words) {
    if (words.empty())
        return std::nullopt;
    if (words.size() != 2)
        throw UsageError("expected X and Y, from 0 (left, top) to 1 (right, bottom), found '" +
                         joined(words) + "'");
    return PanelPoint{readNumber(words[0], 0, 1), readNumber(words[1], 0, 1)};
}

}  // namespace

std::string Commands::probe(Words words) { return oneLine(host_.probe(pointOf(words))); }

std::string Commands::pin(Words words) {
    if (words.empty() && session_.pin) {
        session_.pin.reset();
        return "ok unpin";
    }
    host_.pin(pointOf(words));
    return oneLine(host_.probe({}));
}

std::string Commands::unpin(Words words) {
    expectNothing(words);
    session_.pin.reset();
    return "ok unpin";
}

std::string Commands::next(Words words) {
    expectNothing(words);
    const std::string name = neighbour(program_, 1);
    host_.goTo(name, {});
    return "ok lesson " + name;
}

std::string Commands::previous(Words words) {
    expectNothing(words);
    const std::string name = neighbour(program_, -1);
    host_.goTo(name, {});
    return "ok lesson " + name;
}

std::string Commands::lesson(Words words) {
    const std::string name = programNamed(expectOne(words, "a lesson's name or number"));
    host_.goTo(name, {});
    return "ok lesson " + name;
}

std::string Commands::open(Words words) {
    const std::string& file = expectOne(words, "the name of a scene file");
    host_.goTo("scene_viewer", {(file.starts_with('-') ? "./" : "") + file});  // no option
    return "ok open " + file;
}

std::string Commands::cost(Words words) {
    expectNothing(words);
    return "ok cost " + host_.lightCost();
}

std::string Commands::places(Words words) {
    expectNothing(words);
    std::string all = host_.places();
    std::replace(all.begin(), all.end(), '\n', ';');
    return "ok places " + all;
}

std::string Commands::fullscreen(Words words) {
    expectNothing(words);
    host_.fullscreen();
    return "ok fullscreen";
}

std::string Commands::controls(Words words) {
    expectNothing(words);
    return "ok controls " + controlsJson(session_.table);
}

std::string Commands::help(Words words) {
    expectNothing(words);
    std::string all;
    for (const Action& action : actions())
        all += (all.empty() ? "" : "; ") + std::string(action.name) + (*action.usage != '\0' ? " " : "") +
               action.usage + ": " + session_.say(action.help);
    return "ok help CONTROL [VALUE | toggle | next | previous | up | down | reset]; " + all;
}

std::string Commands::quit(Words words) {
    expectNothing(words);
    host_.leave();
    return "ok quit";
}

}  // namespace lab
