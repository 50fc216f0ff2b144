// The pieces of slide 42's equation, each with its term.
// SPDX-License-Identifier: MIT
#include "lab/equation.hpp"

namespace lab {

namespace {

using lighting::Term;
using lighting::TermSet;

struct Piece {
    const char* text;
    std::optional<Term> term;  // none: punctuation
    std::optional<Term> with;  // the addend that this piece belongs to
};

// In the order in which the lecture writes it; sums first, as in slide 42.
const Piece pieces[] = {
    {"P", {}, {}},
    {" = (", {}, {}},
    {" Σdir", Term::directional, {}},
    {" Σpos", Term::point, {}},
    {" ", {}, {}},
    {"max(0, ", Term::clamp, {}},
    {"n·ω_i", Term::cosine, {}},
    {")", Term::clamp, {}},
    {" ", {}, {}},
    {"f(d_i)", Term::attenuation, {}},
    {" ", {}, {}},
    {"D", Term::albedo, {}},
    {" ⊗ ", {}, {}},
    {"L_i", Term::lightColor, {}},
    {" + ", {}, Term::specular},
    {"f(d_i)", Term::attenuation, Term::specular},
    {" ", {}, Term::specular},
    {"K_S max(0, R_i·v)^s", Term::specular, {}},
    {" ⊗ ", {}, Term::specular},
    {"L_i", Term::lightColor, Term::specular},
    {" )", {}, {}},
    {" + ", {}, Term::ambient},
    {"D", Term::albedo, Term::ambient},
    {" ⊗ ", {}, Term::ambient},
    {"L_A", Term::ambient, {}},
};

}  // namespace

std::vector<Symbol> equation(TermSet on, const lighting::FramePlan& full) {
    std::vector<Symbol> symbols;
    const auto stateOf = [&](Term term) {
        if (!on.has(term))
            return SymbolState::off;
        return lighting::idleReason(term, full).en != nullptr ? SymbolState::idle : SymbolState::active;
    };
    for (const Piece& piece : pieces) {
        if (!full.shiny && (piece.term == Term::specular || piece.with == Term::specular))
            continue;
        Symbol symbol{piece.text, piece.term ? stateOf(*piece.term) : SymbolState::plain, piece.term};
        // What belongs to an addend goes, or dims, with it.
        if (piece.with && stateOf(*piece.with) != SymbolState::active)
            symbol.state = stateOf(*piece.with);
        symbols.push_back(std::move(symbol));
    }
    return symbols;
}

std::string equationText(TermSet on, bool shiny) {
    const bool sum = on.has(Term::directional) || on.has(Term::point);
    const auto has = [on](Term term) { return on.has(term); };
    std::string addend;
    if (has(Term::clamp))
        addend += std::string("max(0, ") + (has(Term::cosine) ? "n·ω" : "1") + ") ";
    else if (has(Term::cosine))
        addend += "(n·ω) ";
    if (has(Term::attenuation))
        addend += "f(d) ";
    const char* const albedo = has(Term::albedo) ? "D" : "1";
    const std::string L = has(Term::lightColor) ? "L" : "I";
    addend += std::string(albedo) + " ⊗ " + L;
    if (shiny && has(Term::specular))
        addend =
            "(" + addend + " + " + (has(Term::attenuation) ? "f(d) " : "") + "K_S max(0, R·v)^s ⊗ " + L + ")";
    std::string text = "P = ";
    if (has(Term::directional) && has(Term::point))
        text += "Σ " + addend;
    else if (sum)
        text += (has(Term::directional) ? "Σdir " : "Σpos ") + addend;
    if (has(Term::ambient))
        text += std::string(sum ? " + " : "") + albedo + " ⊗ L_A";
    if (!sum && !has(Term::ambient))
        text += "0";
    return text;
}

}  // namespace lab
