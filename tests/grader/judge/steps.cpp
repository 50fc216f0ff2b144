// Steps of a lesson: passed where the frames are right; else told apart by the scene behind the frames.
// SPDX-License-Identifier: MIT
#include "grader/judge/steps.hpp"

#include "grader/judge/aspect_words.hpp"

#include <algorithm>
#include <set>

namespace grader {

namespace {

int numberOf(const std::string& lesson) { return std::atoi(lesson.c_str() + std::string("lesson_").size()); }

// What a step needs is a frame that did not come back.
bool needs(const StepCheck& step, const View& view) {
    return step.variants.empty() ||
           std::find(step.variants.begin(), step.variants.end(), view.variant->id) != step.variants.end();
}

// Whether the aspect is a place that --jitter moved: a number that nobody wrote helps nobody.
bool isMoved(const View& view, const std::string& aspect) {
    return std::find(view.options.begin(), view.options.end(), "--jitter") != view.options.end() &&
           (aspect.ends_with(".place") || aspect.ends_with(".position") || aspect.ends_with(".direction"));
}

void grade(Check& check, double share) {
    check.score = check.maxScore * share;
    check.status = share >= 1 ? CheckStatus::pass : share > 0 ? CheckStatus::partial : CheckStatus::fail;
}

}  // namespace

Explanation explanationOf(const std::vector<std::string>& ids, const Texts& texts, Language language) {
    Explanation result;
    result.ids = ids;
    const MisconceptionText* first = &texts.misconception(ids.front());
    try {
        const MisconceptionText& text = texts.textOf(ids);
        result.name = text.name.in(language);
        result.hint = text.hint.in(language);
        result.convention = text.convention.in(language);
        return result;
    } catch (const std::out_of_range&) {  // no class of the catalogue, but these pictures cannot split them
        for (const std::string& id : ids)
            result.name += (result.name.empty() ? "" : say(language, ", or ", ", oppure ")) +
                           texts.misconception(id).name.in(language);
        result.hint = first->hint.in(language);
        return result;
    }
}

void show(const Evidence& evidence, const std::optional<WorstPixel>& worst, Language language,
          PartVerdict& verdict) {
    for (Check& check : verdict.checks) {
        check.regions = evidence.regions();
        if (check.status == CheckStatus::pass)
            continue;
        if (check.hint.empty())
            check.hint = say(language,
                             "Reread the slides named here and the starter's TODO, and compare the pictures.",
                             "Rileggi le slide indicate e il TODO di partenza, e confronta le immagini.");
        check.worst = worst;
        for (const Picture& picture : verdict.pictures)
            check.images.push_back(picture.image.id);
    }
}

Steps::Steps(const Rubric& rubric, const Texts& texts, Language language, std::vector<View> views,
             const std::vector<std::shared_ptr<const THREE::LoadedScene>>& scenes, Show show)
    : rubric_(rubric), texts_(texts), language_(language), show_(show), views_(std::move(views)) {
    for (std::size_t i = 0; i < views_.size(); ++i)
        expected_.emplace_back(scenes[i], rubric.size, lighting::Switches(), views_[i].name);
}

void Steps::prepare() const {
    if (explainer_ != nullptr)
        return;
    std::vector<const ExpectedFrame*> frames;
    for (const ExpectedFrame& frame : expected_)
        frames.push_back(&frame);
    explainer_ = std::make_unique<Explainer>(frames, numberOf(rubric_.lesson));
}

Check Steps::start(const StepCheck& step) const {
    Check check;
    check.id = step.id;
    check.title = step.title.in(language_);
    check.slides = step.slides;
    check.maxScore = step.points;
    check.isNew = step.isNew;
    check.dependsOn = {"runs"};
    check.expected = step.expected.in(language_);
    return check;
}

// The student's scenes, if they give the student's frames: what differs in them from the lesson's, at any view.
std::optional<Steps::Differences> Steps::differences(const std::vector<std::vector<float>>& found,
                                                     const SceneAt& sceneAt) const {
    Differences all;
    all.scenes.resize(views_.size());
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (found[i].empty())
            continue;
        const auto scene = all.scenes[i] = sceneAt(i);
        if (scene == nullptr || scene->camera == nullptr)
            return std::nullopt;
        const ExpectedFrame drawn(scene, rubric_.size, lighting::Switches(), "");
        if (!compare(drawn, found[i]).right())
            return std::nullopt;
        for (const auto& [name, aspect] : compareScenes(*expected_[i].scene().scene, *scene->scene)) {
            Aspect& one = all.aspects.emplace(name, aspect).first->second;
            if (one.right && !aspect.right)
                one = aspect;
            if (isMoved(views_[i], name) && one.found != "none")
                one.found.clear();
        }
    }
    return all.aspects.empty() ? std::nullopt : std::optional(std::move(all));
}

// With the numbers of the student's own scene, where it is known: the lesson's would be the solution's.
std::optional<WorstPixel> Steps::worstPixel(const Evidence& evidence,
                                            const std::optional<Differences>& known) const {
    std::optional<WorstPixel> worst = evidence.worstPixel();
    if (!worst)
        return worst;
    worst->numbers.clear();
    worst->ownScene = true;
    if (known && known->scenes[evidence.worstFrame()] != nullptr)
        worst->numbers =
            ExpectedFrame(known->scenes[evidence.worstFrame()], rubric_.size, lighting::Switches(), "")
                .numbersAt(worst->x, worst->y);
    return worst;
}

// The names that no check means: those of "*".
std::vector<std::string> Steps::restOf(const Aspects& all) const {
    std::vector<std::string> names;
    for (const auto& aspect : all) {
        const std::string& name = aspect.first;
        const bool taken =
            std::any_of(rubric_.steps.begin(), rubric_.steps.end(), [&](const StepCheck& step) {
                return isMeant(step.aspects, name) || isMeant(step.keeps, name);
            });
        if (!taken)
            names.push_back(name);
    }
    return names;
}

void Steps::judgeByScene(const StepCheck& step, const Aspects& aspects, Check& check) const {
    const bool rest = std::find(step.aspects.begin(), step.aspects.end(), "*") != step.aspects.end();
    std::vector<std::string> names, wrong;
    for (const auto& [name, aspect] : aspects)
        if (isMeant(step.aspects, name) || (!aspect.right && isMeant(step.keeps, name)))
            names.push_back(name);
    if (rest)
        for (const std::string& name : restOf(aspects))
            names.push_back(name);
    for (const std::string& name : names)
        if (!aspects.at(name).right)
            wrong.push_back(inWords(name, aspects.at(name), language_));
    const double share =
        names.empty() ? 1 : 1 - static_cast<double>(wrong.size()) / static_cast<double>(names.size());
    grade(check, rest && share < 1 ? 0 : share);  // of all the rest most is right whatever one does
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < std::min(most, wrong.size()); ++i)
        check.message += (i == 0 ? "" : "; ") + wrong[i];
    if (wrong.size() > most)
        check.message += say(language_, "; and more", "; e altro");
}

std::optional<Explanation> Steps::explanation(const std::vector<std::vector<float>>& found) const {
    prepare();
    const Explainer::Fit fit = explainer_->explain(found);
    if (fit.ids.size() != 1)
        return std::nullopt;
    Explanation result = explanationOf(fit.ids[0], texts_, language_);
    result.explained = fit.explained;
    result.confidence = fit.confidence;
    return result;
}

// Why a frame that the step needs did not come back, or nothing.
std::string Steps::missingFor(const StepCheck& step, const Evidence& evidence,
                              const std::vector<std::string>& problems) const {
    for (std::size_t i = 0; i < views_.size(); ++i)
        if (!evidence.there(i) && needs(step, views_[i]) && step.isNew)
            return views_[i].name + ": " + problems[i];
    return "";
}

PartVerdict Steps::judge(const std::vector<std::vector<float>>& found,
                         const std::vector<std::string>& problems, const SceneAt& sceneAt) const {
    const Evidence evidence(expected_, found);
    const bool right = evidence.right();
    const std::optional<Differences> byScene = right ? std::nullopt : differences(found, sceneAt);
    PartVerdict verdict;
    for (const StepCheck& step : rubric_.steps) {
        Check check = start(step);
        const std::string missing = missingFor(step, evidence, problems);
        if (!missing.empty() || (!right && !byScene)) {
            grade(check, 0);
            check.message =
                !missing.empty()
                    ? say(language_, "a frame is missing: ", "manca un'immagine: ") + missing
                    : say(language_,
                          "the picture is not as expected, nor what the program's own scene would give",
                          "l'immagine non è quella attesa, né quella che la scena del programma darebbe");
        } else if (right) {
            grade(check, 1);
            check.message =
                say(language_, "the picture is right in all views", "l'immagine è giusta in tutte le viste");
        } else {
            judgeByScene(step, byScene->aspects, check);
            if (check.status == CheckStatus::pass)
                check.message =
                    say(language_, "this part of the scene is right", "questa parte della scena è giusta");
        }
        verdict.checks.push_back(std::move(check));
    }
    verdict.pictures = evidence.pictures("lesson", language_, show_);
    if (right)
        return verdict;
    show(evidence, worstPixel(evidence, byScene), language_, verdict);
    const auto first = std::find_if(verdict.checks.begin(), verdict.checks.end(), [](const Check& check) {
        return check.isNew && check.status != CheckStatus::pass;
    });
    if (explains && first != verdict.checks.end())
        first->explanation = explanation(found);
    return verdict;
}

}  // namespace grader
