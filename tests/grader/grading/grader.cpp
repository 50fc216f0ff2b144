// What all submissions of a lesson have in common.
// SPDX-License-Identifier: MIT
#include "grader/grading/grader.hpp"

#include "grader/grading/drawings.hpp"
#include "grader/judge/unseen.hpp"
#include "grader/submission/hash.hpp"
#include "image/home.hpp"
#include "starter.hpp"

#include <algorithm>

namespace grader {

namespace {

namespace fs = std::filesystem;

nuovo::Lesson lessonCalled(const fs::path& share, const std::string& asked) {
    try {
        return nuovo::findStarter(nuovo::readLessons(share / "lessons"), asked);
    } catch (const nuovo::NoStarter& error) {
        throw UsageError(error.what());
    }
}

Rubric rubricFor(const nuovo::Lesson& lesson, const fs::path& share, const fs::path& asked) {
    try {
        const fs::path own = share / "lessons" / (lesson.stem + ".rubric.json");
        Rubric rubric = Rubric::read(asked.empty() ? own : asked);
        if (rubric.lesson != lesson.stem)
            throw std::runtime_error(asked.string() + ": lesson: expected \"" + lesson.stem + "\", found \"" +
                                     rubric.lesson + "\"");
        return rubric;
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

// Submissions can read all of /usr: a program that includes the lesson from there would be the lesson.
void refuseWithinReach(const fs::path& lessons) {
    const std::string real = fs::weakly_canonical(lessons).string();
    if (real.starts_with("/usr/") && !real.starts_with("/usr/local/"))
        throw UsageError(real +
                         ": submissions can read what is below /usr, and so the solutions; install the lab "
                         "elsewhere, as with --prefix /usr/local or /opt/lambert-lab");
}

// Apart from all scenes that a rubric's seed gives: students see none of those.
constexpr std::uint64_t publicScenes = std::uint64_t{1} << 63;

// What stands between semicolons and braces.
std::vector<std::string> statementsOf(const std::string& text) {
    std::vector<std::string> statements;
    const std::string bare = withoutComments(text);
    for (std::size_t at = 0; at < bare.size();) {
        const std::size_t end = std::min(bare.find_first_of(";{}\n", at), bare.size());
        if (end > at)
            statements.push_back(bare.substr(at, end - at));
        at = end + 1;
    }
    return statements;
}

Show showOf(const GraderOptions& options) { return options.publicViews ? Show::always : Show::wrong; }
bool italian(const GraderOptions& options) { return options.language == Language::it; }

}  // namespace

Grader::Grader(const GraderOptions& options)
    : options_(options), share_(image::home() / "share/lambert-lab"),
      texts_(share_ / "slides_refs/misconceptions.json"), shaders_(labShaders()) {
    if (!options.publicViews)
        refuseWithinReach(share_ / "lessons");
    readLesson();
    if (options.size > 0)
        rubric_.size = options.size;
    for (const TermCheck& check : rubric_.terms)
        try {
            texts_.check(check.id);
        } catch (const std::out_of_range& error) {
            throw UsageError(rubric_.lesson + ": terms: " + error.what());
        }
    confinement_ =
        options.walls ? std::make_unique<Confinement>(*options.walls) : std::make_unique<Confinement>();
    kit_ = std::make_unique<Kit>(findKit());
    hashTool();
    std::vector<View> views = options.publicViews ? publicViews(rubric_, italian(options))
                                                  : hiddenViews(rubric_, seed(), italian(options));
    const auto scenes = lessonScenes(views);
    lessonScene_ = scenes.front();
    steps_ =
        std::make_unique<Steps>(rubric_, texts_, options.language, std::move(views), scenes, showOf(options));
    refuseBlindViews();
    tryLesson();
}

Grader::~Grader() = default;

std::uint64_t Grader::seed() const {
    return options_.publicViews ? rubric_.seed ^ publicScenes : options_.seed.value_or(rubric_.seed);
}

const Terms& Grader::terms() const {
    if (terms_ == nullptr)
        terms_ = std::make_unique<Terms>(rubric_, texts_, options_.language, seed(), lessonScene_,
                                         showOf(options_));
    return *terms_;
}

Drawing Grader::lessonDrawing() const { return drawingOf(rubric_, programBytes(rubric_.lesson), shaders_); }

// The lesson's texts: title, starters, what every right submission has in it.
void Grader::readLesson() {
    const nuovo::Lesson lesson = lessonCalled(share_, options_.lesson);
    rubric_ = rubricFor(lesson, share_, options_.rubric);
    title_ = lesson.title;
    expectations_.lesson = lesson.stem;
    noteCommon("lesson",
               withoutComments(fileBytes(lesson.file)));  // its very bytes are no student's own work
    for (const auto& [name, text] : shaders_) {
        expectations_.shaders.push_back(name);
        noteCommon(name, text);
    }
    for (const std::string& required : rubric_.required)
        expectations_.keepNeutral = expectations_.keepNeutral || required != "lesson";
    for (const char* lang : {"it", "en"}) {
        const nuovo::Folder starter =
            nuovo::makeStarter(lesson, share_ / "slides_refs/tasks.json", share_ / "shaders", lang);
        expectations_.starters.emplace_back();
        for (const auto& [name, text] : starter) {
            expectations_.starters.back()[name] = text;
            noteCommon(name == lesson.stem + ".cpp" ? "lesson" : name, text);
        }
    }
}

void Grader::noteCommon(const std::string& part, const std::string& text) {
    common_.insert({sha256(text), sha256(withoutComments(text))});
    for (std::string& statement : statementsOf(text))
        statements_[part].insert(std::move(statement));
}

std::size_t Grader::ownText(const std::string& part, const std::string& text) const {
    const auto known = statements_.find(part);
    std::size_t own = 0;
    for (const std::string& statement : statementsOf(text))
        if (known == statements_.end() || known->second.count(statement) == 0)
            own += statement.size();
    return own;
}

void Grader::hashTool() {
    std::string all =
        sha256(fileBytes("/proc/self/exe")) + sha256(fileBytes(share_ / "slides_refs/misconceptions.json")) +
        sha256(fileBytes(share_ / "slides_refs/tasks.json")) + sha256(fileBytes(kit_->library)) +
        sha256(programBytes(rubric_.lesson)) + std::to_string(options_.seed.value_or(rubric_.seed)) +
        (options_.publicViews ? "public" : "hidden") + (italian(options_) ? "it" : "en") +
        name(confinement_->walls());
    for (const auto& [name, text] : shaders_)
        all += sha256(name) + sha256(text);
    toolHash_ = sha256(all);
}

// The lesson's own scenes, as its program writes them.
std::vector<std::shared_ptr<const THREE::LoadedScene>>
Grader::lessonScenes(const std::vector<View>& views) const {
    std::vector<std::shared_ptr<const THREE::LoadedScene>> scenes;
    Drawing drawing = lessonDrawing();
    for (const View& view : views) {
        const Dump dump = dumpAt(*confinement_, *kit_, drawing, view);
        if (!dump.problem.empty())
            throw std::runtime_error("the lesson's own program gives no scene: " + dump.problem +
                                     ". It says: " + dump.outcome.said + dump.outcome.trouble);
        scenes.push_back(loadScene(dump.scene));
    }
    return scenes;
}

// Views that do not show what a step asks for would give its points to everybody.
void Grader::refuseBlindViews() const {
    if (options_.publicViews)
        return;
    std::string list;
    for (const std::string& one : unseen(rubric_, steps_->expected()))
        list += (list.empty() ? "" : ", ") + one;
    if (!list.empty())
        throw UsageError(rubric_.lesson + ": views: with seed " + std::to_string(seed()) +
                         " no hidden view shows " + list +
                         "; expected each to be seen in one at least. Change the rubric's look_at, distance, "
                         "azimuth_degrees, height_degrees, fov or count");
}

// Before anybody is judged: the lab's own lesson must come out right, drawn here and now as submissions are.
void Grader::tryLesson() {
    Drawing drawing = lessonDrawing();
    drawing.words = {"--stats"};
    drawing.lines = {lineOf(steps_->views().front())};
    const Frames drawn = draw(*confinement_, *kit_, drawing);
    const std::vector<float>& frame = drawn.frames.front();
    if (frame.empty() || !compare(steps_->expected().front(), frame).right())
        throw std::runtime_error(
            "the lab's own " + rubric_.lesson + " does not come out right on this machine: " +
            (frame.empty() ? drawn.problems.front() : "its frame is not the expected one") +
            ". It says: " + drawn.outcome.said + drawn.outcome.trouble + " Nobody is graded.");
    const std::string key = "\"renderer\":\"";
    const std::size_t begin = drawn.outcome.said.find(key);
    if (begin != std::string::npos)
        renderer_ = drawn.outcome.said.substr(
            begin + key.size(), drawn.outcome.said.find('"', begin + key.size()) - begin - key.size());
}

void Grader::prepare() const {
    steps_->prepare();
    terms().prepare();
}

}  // namespace grader
