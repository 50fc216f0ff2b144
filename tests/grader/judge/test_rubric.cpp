// The rubrics of the lessons, and what is wrong with others.
// SPDX-License-Identifier: MIT
#include "grader/judge/marks.hpp"
#include "grader/judge/rubric.hpp"
#include "grader/judge/scene_difference.hpp"
#include "grader/judge/views.hpp"
#include "starter_tasks.hpp"
#include "support/program.hpp"
#include "three/object_loader.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace {

namespace fs = std::filesystem;
using grader::Rubric;
using Json = nlohmann::json;

const fs::path root = LAMBERT_SOURCE_DIR;

std::vector<std::string> lessons() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(root / "lessons"))
        if (entry.path().string().ends_with(".rubric.json"))
            names.push_back(entry.path().stem().stem());
    std::sort(names.begin(), names.end());
    return names;
}

class Rubrics : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Chain, Rubrics, testing::ValuesIn(lessons()),
                         [](const auto& test) { return test.param; });

TEST(Rubrics, AreThereForEveryLessonButTheFirst) { EXPECT_EQ(lessons().size(), 9U); }

TEST_P(Rubrics, HaveACheckForEachNewSlideStep) {
    const Rubric rubric = Rubric::read(root / "lessons" / (GetParam() + ".rubric.json"));
    EXPECT_EQ(rubric.lesson, GetParam());
    std::set<std::string> cited, checks;
    for (const nuovo::Lesson& lesson : nuovo::readLessons(root / "lessons").chain)
        if (lesson.stem == GetParam())
            for (const nuovo::NewRun& run : nuovo::runsOf(lesson))
                cited.insert(nuovo::toString(run.cites));
    for (const grader::StepCheck& step : rubric.steps)
        if (step.isNew)
            checks.insert(step.id);
    EXPECT_EQ(checks, cited);
}

// A pattern that meets nothing would give its points away.
TEST_P(Rubrics, NameAspectsThatTheLessonsSceneHas) {
    const support::TemporaryDirectory directory;
    ASSERT_EQ(support::run({GetParam(), "--dump-scene", "scene.json"}, directory.path()).status, 0);
    const THREE::LoadedScene scene = THREE::ObjectLoader().load(directory.file("scene.json"));
    const grader::Aspects aspects = grader::compareScenes(*scene.scene, *scene.scene);
    for (const auto& [name, aspect] : aspects)
        EXPECT_TRUE(aspect.right) << name;
    for (const grader::StepCheck& step : Rubric::read(root / "lessons" / (GetParam() + ".rubric.json")).steps)
        for (const std::vector<std::string>* list : {&step.aspects, &step.keeps})
            for (const std::string& pattern : *list)
                EXPECT_TRUE(std::any_of(aspects.begin(), aspects.end(),
                                        [&](const auto& one) { return grader::matches(pattern, one.first); }))
                    << step.id << ": " << pattern;
}

// What reading says of the lesson's rubric, changed.
template <class Change>
std::string refusal(const Change& change) {
    Json json = Json::parse(support::readFile(root / "lessons/lesson_05_attenuation.rubric.json"));
    change(json);
    const support::TemporaryDirectory directory;
    support::writeFile(directory.path() / "mine.json", json.dump());
    try {
        Rubric::read(directory.path() / "mine.json");
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(OtherRubrics, AreRefusedByFieldExpectedAndFound) {
    EXPECT_EQ(refusal([](Json&) {}), "");
    EXPECT_EQ(refusal([](Json& r) { r["points"] = "many"; }),
              "mine.json.points: expected a number from 1.0 to 1000000.0, found \"many\"");
    EXPECT_EQ(refusal([](Json& r) { r.erase("views"); }),
              "mine.json: expected a field \"views\", found none");
    EXPECT_EQ(refusal([](Json& r) { r["veiws"] = 3; }), "mine.json.veiws: expected no such field, found 3");
    EXPECT_EQ(refusal([](Json& r) { r["steps"][0]["title"].erase("it"); }),
              "mine.json.steps[0].title: expected a field \"it\", found none");
    EXPECT_EQ(refusal([](Json& r) { r["views"]["count"] = 1000; }),
              "mine.json.views.count: expected a number from 1.0 to 16.0, found 1000");
    EXPECT_EQ(refusal([](Json& r) { r["views"]["azimuth_degrees"] = 90; }),
              "mine.json.views.azimuth_degrees: expected a list, found 90");
    EXPECT_EQ(refusal([](Json& r) { r["schema"] = "lambert-lab/rubric/2"; }),
              "mine.json.schema: expected \"lambert-lab/rubric/1\", found \"lambert-lab/rubric/2\"");
    EXPECT_NE(refusal([](Json& r) { r["steps"][1]["id"] = "31"; }).find("'31' is there twice"),
              std::string::npos);
    EXPECT_NE(refusal([](Json& r) { r["variants"] = Json::array(); }).find("at least one"),
              std::string::npos);
    EXPECT_THROW(Rubric::read(root / "no such file"), std::runtime_error);
}

// What a view must show may be on one side.
TEST(HiddenCameras, StandWhereTheRubricSays) {
    Rubric rubric = Rubric::read(root / "lessons/lesson_05_attenuation.rubric.json");
    rubric.views = 1;
    const auto frontShare = [&] {
        int front = 0;
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            const std::vector<std::string> options = grader::hiddenViews(rubric, seed, false).front().options;
            double x = 0, y = 0, z = 0;
            EXPECT_EQ(std::sscanf(options.at(1).c_str(), "%lf,%lf,%lf", &x, &y, &z), 3) << options.at(1);
            const double distance =
                std::hypot(x - rubric.lookAt[0], y - rubric.lookAt[1], z - rubric.lookAt[2]);
            EXPECT_GE(distance, rubric.distance[0] - 1e-3);
            EXPECT_LE(distance, rubric.distance[1] + 1e-3);
            front += z > rubric.lookAt[2] ? 1 : 0;
        }
        return front;
    };
    EXPECT_GT(frontShare(), 30);
    EXPECT_LT(frontShare(), 70);
    rubric.azimuth = {-90, 90};
    EXPECT_EQ(frontShare(), 100);
}

grader::Check check(const char* id, double score, double maxScore, bool isNew) {
    grader::Check one;
    one.id = id;
    one.score = score;
    one.maxScore = maxScore;
    one.isNew = isNew;
    return one;
}

TEST(Marks, OfWhatWasThereCountOnlyWithWhatIsNew) {
    std::vector<grader::Check> checks{check("new", 30, 60, true), check("old", 10, 10, false)};
    grader::countOldOnlyWithNew(checks, grader::Language::en);
    EXPECT_EQ(checks[1].score, 5);
    EXPECT_NE(checks[1].message.find("only together"), std::string::npos);
    std::vector<grader::Check> nothingNew{check("old", 10, 10, false)};
    grader::countOldOnlyWithNew(nothingNew, grader::Language::en);
    EXPECT_EQ(nothingNew[0].score, 10);
}

TEST(Marks, AddUpToTheRubricsPoints) {
    grader::Report report;
    for (int i = 0; i < 7; ++i)
        report.checks.push_back(check("one", 1, 1, true));
    for (const double points : {100.0, 10.0, 7.5, 1.0}) {
        grader::Report full = report;
        grader::addUp(full, points);
        EXPECT_EQ(full.score, points);
        EXPECT_EQ(full.maxScore, points);
        grader::Report half = report;
        half.checks[0].score = 0;
        grader::addUp(half, points);
        EXPECT_LT(half.score, points);
    }
    grader::Report none;
    grader::addUp(none, 100);
    EXPECT_EQ(none.score, 0);
    EXPECT_EQ(none.maxScore, 100);
    grader::Report nearly;
    nearly.checks = {check("much", 1e6, 1e6, true), check("little", 0, 1, true)};
    grader::addUp(nearly, 10);
    EXPECT_EQ(nearly.score, 9.99);
}

}  // namespace
