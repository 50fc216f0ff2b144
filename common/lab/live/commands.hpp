// Commands: a line of text in, a line of text out. What keys, panel and stdin say, and what tests say.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/history.hpp"
#include "lab/live/session.hpp"
#include "lab/live/state_file.hpp"

#include <span>
#include <string>
#include <vector>

namespace lab {

/// What commands ask for that is not the session's: files, the window, other lessons.
class Host {
  public:
    virtual ~Host() = default;
    /// Writes the picture as it is now; 0 x 0: as large as the window.
    virtual void shot(const std::string& file, int width, int height) = 0;
    virtual SavedState savedState() = 0;
    /// "probe ..." of a point of the picture, 0 to 1 each way, or of the pinned point.
    virtual std::string probe(const std::optional<PanelPoint>& at) = 0;
    /// Pins the probe there, or where the mouse is.
    virtual void pin(const std::optional<PanelPoint>& at) = 0;
    /// What a light costs, in words.
    virtual std::string lightCost() = 0;
    /// Where the panel's things were drawn last, as Window::places.
    virtual std::string places() = 0;
    virtual void fullscreen() = 0;
    /// Goes on with another program once the present command is answered.
    virtual void goTo(const std::string& program, const std::vector<std::string>& arguments) = 0;
    /// Throws UsageError where there is no lesson before this one, to be shown beside it.
    virtual void expectLessonBefore() = 0;
    virtual void leave() = 0;
};

/// Who said a command: what many small moves say is one step of undo.
struct Said {
    bool byHand = false;  ///< dragged on the panel or the picture
};

/// Understands commands.
class Commands {
  public:
    Commands(Session& session, Host& host, const std::string& program)
        : session_(session), host_(host), program_(program) {}

    /// Does what the line says and answers in one line that starts "ok", "error" or "probe". Never throws for a wrong line.
    /// An empty line, or one that starts with '#', has no answer.
    std::string run(const std::string& line, Said said = {});
    /// A movement by hand is over.
    void endGesture() { history_.endGesture(); }
    /// For changes that are no command: the state before the change.
    void changed(const State& before, const std::string& gesture) {
        history_.changed(before, session_.state(), gesture);
    }
    int chosenSlider() const { return slider_; }

  private:
    using Words = std::span<const std::string>;
    struct Action {
        const char* name;
        const char* usage;  ///< what follows the name
        lighting::Text help;
        std::string (Commands::*run)(Words words);
    };
    static std::span<const Action> actions();

    std::string dispatch(const std::vector<std::string>& words);
    std::optional<std::string> control(Words words);
    void expectSplit();
    std::string withSlider(Words words);
    std::string withLight(Words words);
    std::string withTerms(Words words);
    std::string choose(Words words);
    std::string only(Words words);
    std::string shot(Words words);
    std::string save(Words words);
    std::string load(Words words);
    std::string state(Words words);
    std::string undo(Words words);
    std::string redo(Words words);
    std::string reset(Words words);
    std::string probe(Words words);
    std::string pin(Words words);
    std::string unpin(Words words);
    std::string next(Words words);
    std::string previous(Words words);
    std::string lesson(Words words);
    std::string open(Words words);
    std::string cost(Words words);
    std::string places(Words words);
    std::string fullscreen(Words words);
    std::string controls(Words words);
    std::string help(Words words);
    std::string quit(Words words);

    Session& session_;
    Host& host_;
    std::string program_;
    History history_;
    int slider_ = 0;  // the one that the arrow keys move
};

}  // namespace lab
