// Shader terms: passed where the frames are right; else told apart by the catalogue, then one by one.
// SPDX-License-Identifier: MIT
#include "grader/judge/terms.hpp"

#include "grader/catalogue/hidden_scene.hpp"

#include <algorithm>
#include <map>

namespace grader {

namespace {

constexpr const char* neutral =
    "neutral:";  // ids of hypotheses: terms that are their neutral elements, "neutral:cosine,clamp"
constexpr int lastMatteLesson = 8, firstShinyLesson = 9;

// The states (lists for --terms) that show a check alone; one of them must be right.
const std::map<std::string, std::vector<std::string>>& statesOf() {
    static const std::map<std::string, std::vector<std::string>> all{
        {"albedo", {"albedo,ambient", "albedo,directional"}},
        {"cosine", {"cosine,directional", "cosine,point"}},
        {"clamp", {"cosine,clamp,directional", "cosine,clamp,point"}},
        {"light_color", {"light_color,directional", "light_color,point"}},
        {"attenuation", {"attenuation,point"}},
        {"directional", {"directional"}},
        {"point", {"point"}},
        {"ambient", {"ambient"}},
        {"specular", {"specular,directional"}},
        {"normals", {"cosine,directional", "cosine,point"}},
        {"colours", {"light_color,directional", "ambient"}},
        {"sum", {"directional,point"}}};
    return all;
}

// What a check cannot be right without.
std::vector<std::string> dependenciesOf(const std::string& check) {
    if (check == "clamp")
        return {"runs", "cosine"};
    if (check == "attenuation")
        return {"runs", "point"};
    return {"runs"};
}

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = list.find(',', begin);
        parts.push_back(list.substr(begin, end - begin));
    }
    return parts;
}

// Every way of leaving some of the step's terms neutral, and each other term alone.
std::vector<std::string> neutralLists(const Rubric& rubric) {
    std::vector<std::string> fresh, lists;
    const auto isTerm = [](const std::string& name) {
        const auto& all = lighting::terms();
        return std::any_of(all.begin(), all.end(),
                           [&](const lighting::TermInfo& info) { return info.name == name; });
    };
    for (const TermCheck& check : rubric.terms)
        if (isTerm(check.id) && check.isNew && fresh.size() < 4)
            fresh.push_back(check.id);
        else if (isTerm(check.id))
            lists.push_back(check.id);
    for (unsigned which = 1; which < 1U << fresh.size(); ++which) {
        std::string list;
        for (std::size_t i = 0; i < fresh.size(); ++i)
            if ((which >> i & 1U) != 0)
                list += (list.empty() ? "" : ",") + fresh[i];
        lists.push_back(list);
    }
    return lists;
}

lighting::Switches without(const std::string& list) {
    lighting::Switches switches;
    for (const std::string& name : split(list))
        switches.terms = lighting::parseTerms("-" + name, switches.terms);
    return switches;
}

}  // namespace

Terms::Terms(const Rubric& rubric, const Texts& texts, Language language, std::uint64_t seed,
             std::shared_ptr<const THREE::LoadedScene> lesson, Show show)
    : rubric_(rubric), texts_(texts), language_(language), show_(show) {
    const std::string word = say(language, "scene ", "scena ");
    std::vector<Finish> finishes{Finish::matte};
    if (rubric.shiny)
        finishes.push_back(Finish::shiny);
    for (const Finish finish : finishes) {
        groups_.emplace_back();
        for (int i = 0; i < rubric.scenes; ++i) {
            groups_.back().frames.push_back(scenes_.size());
            scenes_.push_back(std::make_shared<THREE::LoadedScene>(
                hiddenScene(seed + static_cast<std::uint64_t>(i), finish)));
        }
    }
    groups_.back().frames.push_back(scenes_.size());
    scenes_.push_back(std::move(lesson));
    for (std::size_t i = 0; i < scenes_.size(); ++i)
        expected_.emplace_back(scenes_[i], rubric.size, lighting::Switches(), word + std::to_string(i + 1));
}

void Terms::prepare() const {
    for (Group& group : groups_) {
        if (group.explainer != nullptr)
            continue;
        std::vector<const ExpectedFrame*> frames;
        for (const std::size_t i : group.frames)
            frames.push_back(&expected_[i]);
        const bool shiny = &group != &groups_.front();
        group.explainer = std::make_unique<Explainer>(frames, shiny ? firstShinyLesson : lastMatteLesson);
        for (const std::string& list : neutralLists(rubric_)) {
            std::vector<std::vector<float>> all;
            for (const std::size_t i : group.frames)
                all.push_back(ExpectedFrame(scenes_[i], rubric_.size, without(list), "").pixels());
            group.explainer->add(neutral + list, all);
        }
    }
}

Check Terms::start(const TermCheck& term) const {
    const CheckText& text = texts_.check(term.id);
    Check check;
    check.id = term.id;
    check.title = text.title.in(language_);
    check.slides = text.slides;
    check.maxScore = check.score = term.points;
    check.status = CheckStatus::pass;
    check.isNew = term.isNew;
    check.dependsOn = dependenciesOf(term.id);
    check.expected = text.expected.in(language_);
    return check;
}

Terms::Blame Terms::blame(std::vector<std::string> ids, const Explainer::Fit& fit,
                          const std::set<std::string>& untouched) const {
    Blame blame;
    std::vector<std::string>
        terms;  // of the lists of neutral terms that give this picture: what was not touched, or the shortest
    const auto isUntouched = [&](const std::string& term) { return untouched.count(term) != 0; };
    const auto areUntouched = [&](const std::vector<std::string>& list) {
        return std::all_of(list.begin(), list.end(), isUntouched);
    };
    for (const std::string& id : ids) {
        if (!id.starts_with(neutral))
            continue;
        const std::vector<std::string> list = split(id.substr(std::string(neutral).size()));
        if (terms.empty() || (areUntouched(list) ? list.size() > terms.size() : list.size() < terms.size()))
            terms = list;
    }
    ids.erase(
        std::remove_if(ids.begin(), ids.end(), [](const std::string& id) { return id.starts_with(neutral); }),
        ids.end());
    if (!terms.empty() && (ids.empty() || areUntouched(terms))) {
        blame.checks = terms;
        blame.message = say(language_, "the term does nothing: it is still its neutral element",
                            "il termine non fa nulla: è ancora il suo elemento neutro");
        return blame;
    }
    Explanation explanation = explanationOf(ids, texts_, language_);
    explanation.explained = fit.explained;
    explanation.confidence = fit.confidence;
    try {
        blame.checks = {texts_.textOf(ids).check};
    } catch (const std::out_of_range&) {
        blame.checks = {texts_.misconception(ids.front()).check};
    }
    for (const TermCheck& check : rubric_.terms)
        if (check.id == blame.checks[0])
            for (const std::string& id : ids)
                if (const auto kept = check.credit.find(id); kept != check.credit.end())
                    blame.credit = std::max(blame.credit, kept->second);
    blame.message =
        say(language_, "the picture is what one gets when: ", "l'immagine è quella che si ha quando: ") +
        explanation.name;
    blame.explanation = std::move(explanation);
    return blame;
}

std::vector<Terms::Blame> Terms::blames(const std::vector<std::vector<float>>& found,
                                        const std::set<std::string>& untouched) const {
    prepare();
    Explainer::Fit fit;
    for (const Group& group : groups_) {
        std::vector<std::vector<float>> frames;
        bool right = true;
        for (const std::size_t i : group.frames) {
            frames.push_back(found[i]);
            right = right && compare(expected_[i], found[i]).right();
        }
        if (right)
            continue;
        fit = group.explainer->explain(frames);
        break;
    }
    std::vector<Blame> all;
    for (const std::vector<std::string>& ids : fit.ids) {
        all.push_back(blame(ids, fit, untouched));
        for (const std::string& check : all.back().checks)
            if (std::none_of(rubric_.terms.begin(), rubric_.terms.end(),
                             [&](const TermCheck& term) { return term.id == check; }))
                return {};  // this rubric has no such check
    }
    return all;
}

// How much of the hidden scenes is right in each state, in the worst of them. The lesson's own may lack a kind of light.
std::map<std::string, double> Terms::sharesOfStates(const DrawStates& drawStates) const {
    std::vector<std::string> states;
    for (const auto& [check, list] : statesOf())
        for (const std::string& state : list)
            if (std::find(states.begin(), states.end(), state) == states.end())
                states.push_back(state);
    std::map<std::string, double> shares;
    for (std::size_t scene = 0; scene + 1 < scenes_.size(); ++scene) {
        const auto frames = drawStates(scene, states);
        for (std::size_t i = 0; i < states.size(); ++i) {
            const lighting::Switches on(lighting::parseTerms(states[i], lighting::TermSet::none()));
            const ExpectedFrame expected(scenes_[scene], rubric_.size, on, "");
            const double right = frames[i].empty() ? 0 : compare(expected, frames[i]).share();
            const auto [place, isNew] = shares.emplace(states[i], right);
            if (!isNew)
                place->second = std::min(place->second, right);
        }
    }
    return shares;
}

// Each check by the states that show it alone, the best of them counting.
void Terms::judgeByStates(std::vector<Check>& checks, const DrawStates& drawStates) const {
    std::map<std::string, double> shares = sharesOfStates(drawStates);
    std::set<std::string> failed;
    for (Check& check : checks) {
        double best = 0;
        for (const std::string& state : statesOf().at(check.id))
            best = std::max(best, creditFor(shares[state]));
        check.score = check.maxScore * best;
        check.status = best >= 1 ? CheckStatus::pass : best > 0 ? CheckStatus::partial : CheckStatus::fail;
        check.message =
            best >= 1 ? say(language_, "alone, this term is right", "da solo, questo termine è giusto")
                      : say(language_,
                            "alone, with the others off, this term does not give the expected picture either",
                            "anche da solo, con gli altri spenti, questo termine non dà l'immagine attesa");
        if (best <= 0)
            failed.insert(check.id);
    }
    for (Check& check : checks)
        if (check.status == CheckStatus::fail &&
            std::any_of(check.dependsOn.begin(), check.dependsOn.end(),
                        [&](const std::string& id) { return failed.count(id) != 0; })) {
            check.status = CheckStatus::skipped;
            check.message = say(language_, "cannot be told: what it depends on must be right first",
                                "non si può dire: prima deve essere giusto ciò da cui dipende");
        }
    // The frames are wrong and yet each term is right alone: then it is how they are put together.
    if (std::any_of(checks.begin(), checks.end(),
                    [](const Check& one) { return one.status != CheckStatus::pass; }))
        return;
    for (Check& check : checks)
        if (check.isNew || check.id == "sum") {
            check.score = 0;
            check.status = CheckStatus::fail;
            check.message = say(language_, "each term alone is right, but not all together",
                                "ogni termine da solo è giusto, ma l'insieme no");
        }
}

void Terms::judgeMissing(std::vector<Check>& checks, const std::vector<std::vector<float>>& found,
                         const std::vector<std::string>& problems) const {
    for (Check& check : checks) {
        check.score = 0;
        check.status = CheckStatus::fail;
        for (std::size_t i = found.size(); i-- > 0;)
            if (found[i].empty())
                check.message = say(language_, "a frame is missing: ", "manca un'immagine: ") +
                                expected_[i].name() + ": " + problems[i];
    }
}

void Terms::judgeByBlame(std::vector<Check>& checks, const std::vector<Blame>& why) const {
    for (Check& check : checks)
        check.message = say(language_, "the mistake is not here", "non è questo l'errore");
    for (const Blame& one : why)
        for (Check& check : checks)
            if (std::find(one.checks.begin(), one.checks.end(), check.id) != one.checks.end()) {
                check.score = check.maxScore * one.credit;
                check.status = one.credit > 0 ? CheckStatus::partial : CheckStatus::fail;
                check.message = one.message;
                check.explanation = one.explanation;
                check.hint = one.explanation ? one.explanation->hint : "";
            }
}

PartVerdict Terms::judge(const std::vector<std::vector<float>>& found,
                         const std::vector<std::string>& problems, const std::set<std::string>& untouched,
                         const DrawStates& drawStates) const {
    const Evidence evidence(expected_, found);
    PartVerdict verdict;
    for (const TermCheck& term : rubric_.terms) {
        verdict.checks.push_back(start(term));
        verdict.checks.back().message =
            say(language_, "the picture is right in all scenes", "l'immagine è giusta in tutte le scene");
    }
    verdict.pictures = evidence.pictures("terms", language_, show_);
    if (evidence.right())
        return verdict;
    if (std::any_of(found.begin(), found.end(), [](const auto& frame) { return frame.empty(); }))
        judgeMissing(verdict.checks, found, problems);
    else if (const std::vector<Blame> why = blames(found, untouched); !why.empty())
        judgeByBlame(verdict.checks, why);
    else
        judgeByStates(verdict.checks, drawStates);
    show(evidence, evidence.worstPixel(), language_, verdict);
    return verdict;
}

}  // namespace grader
