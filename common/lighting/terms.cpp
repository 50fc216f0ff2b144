// The table of switchable symbols, and the option that switches them.
// SPDX-License-Identifier: MIT
#include "lighting/terms.hpp"

namespace lighting {

const std::array<TermInfo, termCount>& terms() {
    static const std::array<TermInfo, termCount> table{{
        {Term::albedo,
         "albedo",
         "D",
         "TERM_ALBEDO",
         "14, 27",
         {"colore base del materiale", "base colour of the material"},
         {"(1,1,1)", "(1,1,1)"}},
        {Term::cosine,
         "cosine",
         "n·ω",
         "TERM_COSINE",
         "16-20, 24",
         {"legge del coseno", "cosine law"},
         {"1", "1"}},
        {Term::clamp,
         "clamp",
         "max(0,·)",
         "TERM_CLAMP",
         "23-24",
         {"zero se la luce è dietro", "zero where the light is behind"},
         {"identità: la luce da dietro sottrae", "identity: light from behind subtracts"}},
        {Term::lightColor,
         "light_color",
         "L",
         "TERM_LIGHT_COLOR",
         "26-27, 31",
         {"colore della luce", "colour of the light"},
         {"bianco della stessa intensità", "white of the same intensity"}},
        {Term::attenuation,
         "attenuation",
         "f(d)",
         "TERM_ATTENUATION",
         "31",
         {"affievolimento con la distanza", "attenuation with distance"},
         {"1", "1"}},
        {Term::directional,
         "directional",
         "Σ dir",
         "TERM_DIRECTIONAL",
         "29-30",
         {"luci direzionali", "directional lights"},
         {"0", "0"}},
        {Term::point,
         "point",
         "Σ pos",
         "TERM_POINT",
         "29-31",
         {"luci posizionali", "point lights"},
         {"0", "0"}},
        {Term::ambient,
         "ambient",
         "D⊗L_A",
         "TERM_AMBIENT",
         "42",
         {"componente ambiente", "ambient component"},
         {"0", "0"}},
        {Term::specular,
         "specular",
         "max(0,R·v)^s",
         "TERM_SPECULAR",
         "45",
         {"riflesso lucido", "specular reflection"},
         {"0", "0"}},
    }};
    return table;
}

const TermInfo& info(Term term) { return terms()[static_cast<std::size_t>(term)]; }

std::string TermSet::text() const {
    if (*this == all())
        return "all";
    std::string list;
    for (const TermInfo& row : terms())
        if (has(row.term))
            list += (list.empty() ? "" : ",") + std::string(row.name);
    return list.empty() ? "none" : list;
}

namespace {

Term termNamed(std::string_view name) {
    std::string known;
    for (const TermInfo& row : terms()) {
        if (name == row.name)
            return row.term;
        known += " " + std::string(row.name);
    }
    throw std::invalid_argument("unknown term '" + std::string(name) +
                                "', expected all, none, or some of:" + known);
}

}  // namespace

TermSet parseTerms(std::string_view list, TermSet start) {
    if (list == "all")
        return TermSet::all();
    if (list == "none")
        return TermSet::none();
    const bool changes = !list.empty() && (list.front() == '+' || list.front() == '-');
    TermSet result = changes ? start : TermSet::none();
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        std::string_view word = list.substr(begin, end - begin);
        const bool signedWord = !word.empty() && (word.front() == '+' || word.front() == '-');
        if (signedWord != changes)
            throw std::invalid_argument("'" + std::string(list) +
                                        "' mixes names with +name or -name; expected either "
                                        "names to keep (cosine,albedo) or changes (-clamp,+ambient)");
        const bool on = !signedWord || word.front() == '+';
        const Term term = termNamed(signedWord ? word.substr(1) : word);
        result = on ? result.with(term) : result.without(term);
        begin = end + 1;
    }
    return result;
}

}  // namespace lighting
