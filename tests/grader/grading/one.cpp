// One submission on its way from files to a report.
// SPDX-License-Identifier: MIT
#include "grader/grading/drawings.hpp"
#include "grader/grading/grader.hpp"
#include "grader/judge/marks.hpp"
#include "grader/report/text.hpp"
#include "grader/submission/hash.hpp"

#include <chrono>

namespace grader {

namespace {

constexpr std::size_t enoughOwnText = 100;  // characters that two students do not write alike by chance

class Stopwatch {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - start_).count();
        start_ = now;
        return seconds;
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The grader's own trouble while a submission was at hand.
class Trouble : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

std::string digest(const std::vector<std::vector<float>>& frames) {
    std::string all;
    for (const std::vector<float>& frame : frames)
        all.append(reinterpret_cast<const char*>(frame.data()), frame.size() * sizeof(float));
    return sha256(all);
}

}  // namespace

class Grader::One {
  public:
    One(const Grader& grader, const std::filesystem::path& path)
        : grader_(grader), language_(grader.options_.language),
          submission_(readSubmission(path, grader.expectations_, language_)) {}

    Graded run() {
        start();
        try {
            if (!submission_.problem.empty()) {
                report().status = ReportStatus::notGradable;
                report().reason = submission_.problem;
                return std::move(graded_);
            }
            if (!grader_.options_.onlyGiven)
                missingParts();
            if (submission_.lesson)
                lessonPart();
            if (!submission_.shaders.empty())
                termsPart();
            report().status = ReportStatus::graded;
            addUp(report(), grader_.rubric_.points);
        } catch (const Trouble& trouble) {
            report().status = ReportStatus::infrastructure;
            report().reason = trouble.what();
            report().checks.clear();
            graded_.pictures.clear();
            report().score = report().maxScore = 0;
        }
        return std::move(graded_);
    }

  private:
    Report& report() { return graded_.report; }

    void start() {
        Report& report = graded_.report;
        report.toolVersion = LAMBERT_VERSION;
        report.rubricHash = grader_.rubric_.hash;
        report.lesson = grader_.rubric_.lesson;
        report.lessonTitle = grader_.title_;
        report.renderer = grader_.renderer_;
        report.language = language_;
        report.submission = submission_.name;
        report.submissionHash = submission_.hash;
        report.files = submission_.files;
        report.confinement = grader_.confinement_->description();
        report.maxScore = grader_.rubric_.points;
        const auto note = [&](const std::string& part, const std::string& text) {
            const std::size_t own = grader_.ownText(part, text);
            ownText_ += own;
            graded_.files[part] = sha256(text);
            if (own >= enoughOwnText)
                graded_.sources[part] = sha256(withoutComments(text));
        };
        if (submission_.lesson)
            note("lesson", submission_.lesson->text);
        for (const auto& [name, text] : submission_.shaders)
            note(name, text);
    }

    static Check gate(const std::string& id, const std::string& title) {
        Check check;
        check.id = id;
        check.title = title;
        return check;
    }

    // Checks of a part that cannot be looked at.
    void skip(std::vector<Check> checks, CheckStatus status, const std::string& message) {
        for (Check& check : checks) {
            check.status = status;
            check.score = 0;
            check.message = message;
            report().checks.push_back(std::move(check));
        }
    }
    PartVerdict withoutFrames() const {
        const std::vector<std::vector<float>> nothing(grader_.steps_->views().size());
        return grader_.steps_->judge(nothing, std::vector<std::string>(nothing.size()),
                                     [](std::size_t) { return nullptr; });
    }

    void missingParts() {
        for (const std::string& part : grader_.rubric_.required) {
            if (submission_.has(part))
                continue;
            const std::string message =
                part + ": " + say(language_, "was not handed in", "non è stato consegnato");
            if (part == "lesson") {
                skip(withoutFrames().checks, CheckStatus::fail, message);
                continue;
            }
            Check check = gate(part, part);
            for (const TermCheck& term : grader_.rubric_.terms)
                if (part == "terms/" + term.id + ".glsl")
                    check.maxScore = submission_.shaders.empty() ? term.points : 0;
            check.status = CheckStatus::fail;
            check.message = message;
            report().checks.push_back(std::move(check));
        }
    }

    void lessonPart() {
        Stopwatch watch;
        Source source{submission_.lesson->name, submission_.lesson->text, {}};
        for (const NamedText& header : submission_.headers)
            source.headers.emplace_back(header.name, header.text);
        const Built built = build(*grader_.confinement_, *grader_.kit_, source);
        report().compileSeconds += watch.lap();
        report().buildLog = built.log;
        if (built.how == Ended::notStarted)
            throw Trouble(built.trouble);
        Check builds = gate("builds", say(language_, "the program builds", "il programma si compila"));
        builds.status = built.ok ? CheckStatus::pass : CheckStatus::fail;
        if (!built.ok)
            builds.message = say(language_, "the compiler refuses it: see what it says",
                                 "il compilatore lo rifiuta: vedi che cosa dice");
        report().checks.push_back(builds);
        if (!built.ok) {
            PartVerdict verdict = withoutFrames();
            skip(std::move(verdict.checks), CheckStatus::skipped,
                 say(language_, "the program does not build", "il programma non si compila"));
            add(std::move(verdict.pictures));
            return;
        }
        Drawing drawing = drawingOf(grader_.rubric_, built.program, grader_.shaders_);
        for (const View& view : grader_.steps_->views())
            drawing.lines.push_back(lineOf(view));
        const Frames drawn = drawAll(drawing, "runs");
        judge(
            [&] {
                return grader_.steps_->judge(drawn.frames, drawn.problems,
                                             [&](std::size_t view) { return sceneOf(drawing, view); });
            },
            drawn);
    }

    std::shared_ptr<const THREE::LoadedScene> sceneOf(Drawing drawing, std::size_t view) {
        Stopwatch watch;
        drawing.lines.clear();
        const Dump dump =
            dumpAt(*grader_.confinement_, *grader_.kit_, drawing, grader_.steps_->views()[view]);
        report().framesSeconds += watch.lap();
        if (!dump.problem.empty())
            return nullptr;
        try {
            return loadScene(dump.scene);
        } catch (const std::exception&) {  // whatever it is, it explains no frame
            return nullptr;
        }
    }

    void termsPart() {
        std::map<std::string, std::string> shaders = shadersToTryIn(grader_.shaders_);
        for (const auto& [name, text] : submission_.shaders)
            if (withoutComments(text) != withoutComments(grader_.shaders_.at(name)))
                shaders[name] = text;
        const auto& scenes = grader_.terms().scenes();
        Frames all;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            const Frames drawn = drawAll(sceneDrawing(shaders, i, {"all"}), i == 0 ? "draws" : nullptr);
            all.frames.push_back(drawn.frames.front());
            all.problems.push_back(drawn.problems.front());
        }
        judge(
            [&] {
                return grader_.terms().judge(
                    all.frames, all.problems, submission_.untouched,
                    [&](std::size_t scene, const std::vector<std::string>& states) {
                        return drawAll(sceneDrawing(shaders, scene, states), nullptr).frames;
                    });
            },
            all);
    }

    Drawing sceneDrawing(const std::map<std::string, std::string>& shaders, std::size_t scene,
                         const std::vector<std::string>& states) const {
        static const std::string viewer = programBytes("scene_viewer");
        Drawing drawing = drawingOf(grader_.rubric_, viewer, shaders);
        const THREE::LoadedScene& shown = *grader_.terms().scenes()[scene];
        drawing.words = {"in/scene.json"};
        drawing.files = {{"scene.json", THREE::toJSON(*shown.scene, shown.camera)}};
        for (const std::string& state : states)
            drawing.lines.push_back("--terms " + state);
        return drawing;
    }

    // Draws; where `check` names one, says in it whether frames came back, and why not.
    Frames drawAll(const Drawing& drawing, const char* check) {
        Stopwatch watch;
        Frames drawn = draw(*grader_.confinement_, *grader_.kit_, drawing);
        report().framesSeconds += watch.lap();
        if (drawn.outcome.how == Ended::notStarted)
            throw Trouble(drawn.outcome.trouble);
        if (check == nullptr)
            return drawn;
        if (report().said.size() < 4096)
            report().said += drawn.outcome.said;
        Check runs = gate(check, check == std::string("runs")
                                     ? say(language_, "the program draws", "il programma disegna")
                                     : say(language_, "the shaders draw", "gli shader disegnano"));
        runs.status = CheckStatus::pass;
        for (std::size_t i = drawn.frames.size(); i-- > 0;)
            if (drawn.frames[i].empty()) {
                runs.status = CheckStatus::fail;
                runs.message = drawn.problems[i];
            }
        if (runs.status == CheckStatus::fail)
            runs.message = whyNot(drawn.outcome) + runs.message;
        report().checks.push_back(runs);
        return drawn;
    }
    std::string whyNot(const Outcome& outcome) const {
        if (!outcome.limit.empty())
            return outcome.limit + "; ";
        if (outcome.how == Ended::killed)
            return std::string(say(language_, "ended by signal ", "fermato dal segnale ")) +
                   std::to_string(outcome.status) + "; ";
        if (outcome.how == Ended::exited && outcome.status != 0)
            return std::string(say(language_, "ended with status ", "finito con lo stato ")) +
                   std::to_string(outcome.status) + "; ";
        return "";
    }

    template <class Judge>
    void judge(const Judge& part, const Frames& drawn) {
        Stopwatch watch;
        const double drawingBefore = report().framesSeconds;  // to judge, more may have to be drawn
        PartVerdict verdict = part();
        countOldOnlyWithNew(verdict.checks, language_);
        bool right = true;
        for (Check& check : verdict.checks) {
            right = right && check.status == CheckStatus::pass;
            report().checks.push_back(std::move(check));
        }
        if (!right && ownText_ > 0)
            graded_.frames = sha256(graded_.frames + digest(drawn.frames));
        add(std::move(verdict.pictures));
        report().judgeSeconds += watch.lap() - (report().framesSeconds - drawingBefore);
    }
    void add(std::vector<Picture> pictures) {
        for (Picture& picture : pictures) {
            report().images.push_back(picture.image);
            graded_.pictures.push_back(std::move(picture));
        }
    }

    const Grader& grader_;
    Language language_;
    Submission submission_;
    Graded graded_;
    std::size_t ownText_ = 0;
};

std::string Grader::hashOf(const std::filesystem::path& submission) const {
    return readSubmission(submission, expectations_, options_.language).hash;
}

Graded Grader::grade(const std::filesystem::path& submission) const { return One(*this, submission).run(); }

}  // namespace grader
