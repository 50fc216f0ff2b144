// Writes the sum out, addend by addend.
// SPDX-License-Identifier: MIT
#include "lab/live/equation_numbers.hpp"

#include "lab/live/numbered_lights.hpp"
#include "lab/live/numbers.hpp"
#include "lab/live/probe_text.hpp"

#include <algorithm>
#include <cmath>

namespace lab {

using lighting::Term;
using lighting::Text;

Tone toneOf(SymbolState state) {
    switch (state) {
    case SymbolState::active:
        return Tone::active;
    case SymbolState::idle:
        return Tone::idle;
    case SymbolState::off:
        return Tone::off;
    case SymbolState::plain:
        break;
    }
    return Tone::plain;
}

namespace {

class Writer {
  public:
    Writer(const ProbeReport& report, const std::vector<Symbol>& symbols, Language language)
        : report_(report), symbols_(symbols), language_(language) {}

    std::vector<PanelSymbol> write() {
        plain("P = ");
        if (!report_.probe.lit)
            plain(colorText(report_.probe.P), report_.probe.mesh == nullptr
                                                  ? Text{"il colore dello sfondo", "the background's colour"}
                                                  : Text{"il colore del materiale", "the material's colour"});
        else if (report_.probe.corners)
            corners();
        else
            sum();
        return std::move(written_);
    }

  private:
    void plain(const std::string& text, const Text& help = {"", ""}) {
        written_.push_back({text, Tone::plain, {}, {}, {}, say(help, language_)});
    }

    // What stands for a term's symbol; `of`: the light that it belongs to.
    void term(Term which, const std::string& text, const std::string& of = {}) {
        const lighting::TermInfo& row = lighting::info(which);
        const auto symbol = std::find_if(symbols_.begin(), symbols_.end(),
                                         [which](const Symbol& s) { return s.term == which; });
        const SymbolState state = !report_.on(which)         ? SymbolState::off
                                  : symbol != symbols_.end() ? symbol->state
                                                             : SymbolState::active;
        std::string help = std::string(row.symbol) + ": " + say(row.meaning, language_);
        if (!of.empty())
            help += "\n" + of;
        if (!report_.on(which))
            help += std::string("\n") + say({"spento: al suo posto ", "off: in its place "}, language_) +
                    say(row.off, language_);
        written_.push_back({text, toneOf(state), "term " + std::string(row.name) + " toggle", {}, {}, help});
    }

    void addend(const ProbeLight& light) {
        const auto& a = light.addend;
        const std::string of = lightTitle(light.number, light.name, language_);
        const glm::dvec3 D = report_.on(Term::albedo) ? report_.probe.D : glm::dvec3(1);
        // A directional light has no f(d): nothing that a click could switch.
        const auto attenuation = [&] {
            light.directional ? plain("1", {"luce direzionale: nessun f(d)", "directional light: no f(d)"})
                              : term(Term::attenuation, shortText(a.f), of);
        };
        term(Term::clamp, "max(0, ", of);
        term(Term::cosine, shortText(std::abs(a.cosine) < 1e-12 ? 0 : a.cosine), of);
        term(Term::clamp, ")", of);
        plain(" · ");
        attenuation();
        plain(" · ");
        term(Term::albedo, colorText(D), of);
        plain(" ⊗ ");
        term(Term::lightColor, colorText(a.L), of);
        if (!report_.shines())
            return;
        plain(" + ");
        attenuation();
        plain(" · ");
        term(Term::specular, shortText(a.specular), of);
        plain(" ⊗ ");
        term(Term::lightColor, colorText(a.L), of);
    }

    void lights() {
        const auto isOff = [this](bool directional) {
            return std::any_of(report_.lights.begin(), report_.lights.end(), [&](const ProbeLight& light) {
                return !light.counted && light.directional == directional;
            });
        };
        const auto counted =
            static_cast<std::size_t>(std::count_if(report_.lights.begin(), report_.lights.end(),
                                                   [](const ProbeLight& light) { return light.counted; }));
        const std::vector<int> told = brightestLights(report_, counted <= 3 ? 3 : 2);
        auto plus = [this, first = true]() mutable {
            if (!first)
                plain(" + ");
            first = false;
        };
        for (const int number : told) {
            plus();
            addend(*report_.light(number));
        }
        if (counted > told.size()) {
            plus();
            plain("... (" + std::to_string(counted - told.size()) + say({" altre)", " more)"}, language_));
        }
        for (const bool directional : {true, false})
            if (isOff(directional)) {
                plus();
                term(directional ? Term::directional : Term::point, "0");
            }
        if (report_.lights.empty())
            plain("0", {"nessuna luce con una direzione", "no light with a direction"});
    }

    void sum() {
        plain("( ");
        lights();
        plain(" ) + ");
        if (report_.on(Term::ambient)) {
            term(Term::albedo, colorText(report_.on(Term::albedo) ? report_.probe.D : glm::dvec3(1)));
            plain(" ⊗ ");
            term(Term::ambient, colorText(report_.ambientLight));
        } else {
            term(Term::ambient, "0");
        }
        end();
    }

    void corners() {
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0)
                plain(" + ");
            plain(shortText(report_.probe.weights[static_cast<int>(i)]),
                  {"peso del vertice", "weight of the corner"});
            plain(" · ");
            plain(shortText((*report_.probe.corners)[i]),
                  {"l'equazione in un vertice del triangolo", "the equation at a corner of the triangle"});
        }
        end();
    }

    void end() {
        if (report_.probe.emitted != glm::dvec3(0)) {
            plain(" + ");
            plain(colorText(report_.probe.emitted),
                  {"luce propria del materiale", "the material's own light"});
        }
        plain(" = ");
        plain(colorText(report_.probe.P),
              {"P; lo schermo mostra ogni canale tra 0 e 1", "P; the screen shows each channel from 0 to 1"});
    }

    const ProbeReport& report_;
    const std::vector<Symbol>& symbols_;
    Language language_;
    std::vector<PanelSymbol> written_;
};

}  // namespace

std::vector<PanelSymbol> equationWithNumbers(const ProbeReport& report, const std::vector<Symbol>& symbols,
                                             Language language) {
    return Writer(report, symbols, language).write();
}

std::string equationText(const std::vector<PanelSymbol>& symbols) {
    std::string text;
    for (const PanelSymbol& symbol : symbols)
        text += symbol.text;
    return text;
}

}  // namespace lab
