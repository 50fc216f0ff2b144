// `check` in a window: three pictures at the top, the feedback below them.
// SPDX-License-Identifier: MIT
#include "grader/check/feedback.hpp"
#include "grader/check/loops.hpp"
#include "grader/check/trio.hpp"
#include "grader/check/worker.hpp"
#include "grader/judge/evidence.hpp"
#include "lighting/views.hpp"
#include "render/render_target.hpp"

#include <algorithm>
#include <iostream>

namespace grader {

namespace {

namespace fs = std::filesystem;
using Kind = lab::Event::Kind;

constexpr double lineHeight = 1.25;  // heights of a letter
constexpr double share = 0.45;  // of the window that the feedback may have

// The folder of a file, or a folder and those in it: what editors save into.
std::vector<std::string> foldersOf(const fs::path& file) {
    std::error_code error;
    if (!fs::is_directory(file, error))
        return {file.parent_path().string()};
    constexpr std::size_t most = 64;
    std::vector<std::string> folders{file.string()};
    fs::recursive_directory_iterator entries(file, error), end;
    for (; !error && entries != end && folders.size() < most; entries.increment(error)) {
        if (!entries->is_directory(error) || entries->is_symlink(error))
            continue;
        if (entries->path().filename().string().starts_with('.'))
            entries.disable_recursion_pending();
        else
            folders.push_back(entries->path().string());
    }
    return folders;
}

class CheckWindow {
  public:
    CheckWindow(const CheckRequest& request, lab::Window& window)
        : request_(request), window_(window), style_(request.style),
          worker_(request.grading, request.file, [&window] { window.wake(); }) {
        window_.watch(foldersOf(request_.file));
    }

    void run() {
        while (!closed_) {
            takeRound();
            draw();
            for (const lab::Event& event : window_.events(true))
                take(event);
        }
    }

  private:
    const char* say(const char* english, const char* italian) const {
        return grader::say(request_.grading.language, english, italian);
    }

    void takeRound() {
        std::optional<Round> round = worker_.take();
        if (!round)
            return;
        if (round->fatal)
            std::rethrow_exception(round->fatal);
        note_ = round->trouble;
        if (!round->trouble.empty())
            return;
        graded_ = std::move(round->graded);
        window_.setTitle(graded_->report.lesson + " - check");
        trios_ = triosOf(*graded_);
        shown_ = 0;
        stale_ = true;
        std::cout << textOf(*graded_) << "\n" << std::flush;
    }

    void take(const lab::Event& event) {
        if (event.kind == Kind::close)
            closed_ = true;
        if (event.kind == Kind::file) {
            window_.watch(foldersOf(request_.file));  // there may be new folders
            worker_.look();
        }
        if (event.kind == Kind::key)
            press(event.key);
    }

    void press(int key) {
        switch (key) {
        case lab::keyEscape:
            closed_ = true;
            break;
        case 'R':
            worker_.look(true);
            break;
        case 'T':
            style_.light = !style_.light;
            stale_ = true;
            break;
        case '+':
        case '-':
            style_.fontSize = std::clamp(style_.fontSize + (key == '+' ? 2 : -2), 16, 48);
            stale_ = true;
            break;
        case lab::keyTab:
            shown_ = trios_.empty() ? 0 : (shown_ + 1) % trios_.size();
            stale_ = true;
            break;
        case lab::keyF2:
            save();
            break;
        case lab::keyF11:
            window_.toggleFullscreen();
            break;
        default:
            break;
        }
    }

    void save() {
        if (trios_.empty())
            return;
        const std::string file = request_.picture.empty() ? "check.png" : request_.picture;
        try {
            writePicture(file, trios_[shown_], graded_->report);
            note_ = say("saved: ", "salvata: ") + file;
        } catch (const image::Error& error) {
            note_ = error.what();
        }
    }

    void draw() {
        int width = 0, height = 0;
        window_.framebufferSize(width, height);
        if (width < 1 || height < 1)
            return;
        const bool resized = target_ == nullptr || target_->width() != width || target_->height() != height;
        lab::Panel shown = panel(width, height);
        const double line = lineHeight * style_.fontSize;
        const Places places = placesIn(width, height, style_.fontSize * 7 / 4,
                                       static_cast<int>(line * (static_cast<double>(shown.rows.size()) + 2)));
        captions(shown, width, height, places);
        stale_ = stale_ || places != places_;
        places_ = places;
        if (resized)
            target_ =
                std::make_unique<render::RenderTarget>(width, height, render::PixelFormat::codes, false);
        if (resized || stale_)
            target_->write(
                drawn(trios_.empty() ? nullptr : &trios_[shown_], width, height, places, style_.light));
        stale_ = false;
        target_->show();
        window_.show(shown);
    }

    lab::Panel panel(int width, int height) const {
        lab::Panel panel;
        panel.style = style_;
        const bool differs = !trios_.empty() && !allRight(graded_->report);
        // About as many letters as fit; beside the legend where there is one.
        const double room = width * (differs ? 0.72 : 0.95) / (0.56 * style_.fontSize);
        const auto letters = static_cast<std::size_t>(std::max(24.0, room));
        const auto most = static_cast<std::size_t>(height * share / (lineHeight * style_.fontSize));
        if (graded_)
            panel.rows = linesOf(*graded_, letters, most);
        if (worker_.busy()) {  // in place of the old verdict, so that nothing moves
            panel.rows.resize(std::max<std::size_t>(panel.rows.size(), 1));
            panel.rows[0] = {
                {graded_ ? say("\u2026 building what was saved", "\u2026 compilo ciò che è stato salvato")
                         : say("\u2026 building for the first time", "\u2026 compilo per la prima volta"),
                 lab::Tone::active}};
        }
        for (const std::string& line : wrapped(harmless(note_), letters))
            if (!line.empty())
                panel.rows.push_back({{line, lab::Tone::plain}});
        std::string keys = say(
            "R build again \u00b7 F2 save the picture \u00b7 + - letters \u00b7 T theme \u00b7 Esc close",
            "R ricompila \u00b7 F2 salva l'immagine \u00b7 + - caratteri \u00b7 T tema \u00b7 Esc chiude");
        if (trios_.size() > 1)
            keys += say(" \u00b7 Tab the other pictures", " \u00b7 Tab le altre immagini");
        for (const std::string& line : wrapped(keys, letters))
            panel.rows.push_back({{line, lab::Tone::idle}});
        if (differs && trios_[shown_].pictures[2].width > 0)
            panel.legend = legend();
        return panel;
    }

    void captions(lab::Panel& panel, int width, int height, const Places& places) const {
        std::array<std::string, 3> words{say("mine", "la mia"), say("expected", "attesa"),
                                         say("difference", "differenza")};
        if (trios_.empty())
            return;
        if (trios_[shown_].pictures[0].width == 0)
            words[0] += say(": there is none", ": non c'è");
        if (worker_.busy())
            words[0] += say(" (before the save)", " (prima del salvataggio)");
        if (!trios_[shown_].view.empty())
            words[1] += " (" + trios_[shown_].view + ")";
        for (std::size_t i = 0; i < words.size(); ++i)
            panel.tags.push_back({{static_cast<double>(places.left[i] + style_.fontSize / 4) / width,
                                   places.top * 0.5 / height},
                                  words[i]});
    }

    lab::PanelLegend legend() const {
        lab::PanelLegend legend{say("difference, codes from 0 to 255", "differenza, codici da 0 a 255"), {}};
        for (const lighting::LegendEntry& entry : lighting::legend(lighting::ViewMode::difference))
            legend.entries.push_back(
                {{entry.color.x, entry.color.y, entry.color.z}, say(entry.text.en, entry.text.it)});
        return legend;
    }

    const CheckRequest& request_;
    lab::Window& window_;
    lab::PanelStyle style_;
    std::optional<Graded> graded_;
    std::vector<Trio> trios_;
    std::size_t shown_ = 0;  // of them
    Places places_;
    std::string note_;
    bool closed_ = false, stale_ = true;
    std::unique_ptr<render::RenderTarget> target_;
    Worker worker_;  // last: it wakes the window
};

}  // namespace

int checkInWindow(const CheckRequest& request, lab::Window& window) {
    CheckWindow(request, window).run();
    return AllRight;
}

}  // namespace grader
