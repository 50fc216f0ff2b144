// From a line to what it means, and to an answer.
// SPDX-License-Identifier: MIT
#include "lab/live/commands.hpp"

#include "lab/failure.hpp"
#include "lab/frame_lines.hpp"
#include "lab/live/command_words.hpp"
#include "lab/live/values.hpp"
#include "three/validate.hpp"

namespace lab {

std::span<const Commands::Action> Commands::actions() {
    static const Action table[] = {
        {"terms",
         "all | none | NAMES | +NAME,-NAME",
         {"tutti i termini insieme", "all terms at once"},
         &Commands::withTerms},
        {"light",
         "add KIND | N remove | chosen ...",
         {"aggiunge o toglie una luce", "adds or removes a light"},
         &Commands::withLight},
        {"slider",
         "next | previous | up | down [STEPS]",
         {"il cursore scelto", "the chosen slider"},
         &Commands::withSlider},
        {"choose", "N | next | previous", {"sceglie una luce", "chooses a light"}, &Commands::choose},
        {"only", "chosen | all | N", {"una luce da sola", "one light alone"}, &Commands::only},
        {"shot",
         "[FILE [WxH]]",
         {"scrive l'immagine; senza FILE, immagine e stato",
          "writes the picture; without FILE, picture and state"},
         &Commands::shot},
        {"save", "[FILE]", {"salva lo stato", "saves the state"}, &Commands::save},
        {"load", "FILE", {"riprende uno stato salvato", "takes a saved state"}, &Commands::load},
        {"state", "", {"lo stato, JSON", "the state, JSON"}, &Commands::state},
        {"undo", "", {"annulla", "takes the last change back"}, &Commands::undo},
        {"redo", "", {"rifà", "makes it again"}, &Commands::redo},
        {"reset", "", {"come all'inizio", "as at the start"}, &Commands::reset},
        {"probe",
         "X Y | (pinned)",
         {"tutti i numeri di un punto, 0 ... 1 da sinistra e dall'alto",
          "all numbers of a point, 0 ... 1 from the left and from the top"},
         &Commands::probe},
        {"pin", "[X Y]", {"fissa la sonda", "pins the probe"}, &Commands::pin},
        {"unpin", "", {"stacca la sonda", "unpins the probe"}, &Commands::unpin},
        {"next", "", {"la lezione dopo", "the lesson after"}, &Commands::next},
        {"previous", "", {"la lezione prima", "the lesson before"}, &Commands::previous},
        {"lesson", "NAME | NUMBER", {"un'altra lezione", "another lesson"}, &Commands::lesson},
        {"open", "FILE", {"una scena, come scene_viewer", "a scene, as scene_viewer"}, &Commands::open},
        {"cost", "", {"quanto costa una luce", "what a light costs"}, &Commands::cost},
        {"fullscreen", "", {"tutto lo schermo", "full screen"}, &Commands::fullscreen},
        {"controls",
         "",
         {"la tabella dei comandi, JSON", "the table of controls, JSON"},
         &Commands::controls},
        {"places",
         "",
         {"dove sta ogni cosa del pannello, pixel", "where each thing of the panel is, pixels"},
         &Commands::places},
        {"help", "", {"quali comandi ci sono", "which commands there are"}, &Commands::help},
        {"quit", "", {"esce", "leaves"}, &Commands::quit},
    };
    return table;
}

std::string Commands::run(const std::string& line, Said said) {
    const State before = session_.state();
    try {
        const std::vector<std::string> words = splitWords(line);
        if (words.empty())
            return {};
        const std::string answer = dispatch(words);
        const bool history = words[0] == "undo" || words[0] == "redo";
        if (!history)
            changed(before, said.byHand ? joined(std::span(words).first(words.size() - 1)) : "");
        return answer;
    } catch (const THREE::SceneError& error) {  // such a scene cannot be drawn: back to the one before
        session_.apply(before);
        try {
            session_.updateNow();
        } catch (const THREE::SceneError&) {  // the mouse had brought it there: the next draw mends it
        }
        return "error " + oneLine(error.what());
    } catch (const std::exception& error) {
        return "error " + oneLine(error.what());
    }
}

std::string Commands::dispatch(const std::vector<std::string>& words) {
    if (std::optional<std::string> answer = control(words))
        return *answer;
    for (const Action& action : actions())
        if (words[0] == action.name) {
            try {
                std::string answer = (this->*action.run)(Words(words).subspan(1));
                session_.updateNow();
                return answer;
            } catch (const UsageError& error) {
                throw UsageError(words[0] + ": " + error.what());
            }
        }
    throw UsageError("unknown command '" + joined(words) + "'; help and controls list what there is");
}

// Off where there is no lesson before: so that the key goes on through the other splits.
void Commands::expectSplit() {
    if (session_.split != Split::lesson)
        return;
    try {
        host_.expectLessonBefore();
    } catch (const UsageError& error) {
        session_.split = Split::off;
        throw UsageError(std::string("split: ") + error.what());
    }
}

// A control's name, then nothing (what is it?), or a value. Among names that fit, the longest is meant; of a light that is all there is
// to say when it is only on or off.
std::optional<std::string> Commands::control(Words words) {
    for (std::size_t count = words.size(); count > 0; --count) {
        const std::string name = joined(words.first(count));
        const Words rest = words.subspan(count);
        Control* found = session_.table.find(name);
        if (found == nullptr && rest.size() == 1 &&
            (rest[0] == "on" || rest[0] == "off" || rest[0] == "toggle"))
            found = session_.table.find(name + " on");
        if (found == nullptr)
            continue;
        if (rest.size() > 2 || (rest.size() == 2 && rest[0] != "up" && rest[0] != "down"))
            throw UsageError(name + ": expected one value, found '" + joined(rest) + "'");
        const std::string full = found->name;
        if (!rest.empty()) {
            const bool steps = rest[0] == "up" || rest[0] == "down";
            const int by = rest.size() == 2 ? static_cast<int>(readNumber(rest[1], 1, 1000)) : 1;
            session_.table.set(*found, steps ? found->next(rest[0] == "up" ? by : -by) : rest[0]);
            constexpr std::string_view term = "term ";
            if (full.starts_with(term))
                session_.table.give(*session_.table.find("last term"), full.substr(term.size()));
            if (full == "split")
                expectSplit();
            session_.updateNow();  // so that what is told is what the scene has
        }
        found = session_.table.find(full);
        return "ok " + full + (found != nullptr ? " " + found->get() : std::string());
    }
    return std::nullopt;
}

}  // namespace lab
