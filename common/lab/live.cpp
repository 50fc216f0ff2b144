// The window's loop: keys, mouse, panel, and drawing only what changed.
// SPDX-License-Identifier: MIT
#include "lab/live.hpp"

#include "lab/equation.hpp"
#include "lab/light_cost.hpp"
#include "lab/stills.hpp"
#include "lab/switches.hpp"
#include "render/gl_renderer.hpp"
#include "render/reference_renderer.hpp"
#include "render/shader_source.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>

namespace lab {

namespace {

using lighting::Term;
using lighting::Text;
using Clock = std::chrono::steady_clock;

const Text keyHelp[] = {
    {"trascina: ruota   tasto destro: sposta   rotella: avvicina",
     "drag: orbit   right button: pan   wheel: zoom"},
    {"K: esponente k   C: quanto costa una luce", "K: exponent k   C: what a light costs"},
    {"R: come all'inizio   F2: scrive un'immagine", "R: reset   F2: writes a picture"},
    {"H: nasconde queste righe   Esc: esce", "H: hides these lines   Esc: leaves"},
};
const Text sliderHelp = {"Tab: sceglie un cursore   ← →: lo muove (con Maiusc: di più)",
                         "Tab: chooses a slider   ← →: moves it (with Shift: farther)"};
const Text keysHint = {"Tab ← →: cursori   H: tutti i tasti", "Tab ← →: sliders   H: all keys"};
const Text animationHelp = {"spazio: avvia o ferma il movimento", "space: starts or stops the movement"};

constexpr int framesForCost = 7;

class Live {
  public:
    Live(View& view, Window& window, const Options& options)
        : view_(view), window_(window), options_(options),
          renderer_(render::findShaderDirectory(options.shaders), render::Compile::aside),
          switches_(options.switches), time_(options.time), legend_(view.controls().sliders().empty()) {}

    void run() {
        while (!leave_) {
            if (redraws_ > 0) {
                draw();
                --redraws_;
            }
            const bool still = redraws_ == 0 && (!playing_ || minimised_);
            for (const Event& event : window_.events(still))
                handle(event);
            if (playing_) {
                const Clock::time_point now = Clock::now();
                time_ += std::chrono::duration<double>(now - last_).count();
                last_ = now;
                redraws_ = 1;
            }
        }
    }

  private:
    // What draws the pictures; the window itself is always the graphics driver's.
    render::Renderer& renderer() {
        if (options_.renderer == RendererKind::gl)
            return renderer_;
        return reference_;
    }

    // A frame as large as the window, in codes; none while it is minimised.
    std::optional<render::FrameRequest> windowRequest() const {
        render::FrameRequest request;
        window_.framebufferSize(request.width, request.height);
        return request.width < 1 || request.height < 1 ? std::nullopt : std::optional(request);
    }

    const char* tell(const Text& text) const { return say(text, options_.language); }

    void handle(const Event& event) {
        const bool panelChanges = event.kind == Event::Kind::key || event.kind == Event::Kind::bar ||
                                  event.kind == Event::Kind::redraw;
        redraws_ = panelChanges ? 2 : std::max(redraws_, 1);  // a panel's new size settles in the second
        switch (event.kind) {
        case Event::Kind::key:
            if (!sliderKey(event))
                key(event.key);
            return;
        case Event::Kind::drag:
            return view_.orbit().rotate(event.dx, event.dy);
        case Event::Kind::pan:
            return view_.orbit().pan(event.dx, event.dy);
        case Event::Kind::wheel:
            return view_.orbit().zoom(event.dy);
        case Event::Kind::bar:
            chosen_ = static_cast<std::size_t>(event.key);
            return sliders().at(chosen_).moveTo(event.dx);
        case Event::Kind::close:
            leave_ = true;
            return;
        case Event::Kind::redraw:
            return;
        }
    }

    std::deque<Slider>& sliders() { return view_.controls().sliders(); }

    // Whether the key was one for the sliders.
    bool sliderKey(const Event& event) {
        if (sliders().empty() || (event.key != keyTab && event.key != keyLeft && event.key != keyRight))
            return false;
        const std::size_t count = sliders().size();
        if (event.key == keyTab)
            chosen_ = (chosen_ + (event.modified ? count - 1 : 1)) % count;
        else
            sliders()[chosen_].move((event.key == keyLeft ? -1 : 1) * (event.modified ? 10 : 1));
        return true;
    }

    void key(int key) {
        if (key >= '1' && key < '1' + lighting::termCount) {
            const lighting::TermInfo& row = lighting::terms()[static_cast<std::size_t>(key - '1')];
            switches_.terms = switches_.terms.toggled(row.term);
            message_ =
                std::string(row.symbol) + "  " + tell(row.meaning) +
                (switches_.terms.has(row.term) ? tell({": acceso", ": on"}) : tell({": spento", ": off"}));
            std::cout << equationText(switches_.terms, renderer().stats().shiny) << std::endl;
        } else if (switchKey(key)) {
            return;
        } else if (key == 'K') {
            nextDecay();
        } else if (key == 'C') {
            tellLightCost();
        } else if (key == 'R') {
            view_.orbit().reset();
            view_.controls().reset();
            switches_ = options_.switches;
            view_.decay = options_.decay;
            time_ = options_.time;
            playing_ = false;
            message_.clear();
        } else if (key == ' ' && view_.animated()) {
            playing_ = !playing_;
            last_ = Clock::now();
        } else if (key == 'H') {
            legend_ = !legend_;
        } else if (key == keyF2) {
            writePictureBeside();
        } else if (key == keyEscape) {
            leave_ = true;
        }
    }

    // Whether the key was one of the table's.
    bool switchKey(int key) {
        for (const Switch& row : switchTable())
            if (key == row.key) {
                row.next(switches_);
                message_ = std::string(tell(row.what)) + ": " + tell(row.now(switches_));
                std::cout << message_ << std::endl;
                return true;
            }
        return false;
    }

    // k of every point light: 0, 1/2, 1, 3/2, 2, and again each light's own.
    void nextDecay() {
        view_.decay = !view_.decay ? 0 : *view_.decay + 0.5;
        if (*view_.decay > 2)
            view_.decay.reset();
        message_ =
            std::string("f(d) = 1 / d^k,  k = ") +
            (view_.decay ? valueText(*view_.decay) : tell({"quello di ogni luce", "each light's own"}));
        std::cout << message_ << std::endl;
    }

    void tellLightCost() {
        const std::optional<render::FrameRequest> request = windowRequest();
        if (!request)
            return;
        const LightCost cost = measureLights(view_, renderer(), switches_, time_, *request, framesForCost);
        message_ = std::to_string(cost.lights) + tell({" luci: ", " lights: "}) +
                   valueText(median(cost.with)) + tell({" ms; senza: ", " ms; without: "}) +
                   valueText(median(cost.without)) + tell({" ms; ogni luce: ", " ms; each light: "}) +
                   valueText(cost.each()) + " ms";
        std::cout << message_ << std::endl;
    }

    // <lesson>.png, or with the first number that is free: no picture is ever overwritten from the window.
    void writePictureBeside() {
        const std::optional<render::FrameRequest> request = windowRequest();
        if (!request)
            return;
        try {
            std::string path = options_.lesson + ".png";
            for (int number = 1; std::filesystem::exists(path); ++number)
                path = options_.lesson + "-" + std::to_string(number) + ".png";
            writePicture(view_, renderer(), path, time_, switches_, request->width, request->height,
                         options_);
            message_ = tell({"scritta: ", "written: "}) + path;
            std::cout << message_ << std::endl;
        } catch (const std::exception& error) {  // the lecture goes on
            message_ = error.what();
            std::cerr << options_.lesson << ": " << message_ << std::endl;
        }
    }

    void draw() {
        const std::optional<render::FrameRequest> request = windowRequest();
        minimised_ = !request;
        if (minimised_)
            return;
        view_.update(time_, request->width, request->height);
        if (options_.renderer == RendererKind::gl)
            renderer_.drawToWindow(view_.plan(switches_), view_.settings(switches_), request->width,
                                   request->height);
        else
            renderer_.showInWindow(
                reference_.render(view_.scene(), view_.camera(), view_.settings(switches_), *request));
        window_.show(panel());
    }

    Panel panel() const {
        lighting::Switches allTerms = switches_;
        allTerms.terms = lighting::TermSet::all();
        const lighting::FramePlan full = view_.plan(allTerms);
        Panel panel;
        for (const Symbol& symbol : equation(switches_.terms, full))
            panel.equation.push_back({symbol.text, tone(symbol.state)});
        panel.message = message_;
        addControls(panel);
        if (!legend_)
            return panel;
        for (const lighting::TermInfo& row : lighting::terms())
            panel.rows.push_back(termRow(row, full));
        panel.rows.emplace_back();
        for (const Switch& row : switchTable()) {
            const bool moved = row.get(switches_) != row.get(lighting::Switches());
            panel.rows.push_back({{std::string(1, row.key) + "  ", Tone::title},
                                  {std::string(tell(row.what)) + ": " + tell(row.now(switches_)),
                                   moved ? Tone::active : Tone::plain}});
        }
        for (const Text& help : keyHelp)
            panel.rows.push_back({{tell(help), Tone::plain}});
        if (!std::as_const(view_).controls().sliders().empty())
            panel.rows.push_back({{tell(sliderHelp), Tone::plain}});
        if (view_.animated())
            panel.rows.push_back({{tell(animationHelp), Tone::plain}});
        return panel;
    }

    void addControls(Panel& panel) const {
        const Controls& controls = std::as_const(view_).controls();
        for (const Slider& slider : controls.sliders()) {
            const bool chosen = panel.bars.size() == chosen_;
            panel.bars.push_back(
                {slider.share(),
                 chosen,
                 {{slider.name + " = " + valueText(slider.value), chosen ? Tone::title : Tone::plain},
                  {std::string("   ") + tell(slider.label), Tone::idle}}});
        }
        for (const Reading& reading : controls.readings)
            panel.readings.push_back({{valueText(reading.value), Tone::active},
                                      {std::string("   ") + tell(reading.label), Tone::plain}});
        if (!legend_ && !controls.sliders().empty())
            panel.readings.push_back({{tell(keysHint), Tone::idle}});
    }

    static Tone tone(SymbolState state) {
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

    std::vector<Span> termRow(const lighting::TermInfo& row, const lighting::FramePlan& full) const {
        const Text idle = lighting::idleReason(row.term, full);
        const bool on = switches_.terms.has(row.term);
        const Tone t = !on ? Tone::off : idle.en != nullptr ? Tone::idle : Tone::active;
        std::vector<Span> spans{{std::to_string(static_cast<int>(row.term) + 1) + "  ", Tone::title},
                                {std::string(row.symbol) + "  " + tell(row.meaning), t}};
        if (!on)
            spans.push_back({std::string("  → ") + tell(row.off), Tone::plain});
        else if (idle.en != nullptr)
            spans.push_back({std::string("  (") + tell(idle) + ")", Tone::idle});
        return spans;
    }

    View& view_;
    Window& window_;
    const Options& options_;
    render::GlRenderer renderer_;
    render::ReferenceRenderer reference_;
    lighting::Switches switches_;
    double time_;
    std::size_t chosen_ = 0;  // the slider that the arrow keys move
    std::string message_;
    int redraws_ = 2;
    bool playing_ = false;
    bool legend_;  // hidden at first where sliders matter more
    bool minimised_ = false;
    bool leave_ = false;
    Clock::time_point last_;
};

}  // namespace

void runLive(View& view, Window& window, const Options& options) { Live(view, window, options).run(); }

}  // namespace lab
