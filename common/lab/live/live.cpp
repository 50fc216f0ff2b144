// The window's loop: events to commands, and drawing only what changed.
// SPDX-License-Identifier: MIT
#include "lab/live/live.hpp"

#include "lab/equation.hpp"
#include "lab/failure.hpp"
#include "lab/live/commands.hpp"
#include "lab/live/gestures.hpp"
#include "lab/live/keys.hpp"
#include "lab/live/panel_builder.hpp"
#include "lab/live/probe_text.hpp"
#include "lab/live/screen.hpp"
#include "lab/live/side_prober.hpp"
#include "lab/live/values.hpp"
#include "lab/scene_files.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <optional>
#include <utility>

namespace lab {

namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

class Live final : public Host {
  public:
    Live(View& view, const Options& options, Handover& handover)
        : options_(options), handover_(handover), window_(*handover.window), session_(view, options),
          commands_(session_, *this, options.lesson), screen_(options, window_) {
        facts_.program = options.lesson;
        facts_.slides = slidesOf(options.lesson);
        window_.setTitle(options.lesson);
        std::vector<std::string> folders = screen_.shaderFolders();
        if (!options.sceneFile.empty())
            folders.push_back(folderOf(options.sceneFile));
        window_.watch(folders);
    }

    void run() {
        pending_ = std::exchange(handover_.pending, {});
        for (loop(nullptr); !leave_; loop(nullptr))
            showLessonBefore();
        handover_.pending = std::move(pending_);
    }

  private:
    // ---- the loop

    // `before`: the lesson before this one, while its picture is shown beside.
    void loop(View* before) {
        before_ = before;
        while (goesOn(before)) {
            if (pictureChanged_ || panelChanged_ > 0)
                draw();
            const bool still = !pictureChanged_ && panelChanged_ == 0 && !(moving() && !minimised_) &&
                               !screen_.prepare(session_);
            for (Event& event : window_.events(still && pending_.empty()))
                pending_.push_back(std::move(event));
            handlePending(before);
            step();
        }
        before_ = nullptr;
    }

    bool goesOn(const View* before) const {
        return !leave_ && (session_.split == Split::lesson) == (before != nullptr);
    }

    // What was said after a change of lesson, or of what is shown beside, is for whoever comes then.
    void handlePending(const View* before) {
        while (!pending_.empty() && goesOn(before)) {
            const Event event = std::move(pending_.front());
            pending_.pop_front();
            handle(event);
        }
    }

    bool moving() const { return session_.playing || gestures_.coasting(); }

    // Time goes on, from where it was when things began to move.
    void step() {
        const Clock::time_point now = Clock::now();
        constexpr double most = 0.25;  // a window that was hidden goes on from where it was
        const double passed = moved_ ? std::min(seconds(now - last_), most) : 0;
        last_ = now;
        if (session_.playing)
            session_.time += passed;
        pictureChanged_ |= gestures_.coast(passed);
        const Screen::News news = screen_.news();
        pictureChanged_ |= moving() || news == Screen::News::picture;
        if (news == Screen::News::panel)
            panelChanged_ = std::max(panelChanged_, 1);
        moved_ = moving();
    }

    // The lesson before runs inside of this one's loop, as its guest, for as long as it is shown.
    void showLessonBefore() {
        try {
            const std::string name = neighbour(options_.lesson, -1);
            facts_.before = name;
            Handover guest{handover_.window, {}, {}, {}, [this](View& view) { loop(&view); }};
            runProgram(name, {}, guest);
        } catch (const UsageError& error) {
            answer(std::string("error split: ") + error.what());
            session_.split = Split::off;
        }
        pictureChanged_ = true;
    }

    // ---- what happens

    void handle(const Event& event) {
        panelChanged_ = 2;  // a panel's new size settles in the second
        switch (event.kind) {
        case Event::Kind::key:
            return say(commandOf(event), {});
        case Event::Kind::command:
            return say(event.text, {.byHand = true});
        case Event::Kind::line:
            return line(event.text);
        case Event::Kind::drag:
        case Event::Kind::pan:
        case Event::Kind::wheel:
            pictureChanged_ = true;
            return gestures_.moveCamera(event);
        case Event::Kind::release:
            return gestures_.release();
        case Event::Kind::hover:
            mouse_ = PanelPoint{event.x, event.y};
            return;
        case Event::Kind::leave:
            mouse_.reset();
            return;
        case Event::Kind::handle:
            return say(gestures_.moveLight(event), {.byHand = true});
        case Event::Kind::divider:
            return say("divider " + numbersText({std::clamp(event.x, 0.0, 1.0)}), {.byHand = true});
        case Event::Kind::file:
            return fileChanged(event.text);
        case Event::Kind::redraw:
            return;
        case Event::Kind::close:
            leave_ = true;
            return;
        case Event::Kind::endOfLines:
            return;  // whoever spoke has gone; the window stays
        }
    }

    // What a key or the panel says; the answer is told on the panel, and on stdout for those who cannot see it, without the word that
    // starts an answer to a line of stdin.
    void say(const std::string& command, Said said) {
        if (command.empty())
            return;
        const std::string answered = run(command, said);
        answer(answered);
        std::cout << (answered.starts_with("probe") ? answered : answered.substr(answered.find(' ') + 1))
                  << std::endl;
        if (command.starts_with("term"))
            std::cout << equationText(session_.switches.terms, facts_.drawn.shiny) << std::endl;
    }

    void line(const std::string& text) {
        const std::string answered = run(text, {});
        if (answered.empty())
            return;
        std::cout << answered << std::endl;
        answer(answered);
    }

    // A question, the theme or the list of keys change no picture: a reference that is being evaluated goes on. But a state is told without
    // the jitter, which the next update puts on again.
    std::string run(const std::string& command, Said said) {
        const State before = session_.state();
        std::string answered = commands_.run(command, said);
        pictureChanged_ |= session_.state() != before || session_.view().jitter();
        return answered;
    }

    // On the panel "ok" goes without saying; the probe has a place of its own, and long answers are for stdout.
    void answer(const std::string& text) {
        constexpr std::size_t longest = 80;
        const bool wrong = text.starts_with("error");
        facts_.message = {text.starts_with("ok ") ? text.substr(3) : text, wrong ? Tone::wrong : Tone::title};
        if (!wrong && (text.size() > longest || text.starts_with("probe") || text.starts_with("ok state")))
            facts_.message.text.clear();
        facts_.chosenSlider = commands_.chosenSlider();
    }

    void fileChanged(const std::string& file) {
        std::optional<std::string> wrong = screen_.reload(file);
        if (!wrong && !options_.sceneFile.empty() && sameFile(file, options_.sceneFile)) {
            wrong.emplace();
            if (const std::optional<Failure> failure =
                    attempt([&] { goTo("scene_viewer", {options_.sceneFile}); }))
                wrong = messageOf(*failure, options_.sceneFile);
        }
        if (!wrong)
            return;
        answer(wrong->empty() ? "ok reload " + file : "error " + *wrong);
        if (!wrong->empty())
            std::cerr << options_.lesson << ": " << *wrong << std::endl;
        else
            reloaded_ = Clock::now();
        pictureChanged_ = true;
    }

    // How long a changed shader took.
    void tellReload() {
        if (!reloaded_ || screen_.waiting() || screen_.problem())
            return;
        std::cout << "reload: on screen after "
                  << valueText(std::round(1000 * seconds(Clock::now() - *reloaded_))) << " ms" << std::endl;
        reloaded_.reset();
    }

    // ---- Host

    void shot(const std::string& file, int width, int height) override {
        if (width == 0 && !screen_.size(width, height))
            throw UsageError("the window has no size now; expected WIDTHxHEIGHT after the file name");
        screen_.write(session_, before_, file, width, height);
        pictureChanged_ = true;
    }
    SavedState savedState() override {
        SavedState state{options_.lesson, options_.sceneFile, 960, 600, session_.state()};
        screen_.size(state.width, state.height);
        return state;
    }
    std::string probe(const std::optional<PanelPoint>& at) override {
        if (pictureChanged_)
            draw();
        const std::optional<ProbeReport> report = look(at);
        if (!report)
            throw UsageError(at ? "expected a point of the picture"
                                : "no point is pinned; expected X Y, or pin X Y before");
        return probeText(*report, session_.language);
    }
    void pin(const std::optional<PanelPoint>& at) override {
        if (pictureChanged_)
            draw();
        const std::optional<PanelPoint> where = at ? at : mouse_;
        const std::optional<ProbeReport> report = where ? look(where) : std::nullopt;
        if (!report || !report->point)
            throw UsageError(
                "expected a point of a surface, found " +
                std::string(report ? "the background" : "none; move the mouse there, or say where"));
        session_.pin = report->point;
    }
    std::string lightCost() override {
        pictureChanged_ = true;
        return screen_.lightCost(session_);
    }
    std::string places() override {
        draw();
        return window_.places();
    }
    void fullscreen() override { window_.toggleFullscreen(); }
    void goTo(const std::string& program, const std::vector<std::string>& arguments) override {
        // What is wrong is told here, and this picture stays.
        expectProgram(program);
        if (!arguments.empty())
            expectView(loadScene(arguments[0]));
        handover_.program = program;
        handover_.arguments = arguments;
        const auto keep = [this](const std::string& option, const std::string& value) {
            handover_.arguments.push_back(option + "=" + value);
        };
        keep("--lang", session_.language == Language::it ? "it" : "en");
        keep("--presenter", numbersText({session_.fontSize}));
        keep("--theme", session_.lightTheme ? "light" : "dark");
        if (!options_.shaders.empty())
            keep("--shaders", options_.shaders);
        leave_ = true;
    }
    void expectLessonBefore() override { expectProgram(neighbour(options_.lesson, -1)); }
    void leave() override { leave_ = true; }

    // ---- drawing

    // The numbers of a place of the picture, or of the pinned point, with what the driver drew there.
    std::optional<ProbeReport> look(const std::optional<PanelPoint>& at) {
        int width = 0, height = 0;
        if (!screen_.size(width, height))
            return std::nullopt;
        std::optional<ProbeReport> report = prober_.look(session_, before_, at, width, height);
        if (report && report->pixel)
            report->drawn = screen_.pixel(session_, (*report->pixel)[0], (*report->pixel)[1]);
        return report;
    }

    void draw() {
        minimised_ = !screen_.draw(session_, before_, pictureChanged_);
        if (pictureChanged_)
            prober_.changed();
        pictureChanged_ = false;
        panelChanged_ = std::max(0, panelChanged_ - 1);
        if (minimised_)
            return;
        if (const std::optional<std::string>& wrong = screen_.problem())
            answer("error " + *wrong);
        facts_.drawn = screen_.stats();
        facts_.legend = screen_.legend(session_);
        int height = 0;
        screen_.size(facts_.width, height);
        facts_.probe = session_.pin ? look({}) : session_.follow && mouse_ ? look(mouse_) : std::nullopt;
        window_.show(buildPanel(session_, facts_));
        tellReload();
    }

    const Options& options_;
    Handover& handover_;
    Window& window_;
    Session session_;
    Commands commands_;
    Gestures gestures_{session_, commands_};
    Screen screen_;
    SideProber prober_;
    PanelFacts facts_;
    View* before_ = nullptr;
    std::deque<Event> pending_;
    std::optional<PanelPoint> mouse_;
    bool pictureChanged_ = true;  // since the last draw
    int panelChanged_ = 2;
    bool moved_ = false, minimised_ = false, leave_ = false;
    Clock::time_point last_ = Clock::now();
    std::optional<Clock::time_point> reloaded_;  // when shaders were, until they are seen
};

}  // namespace

void runLive(View& view, const Options& options, Handover& handover) { Live(view, options, handover).run(); }

}  // namespace lab
