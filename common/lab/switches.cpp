// The table of switches.
// SPDX-License-Identifier: MIT
#include "lab/switches.hpp"

namespace lab {

namespace {

using lighting::Switches;

const Choice shadings[] = {
    {"pixel", {"per frammento", "per fragment"}},
    {"vertex", {"per vertice, poi interpolata", "per vertex, then interpolated"}},
    {"flat", {"una normale per faccia", "one normal per face"}},
};
const Choice spaces[] = {
    {"world", {"mondo", "world"}},
    {"view", {"vista", "view"}},
};
const Choice normalTransforms[] = {
    {"inverse-transpose", {"inversa trasposta della matrice model", "inverse transpose of the model matrix"}},
    {"model", {"la matrice model da sola: sbagliato!", "the model matrix alone: wrong!"}},
};
const Choice specularModels[] = {
    {"phong", {"il vettore riflesso R (slide 45)", "the reflected vector R (slide 45)"}},
    {"blinn", {"il vettore a metà, come three.js", "the half vector, as three.js"}},
};

const Switch table[] = {
    {'S',
     "--shading",
     {"dove si calcola l'equazione", "where the equation is evaluated"},
     shadings,
     [](const Switches& s) { return static_cast<int>(s.shading); },
     [](Switches& s, int i) { s.shading = static_cast<lighting::Shading>(i); }},
    {'V',
     "--space",
     {"lo spazio di punti e vettori", "the space of points and vectors"},
     spaces,
     [](const Switches& s) { return static_cast<int>(s.space); },
     [](Switches& s, int i) { s.space = static_cast<lighting::Space>(i); }},
    {'N',
     "--normal-matrix",
     {"la matrice delle normali", "the matrix of normals"},
     normalTransforms,
     [](const Switches& s) { return static_cast<int>(s.normals); },
     [](Switches& s, int i) { s.normals = static_cast<lighting::NormalTransform>(i); }},
    {'B',
     "--specular",
     {"il riflesso dei materiali lucidi", "the highlight of shiny materials"},
     specularModels,
     [](const Switches& s) { return s.specular ? static_cast<int>(*s.specular) : -1; },
     [](Switches& s, int i) {
         s.specular = i < 0 ? std::nullopt : std::optional(static_cast<THREE::SpecularModel>(i));
     }},
};

}  // namespace

lighting::Text Switch::now(const Switches& switches) const {
    const int i = get(switches);
    return i < 0 ? lighting::Text{"come vuole il materiale", "the material's own"}
                 : choices[static_cast<std::size_t>(i)].meaning;
}

void Switch::next(Switches& switches) const {
    const int following = get(switches) + 1;
    set(switches, following < static_cast<int>(choices.size()) ? following : get(Switches()));
}

bool Switch::choose(std::string_view name, Switches& switches) const {
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (name == choices[i].name) {
            set(switches, static_cast<int>(i));
            return true;
        }
    return false;
}

std::string Switch::names() const {
    std::string all;
    for (const Choice& choice : choices)
        all += (all.empty() ? "" : "|") + std::string(choice.name);
    return all;
}

std::span<const Switch> switchTable() { return table; }

std::string switchesText(const Switches& switches) {
    std::string text;
    for (const Switch& row : table)
        if (const int i = row.get(switches); i != row.get(Switches()))
            text += (text.empty() ? "" : " ") + std::string(row.option) + " " +
                    row.choices[static_cast<std::size_t>(i)].name;
    return text;
}

}  // namespace lab
