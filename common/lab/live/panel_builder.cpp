// Builds the panel: equation, messages, probe, keys, legend, and what is drawn over the picture.
// SPDX-License-Identifier: MIT
#include "lab/live/panel_builder.hpp"

#include "lab/equation.hpp"
#include "lab/live/curves.hpp"
#include "lab/live/equation_numbers.hpp"
#include "lab/live/keys.hpp"
#include "lab/live/light_helpers.hpp"
#include "lab/live/overlay.hpp"
#include "lab/live/probe_text.hpp"
#include "lab/live/widgets.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace lab {

namespace {

using lighting::Text;

class Builder {
  public:
    Builder(Session& session, const PanelFacts& facts) : session_(session), facts_(facts) {}

    Panel build() {
        panel_.style = {static_cast<int>(session_.fontSize), session_.lightTheme};
        addEquation();
        std::istringstream lines(facts_.message.text);  // a shader's error comes with its excerpt
        for (std::string line; std::getline(lines, line);)
            panel_.message.push_back({{line, facts_.message.tone}});
        addProbe();
        // In a narrow window the probe's numbers take the place of the controls, where they do not hide the point.
        const bool instead = facts_.probe && isNarrow();
        panel_.probeAtRight = instead && facts_.probe->place && facts_.probe->place->x < 0.5;
        if (session_.panel && !instead)
            panel_.groups = widgetGroups(session_, facts_);
        addReadings();
        if (session_.legend)
            addKeys();
        else
            panel_.rows.push_back({{tell({"F1: tutti i tasti   Q: comandi   Esc: esce",
                                          "F1: all keys   Q: controls   Esc: leaves"}),
                                    Tone::idle}});
        addLegend();
        addDivider();
        if (session_.helpers)
            addHelpers();
        return std::move(panel_);
    }

  private:
    const char* tell(const Text& text) const { return session_.say(text); }

    bool isNarrow() const {
        constexpr double narrow = 75;  // heights of a line of text
        return facts_.width < narrow * session_.fontSize;
    }

    void addEquation() {
        lighting::Switches all = session_.switches;
        all.terms = lighting::TermSet::all();
        const lighting::FramePlan full = session_.view().plan(all);
        const std::vector<Symbol> symbols = equation(session_.switches.terms, full);
        if (facts_.probe) {
            panel_.equation = equationWithNumbers(*facts_.probe, symbols, session_.language);
        } else {
            lighting::TermSet named = lighting::TermSet::none();
            for (const Symbol& symbol : symbols) {
                panel_.equation.push_back(panelSymbol(symbol, full));
                if (symbol.term &&
                    named.has(*symbol.term)) {  // key and slide stand with the first of a term's pieces
                    panel_.equation.back().key.clear();
                    panel_.equation.back().slide.clear();
                }
                named = symbol.term ? named.with(*symbol.term) : named;
            }
        }
        if (!facts_.slides.empty())
            panel_.slide = "slide " + facts_.slides;
    }

    PanelSymbol panelSymbol(const Symbol& symbol, const lighting::FramePlan& full) const {
        PanelSymbol out{symbol.text, toneOf(symbol.state)};
        if (!symbol.term)
            return out;
        const lighting::TermInfo& row = lighting::info(*symbol.term);
        out.command = std::string("term ") + row.name + " toggle";
        out.key = std::to_string(static_cast<int>(row.term) + 1);
        out.slide = row.slides;
        out.help = std::string(row.symbol) + "  " + tell(row.meaning) + "\n" + tell({"spento: ", "off: "}) +
                   tell(row.off) + "\nslide " + row.slides;
        if (const Text idle = lighting::idleReason(*symbol.term, full); idle.en != nullptr)
            out.help +=
                std::string("\n") + tell({"qui non cambia nulla: ", "changes nothing here: "}) + tell(idle);
        return out;
    }

    void addProbe() {
        if (!facts_.probe)
            return;
        panel_.probe = probeLines(*facts_.probe, session_.language, isNarrow() ? 2 : 3);
        panel_.curves = pointCurves(*facts_.probe, session_.chosenLight, session_.language);
        OverlayOptions options;
        options.chosen = session_.chosenLight;
        Overlay overlay = pointOverlay(*facts_.probe, session_.view().camera(), options);
        panel_.strokes = std::move(overlay.strokes);
        panel_.tags = std::move(overlay.tags);
    }

    void addReadings() {
        for (const Reading& reading : session_.view().controls().readings)
            panel_.rows.push_back({{valueText(reading.value), Tone::active},
                                   {std::string("   ") + tell(reading.label), Tone::plain}});
    }

    void addKeys() {
        for (const Key& key : keyTable()) {
            const bool about = std::string_view(key.command).starts_with("slider")
                                   ? !session_.view().controls().sliders().empty()
                               : key.code == ' ' ? session_.view().animated()
                                                 : true;
            if (key.help.en != nullptr && about)
                panel_.rows.push_back({{tell(key.help), Tone::plain}});
        }
        addSkipped();
    }

    // What the last picture did without, and why; the first few by name.
    void addSkipped() {
        constexpr std::size_t named = 2;
        const render::FrameStats& drawn = facts_.drawn;
        const std::size_t count = drawn.skipped.size();
        if (count == 0 && drawn.clusters == 0)
            return;
        std::string text = tell({"tralasciati: ", "left out: "}) + std::to_string(count);
        if (drawn.clusters > 0)
            text +=
                tell({"; luci per parte dell'immagine: ", "; lights per part of the picture: "}) +
                valueText(static_cast<double>(drawn.clusterEntries) / static_cast<double>(drawn.clusters));
        panel_.rows.push_back({{text, Tone::title}});
        for (std::size_t i = 0; i < std::min(count, named); ++i)
            panel_.rows.push_back({{THREE::describe(*drawn.skipped[i].object) + ": " +
                                        drawn.skipped[i].share + tell(drawn.skipped[i].why),
                                    Tone::idle}});
        if (count > named)
            panel_.rows.push_back({{"...", Tone::idle}});
    }

    // What the colours mean; of the picture as it is, that it is no longer the equation's, where that is so.
    void addLegend() {
        if (facts_.legend) {
            panel_.legend = facts_.legend;
            return;
        }
        if (session_.mode == lighting::ViewMode::final)
            return;
        const lighting::ViewInfo& row = lighting::info(session_.mode);
        PanelLegend legend{tell(row.meaning), {}};
        if (row.needsLight)
            if (const int number =
                    numberOf(lighting::viewLight(session_.view().scene(), session_.settings()));
                number > 0)
                legend.title += std::string(tell({", luce ", ", light "})) + std::to_string(number);
        const std::vector<lighting::LegendEntry> entries = lighting::legend(session_.mode);
        constexpr std::size_t most = 11;  // more are thinned out, but for the ends
        const std::size_t every = (entries.size() + most - 2) / most;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const lighting::LegendEntry& entry = entries[i];
            if (every > 1 && i % every != 0 && i + 1 != entries.size())
                continue;
            legend.entries.push_back({{entry.color.x, entry.color.y, entry.color.z},
                                      (entry.value ? valueText(*entry.value) : std::string()) +
                                          (entry.value && entry.text.en != nullptr ? "  " : "") +
                                          (entry.text.en != nullptr ? tell(entry.text) : "")});
        }
        panel_.legend = std::move(legend);
    }

    int numberOf(const THREE::Light* light) const {
        const auto& lights = session_.lights();
        const auto found = std::find(lights.begin(), lights.end(), light);
        return found == lights.end() ? 0 : static_cast<int>(found - lights.begin()) + 1;
    }

    void addDivider() {
        if (session_.split == Split::off)
            return;
        const lighting::TermInfo& term = lighting::info(session_.lastTerm);
        if (session_.split == Split::term)
            panel_.divider = {session_.divider, std::string(tell({"senza ", "without "})) + term.symbol,
                              std::string(tell({"con ", "with "})) + term.symbol};
        else
            panel_.divider = {session_.divider, facts_.before, facts_.program};
    }

    void addHelpers() {
        const THREE::PerspectiveCamera& camera = session_.view().camera();
        const std::vector<LightHelper> helpers =
            lightHelpers(session_.view().scene(), camera, std::as_const(session_).view().orbit().target());
        LightMarks marks = lightMarks(helpers, camera, session_.chosenLight, session_.language);
        panel_.strokes.insert(panel_.strokes.end(), marks.strokes.begin(), marks.strokes.end());
        panel_.handles = std::move(marks.handles);
    }

    Session& session_;
    const PanelFacts& facts_;
    Panel panel_;
};

}  // namespace

Panel buildPanel(Session& session, const PanelFacts& facts) { return Builder(session, facts).build(); }

}  // namespace lab
