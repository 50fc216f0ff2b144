// The window's loop: keys, mouse, panel, and drawing only what changed.
// SPDX-License-Identifier: MIT
#include "lab/live.hpp"

#include "lab/equation.hpp"
#include "lab/stills.hpp"
#include "render/gl_renderer.hpp"
#include "render/reference_renderer.hpp"
#include "render/shader_source.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>

namespace lab {

namespace {

using lighting::Term;
using lighting::Text;
using Clock = std::chrono::steady_clock;

const Text keyHelp[] = {
    {"trascina: ruota   tasto destro: sposta   rotella: avvicina",
     "drag: orbit   right button: pan   wheel: zoom"},
    {"R: come all'inizio   F2: scrive un'immagine", "R: reset   F2: writes a picture"},
    {"H: nasconde queste righe   Esc: esce", "H: hides these lines   Esc: leaves"},
};
const Text animationHelp = {"spazio: avvia o ferma il movimento", "space: starts or stops the movement"};

class Live {
  public:
    Live(View& view, Window& window, const Options& options)
        : view_(view), window_(window), options_(options),
          renderer_(render::findShaderDirectory(options.shaders)), terms_(options.terms),
          time_(options.time) {}

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

    const char* tell(const Text& text) const { return say(text, options_.language); }

    void handle(const Event& event) {
        const bool panelChanges = event.kind == Event::Kind::key || event.kind == Event::Kind::redraw;
        redraws_ = panelChanges ? 2 : std::max(redraws_, 1);  // a panel's new size settles in the second
        switch (event.kind) {
        case Event::Kind::key:
            return key(event.key);
        case Event::Kind::drag:
            return view_.orbit().rotate(event.dx, event.dy);
        case Event::Kind::pan:
            return view_.orbit().pan(event.dx, event.dy);
        case Event::Kind::wheel:
            return view_.orbit().zoom(event.dy);
        case Event::Kind::close:
            leave_ = true;
            return;
        case Event::Kind::redraw:
            return;
        }
    }

    void key(int key) {
        if (key >= '1' && key < '1' + lighting::termCount) {
            const lighting::TermInfo& row = lighting::terms()[static_cast<std::size_t>(key - '1')];
            terms_ = terms_.toggled(row.term);
            message_ = std::string(row.symbol) + "  " + tell(row.meaning) +
                       (terms_.has(row.term) ? tell({": acceso", ": on"}) : tell({": spento", ": off"}));
            std::cout << equationText(terms_) << std::endl;
        } else if (key == 'R') {
            view_.orbit().reset();
            terms_ = options_.terms;
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

    // <lesson>.png, or with the first number that is free: no picture is ever overwritten from the window.
    void writePictureBeside() {
        int width = 0, height = 0;
        window_.framebufferSize(width, height);
        if (width < 1 || height < 1)
            return;
        try {
            std::string path = options_.lesson + ".png";
            for (int number = 1; std::filesystem::exists(path); ++number)
                path = options_.lesson + "-" + std::to_string(number) + ".png";
            writePicture(view_, renderer(), path, time_, terms_, width, height, options_);
            message_ = tell({"scritta: ", "written: "}) + path;
            std::cout << message_ << std::endl;
        } catch (const std::exception& error) {  // the lecture goes on
            message_ = error.what();
            std::cerr << options_.lesson << ": " << message_ << std::endl;
        }
    }

    void draw() {
        int width = 0, height = 0;
        window_.framebufferSize(width, height);
        minimised_ = width < 1 || height < 1;
        if (minimised_)
            return;
        view_.update(time_, width, height);
        if (options_.renderer == RendererKind::gl)
            renderer_.drawToWindow(view_.plan(terms_), view_.settings(terms_), width, height);
        else
            renderer_.showInWindow(reference_.render(view_.scene(), view_.camera(), view_.settings(terms_),
                                                     {width, height, false}));
        window_.show(panel());
    }

    Panel panel() const {
        const lighting::FramePlan full = view_.plan(lighting::TermSet::all());
        Panel panel;
        for (const Symbol& symbol : equation(terms_, full))
            panel.equation.push_back({symbol.text, tone(symbol.state)});
        panel.message = message_;
        if (!legend_)
            return panel;
        for (const lighting::TermInfo& row : lighting::terms())
            panel.rows.push_back(termRow(row, full));
        panel.rows.emplace_back();
        for (const Text& help : keyHelp)
            panel.rows.push_back({{tell(help), Tone::plain}});
        if (view_.animated())
            panel.rows.push_back({{tell(animationHelp), Tone::plain}});
        return panel;
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
        const bool on = terms_.has(row.term);
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
    lighting::TermSet terms_;
    double time_;
    std::string message_;
    int redraws_ = 2;
    bool playing_ = false;
    bool legend_ = true;
    bool minimised_ = false;
    bool leave_ = false;
    Clock::time_point last_;
};

}  // namespace

void runLive(View& view, Window& window, const Options& options) { Live(view, window, options).run(); }

}  // namespace lab
