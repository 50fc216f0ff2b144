// Marks of shader terms, from frames as the catalogue's programs would draw them: right ones lose nothing, each wrong one its term.
// SPDX-License-Identifier: MIT
#include "grader/judge/terms.hpp"
#include "support/program.hpp"
#include "three/object_loader.hpp"

#include <gtest/gtest.h>

namespace {

using grader::Check;
using grader::CheckStatus;
using grader::Misconception;
using grader::misconceptions;
using Frames = std::vector<std::vector<float>>;

const std::filesystem::path root = LAMBERT_SOURCE_DIR;

const grader::Texts& texts() {
    static const grader::Texts all(root / "slides_refs/misconceptions.json");
    return all;
}

grader::Rubric rubricOf(const std::string& lesson) {
    grader::Rubric rubric = grader::Rubric::read(root / "lessons" / (lesson + ".rubric.json"));
    rubric.size = 96;
    return rubric;
}

std::shared_ptr<const THREE::LoadedScene> sceneOf(const std::string& lesson) {
    const support::TemporaryDirectory directory;
    const support::Outcome outcome = support::run(
        {lesson, "--dump-scene", "scene.json", "--size", "96x96", "--jitter", "5", "--time", "2"},
        directory.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return std::make_shared<THREE::LoadedScene>(THREE::ObjectLoader().load(directory.file("scene.json")));
}

// A lesson and a seed of the hidden scenes.
struct Case {
    std::string lesson;
    std::uint64_t seed;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.lesson << " seed " << c.seed; }

class TermMarks : public testing::TestWithParam<Case> {
  protected:
    TermMarks()
        : rubric(rubricOf(GetParam().lesson)),
          terms(rubric, texts(), grader::Language::en, GetParam().seed, sceneOf(GetParam().lesson)) {
        for (const auto& scene : terms.scenes())
            wrong.emplace_back(*scene->scene, *scene->camera, rubric.size, rubric.size);
    }
    Frames truth() const {
        Frames frames;
        for (const grader::WrongFrames& one : wrong)
            frames.push_back(one.truth());
        return frames;
    }
    Frames framesOf(const Misconception& row) const {
        Frames frames;
        for (const grader::WrongFrames& one : wrong)
            frames.push_back(one.frame(row));
        return frames;
    }
    std::vector<Check> judge(const Frames& frames) const {
        const auto noStates = [](std::size_t, const std::vector<std::string>& states) {
            ADD_FAILURE() << "nothing explained the frames";
            return Frames(states.size());
        };
        return terms.judge(frames, std::vector<std::string>(frames.size()), {}, noStates).checks;
    }
    static std::set<std::string> lost(const std::vector<Check>& checks) {
        std::set<std::string> ids;
        for (const Check& check : checks)
            if (check.score < check.maxScore) {
                EXPECT_EQ(check.score, 0) << check.id;
                EXPECT_EQ(check.status, CheckStatus::fail) << check.id;
                ids.insert(check.id);
            }
        return ids;
    }

    grader::Rubric rubric;
    grader::Terms terms;
    std::vector<grader::WrongFrames> wrong;
};

TEST_P(TermMarks, AreFullForWhatIsRight) {
    EXPECT_EQ(lost(judge(truth())), std::set<std::string>());
    for (const Misconception& row : misconceptions())
        if (row.right) {
            EXPECT_EQ(lost(judge(framesOf(row))), std::set<std::string>()) << row.id << ": " << row.name;
        }
}

TEST_P(TermMarks, LackExactlyTheTermOfAMisconception) {
    for (const Misconception& row : misconceptions()) {
        if (row.right || (!rubric.shiny && row.id[0] == 'H'))
            continue;
        const std::vector<Check> checks = judge(framesOf(row));
        const std::set<std::string> ids = lost(checks);
        ASSERT_EQ(ids.size(), 1U) << row.id << ": " << row.name;
        bool named = false;
        for (const Check& check : checks)
            if (check.explanation)
                for (const std::string& id : check.explanation->ids)
                    named = named || id == row.id;
        const bool neutral = std::any_of(checks.begin(), checks.end(), [](const Check& check) {
            return check.message.find("neutral") != std::string::npos;
        });
        EXPECT_TRUE(named || neutral) << row.id << ": " << row.name;
        // Where no picture tells it from another, the class says whose term it is.
        if (texts().misconception(row.id).check != *ids.begin()) {
            EXPECT_TRUE(std::any_of(texts().classes().begin(), texts().classes().end(),
                                    [&](const auto& one) {
                                        return one.check == *ids.begin() &&
                                               std::find(one.ids.begin(), one.ids.end(), row.id) !=
                                                   one.ids.end();
                                    }))
                << row.id << ": " << row.name << " cost " << *ids.begin();
        }
    }
}

class TermPairs : public TermMarks {};

// A1 and E1 are two mistakes in different addends; neither explains the frames alone.
TEST_P(TermPairs, AreNamedWhereTheyAddUp) {
    for (const auto& [one, other] : {std::pair("A1", "E1"), std::pair("E2", "D1")}) {
        const Misconception &a = grader::misconception(one), &b = grader::misconception(other);
        Frames frames = framesOf(a);
        const Frames second = framesOf(b), right = truth();
        for (std::size_t f = 0; f < frames.size(); ++f)
            for (std::size_t i = 0; i < frames[f].size(); ++i)
                frames[f][i] += second[f][i] - right[f][i];
        EXPECT_EQ(lost(judge(frames)), (std::set<std::string>{texts().misconception(one).check,
                                                              texts().misconception(other).check}))
            << one << " and " << other;
    }
}

TEST_P(TermMarks, OfNewTermsAreNoneWhileTheyAreNeutral) {
    for (const grader::TermCheck& term : rubric.terms) {
        if (!term.isNew)
            continue;
        Frames frames;
        lighting::Switches switches;
        switches.terms = lighting::parseTerms("-" + term.id, switches.terms);
        for (const auto& scene : terms.scenes())
            frames.push_back(grader::ExpectedFrame(scene, rubric.size, switches, "").pixels());
        EXPECT_EQ(lost(judge(frames)), std::set<std::string>{term.id});
    }
}

std::vector<Case> cases(std::uint64_t first, std::uint64_t count) {
    const char* const lessons[] = {"lesson_02_directional_light", "lesson_03_point_light",
                                   "lesson_04_ambient",           "lesson_05_attenuation",
                                   "lesson_06_many_lights",       "lesson_07_normal_space",
                                   "lesson_08_shading_frequency", "lesson_09_phong"};
    std::vector<Case> all;
    for (std::uint64_t i = first; i < first + count; ++i)
        all.push_back({lessons[i % std::size(lessons)], i});
    return all;
}
std::string nameOf(const testing::TestParamInfo<Case>& test) {
    return test.param.lesson + "_" + std::to_string(test.param.seed);
}

INSTANTIATE_TEST_SUITE_P(Sample, TermMarks, testing::ValuesIn(cases(0, 8)), nameOf);
INSTANTIATE_TEST_SUITE_P(All, TermMarks, testing::ValuesIn(cases(8, 192)), nameOf);
INSTANTIATE_TEST_SUITE_P(Sample, TermPairs, testing::ValuesIn(cases(0, 8)), nameOf);
INSTANTIATE_TEST_SUITE_P(All, TermPairs, testing::ValuesIn(cases(8, 32)), nameOf);

}  // namespace
