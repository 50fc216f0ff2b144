// What a student's scene has, said in a sentence.
// SPDX-License-Identifier: MIT
#include "grader/judge/aspect_words.hpp"

#include <cctype>
#include <cstdlib>
#include <map>

namespace grader {

namespace {

struct Pair {
    const char *it, *en;
};

const std::map<std::string, Pair> kinds{{"mesh", {"oggetto", "mesh"}},
                                        {"directional", {"luce direzionale", "directional light"}},
                                        {"point", {"luce posizionale", "point light"}},
                                        {"ambient", {"luce ambiente", "ambient light"}},
                                        {"background", {"sfondo", "background"}}};

const std::map<std::string, Pair> qualities{
    {"geometry", {"la forma", "the geometry"}},
    {"place", {"il posto o la rotazione", "the place or the rotation"}},
    {"scale", {"la scala", "the scale"}},
    {"material", {"il tipo di materiale", "the kind of material"}},
    {"color", {"il colore", "the colour"}},
    {"flat", {"flatShading", "flatShading"}},
    {"side", {"il lato che si vede", "the side that is drawn"}},
    {"emissive", {"la luce propria", "the light of its own"}},
    {"specular", {"il colore del riflesso K_S", "the highlight's colour K_S"}},
    {"shininess", {"l'esponente del riflesso s", "the highlight's exponent s"}},
    {"direction", {"la direzione verso la luce", "the direction towards the light"}},
    {"position", {"la posizione", "the position"}},
    {"intensity",
     {"la forza (il canale più chiaro di colore x intensità)",
      "the strength (brightest channel of colour x intensity)"}},
    {"hue",
     {"la tinta (il colore con il canale più chiaro a 1)",
      "the hue (the colour with its brightest channel at 1)"}},
    {"decay", {"l'esponente k (decay)", "the exponent k (decay)"}},
    {"distance", {"la distanza massima", "the farthest reach"}}};

const char* say(const std::map<std::string, Pair>& table, const std::string& key, bool it) {
    const auto found = table.find(key);
    return found == table.end() ? key.c_str() : it ? found->second.it : found->second.en;
}

}  // namespace

std::string inWords(const std::string& aspect, const Aspect& value, Language language) {
    const bool it = language == Language::it;
    const std::size_t dot = aspect.find('.'), bracket = aspect.find('[');
    const std::string kind = aspect.substr(0, std::min(dot, bracket));
    std::string quality = dot == std::string::npos ? "" : aspect.substr(dot + 1);
    if (quality == "color" && kind != "mesh")
        quality = "hue";
    std::string subject = say(kinds, kind, it);
    if (bracket != std::string::npos)
        subject += " " + std::to_string(std::atoi(aspect.c_str() + bracket + 1) + 1);
    if (quality == "present")
        return subject + (it ? ": nella scena non c'è" : ": is not in the scene");
    if (quality == "extra")
        return subject + (it ? ": ce ne sono troppi, " : ": there are too many, ") + value.found;
    if (value.found == "none")
        return subject + (it ? ": nella scena non c'è" : ": is not in the scene");
    if (value.found.empty())
        return subject + ": " + say(qualities, quality, it) + (it ? " non va bene" : " is not right");
    return subject + ": " + (quality.empty() ? "" : std::string(say(qualities, quality, it)) + " ") +
           (it ? "qui è " : "is ") + value.found + (it ? "" : " here");
}

}  // namespace grader
