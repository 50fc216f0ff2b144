// Marks of whole submissions: built, run within walls, judged. Right ones lose nothing, starters get nothing for the new steps, each
// misconception costs its term.
// SPDX-License-Identifier: MIT
#include "grader/grading/grader.hpp"
#include "grader/submissions/submissions.hpp"
#include "support/program.hpp"
#include "three/three.hpp"

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using grader::Check;
using grader::Graded;
using grader::Grader;
using grader::Report;
using grader::ReportStatus;

const fs::path root = LAMBERT_SOURCE_DIR;

const std::vector<std::string> chain{
    "lesson_01_material",     "lesson_02_directional_light", "lesson_03_point_light",
    "lesson_04_ambient",      "lesson_05_attenuation",       "lesson_06_many_lights",
    "lesson_07_normal_space", "lesson_08_shading_frequency", "lesson_09_phong"};

std::unique_ptr<Grader> graderOf(const std::string& lesson, std::optional<std::uint64_t> seed = {}) {
    grader::GraderOptions options;
    options.lesson = lesson;
    options.seed = seed;
    return std::make_unique<Grader>(options);
}

// A submission of these files.
Report gradeFiles(const Grader& grader, const std::map<std::string, std::string>& files) {
    const support::TemporaryDirectory directory;
    for (const auto& [name, text] : files) {
        fs::create_directories((directory.path() / name).parent_path());
        support::writeFile(directory.path() / name, text);
    }
    Report report = grader.grade(directory.path()).report;
    EXPECT_EQ(report.status, ReportStatus::graded) << report.reason;
    return report;
}

std::set<std::string> lost(const Report& report) {
    std::set<std::string> ids;
    for (const Check& check : report.checks)
        if (check.score < check.maxScore ||
            (check.maxScore == 0 && check.status != grader::CheckStatus::pass))
            ids.insert(check.id);
    return ids;
}

std::string said(const Report& report) {
    std::string text = report.buildLog + report.said;
    for (const Check& check : report.checks)
        text += check.id + ": " + std::to_string(check.score) + "/" + std::to_string(check.maxScore) + " " +
                check.message + "\n";
    return text;
}

class LessonMarks : public testing::TestWithParam<std::string> {};
// Directional light, attenuation, Phong; the other lessons are slow.
bool isSample(const std::string& lesson) {
    return lesson.starts_with("lesson_02") || lesson.starts_with("lesson_05") ||
           lesson.starts_with("lesson_09");
}
std::vector<std::string> lessons(bool sample) {
    std::vector<std::string> some;
    std::copy_if(chain.begin(), chain.end(), std::back_inserter(some),
                 [&](const std::string& lesson) { return isSample(lesson) == sample; });
    return some;
}
INSTANTIATE_TEST_SUITE_P(Sample, LessonMarks, testing::ValuesIn(lessons(true)),
                         [](const auto& test) { return test.param; });
INSTANTIATE_TEST_SUITE_P(All, LessonMarks, testing::ValuesIn(lessons(false)),
                         [](const auto& test) { return test.param; });

TEST_P(LessonMarks, AreFullForTheSolutionAndNoneForTheStarter) {
    const auto grader = graderOf(GetParam());
    const Report solution = grader->grade(root / "lessons" / (GetParam() + ".cpp")).report;
    EXPECT_EQ(solution.score, 100) << said(solution);
    EXPECT_EQ(solution.maxScore, 100);
    const support::TemporaryDirectory directory;
    const std::string lang = GetParam().size() % 2 == 0 ? "it" : "en";
    ASSERT_EQ(
        support::run({"nuovo", "starter", GetParam(), "--lang", lang, "-o", "starter"}, directory.path())
            .status,
        0);
    const Report starter = grader->grade(directory.path() / "starter").report;
    EXPECT_EQ(starter.status, ReportStatus::graded);
    EXPECT_EQ(starter.score, 0) << said(starter);
    if (!fs::exists(directory.path() / "starter/terms"))
        return;
    fs::remove(directory.path() / "starter" / (GetParam() + ".cpp"));
    const Report terms = grader->grade(directory.path() / "starter").report;
    EXPECT_EQ(terms.score, 0) << said(terms);
}

// Shaders as students hand them in: a lesson that has highlights, or one that has none, by what the row is about.
struct Case {
    std::string id;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.id; }

const grader::Texts& texts() {
    static const grader::Texts all(root / "slides_refs/misconceptions.json");
    return all;
}

class ShaderMarks : public testing::TestWithParam<Case> {};

TEST_P(ShaderMarks, LackExactlyWhatIsWrong) {
    const std::string& id = GetParam().id;
    const grader::Misconception* row = nullptr;
    for (const grader::Misconception& one : grader::misconceptions())
        if (one.id == id)
            row = &one;
    const bool right = id[0] == 'R', highlight = id[0] == 'H' || id == "R10" || id == "R11" || id == "R12";
    const auto grader = graderOf(highlight ? "lesson_09_phong" : "lesson_05_attenuation");
    const Report report = gradeFiles(*grader, grader::shaderSubmission(id));
    if (right) {
        EXPECT_EQ(report.score, 100) << said(report);
        return;
    }
    ASSERT_NE(row, nullptr);
    const std::set<std::string> ids = lost(report);
    std::set<std::string> named;
    for (const Check& check : report.checks)
        if (check.explanation)
            named.insert(check.explanation->ids.begin(), check.explanation->ids.end());
    EXPECT_TRUE(named.count(id) != 0 || said(report).find("neutral") != std::string::npos) << said(report);
    // Where only the kept terms lose theirs, the new ones keep theirs; where the new one does, the kept ones do not count.
    const std::string check =
        named.empty() ? texts().misconception(id).check : texts().textOf({named.begin(), named.end()}).check;
    EXPECT_EQ(ids.count(check), 1U) << said(report);
    for (const Check& one : report.checks)
        if (one.id != check) {
            EXPECT_EQ(one.status, grader::CheckStatus::pass) << one.id << "\n" << said(report);
        }
}

std::vector<Case> sample(bool rest) {
    const std::set<std::string> some{"A1", "B3", "C3", "D1", "E1", "F9", "G4", "H1", "R3", "R14"};
    std::vector<Case> all;
    for (const std::string& id : grader::shaderSubmissions())
        if ((some.count(id) == 0) == rest)
            all.push_back({id});
    return all;
}
INSTANTIATE_TEST_SUITE_P(Sample, ShaderMarks, testing::ValuesIn(sample(false)),
                         [](const auto& test) { return test.param.id; });
INSTANTIATE_TEST_SUITE_P(All, ShaderMarks, testing::ValuesIn(sample(true)),
                         [](const auto& test) { return test.param.id; });

class UnnamedMarks : public testing::TestWithParam<std::string> {};

// What nothing explains is not named, and still loses. (D twice in both addends is two mistakes of the catalogue, and named so.)
TEST_P(UnnamedMarks, AreNotFullAndInventNoName) {
    const auto grader = graderOf("lesson_05_attenuation");
    const Report report = gradeFiles(*grader, grader::unnamedSubmission(GetParam()));
    EXPECT_LT(report.score, 100) << said(report);
    for (const Check& check : report.checks) {
        EXPECT_EQ(check.explanation.has_value(),
                  GetParam() == "paint_twice" && (check.id == "albedo" || check.id == "ambient"))
            << check.id << ": " << (check.explanation ? check.explanation->name : "not named");
    }
}
INSTANTIATE_TEST_SUITE_P(All, UnnamedMarks, testing::ValuesIn(grader::unnamedSubmissions()),
                         [](const auto& test) { return test.param; });

class ProgramMarks : public testing::TestWithParam<std::string> {};

// Lessons with a mistake in them: each loses points, and the report says whose.
TEST_P(ProgramMarks, LackWhatIsWrong) {
    for (const auto& [name, text] : grader::lessonSubmission(GetParam())) {
        const auto grader = graderOf(fs::path(name).stem());
        const Report report = gradeFiles(*grader, {{name, text}});
        EXPECT_LT(report.score, 100) << said(report);
        EXPECT_FALSE(lost(report).empty());
        EXPECT_FALSE(report.images.empty());
    }
}
INSTANTIATE_TEST_SUITE_P(Lessons, ProgramMarks, testing::ValuesIn(grader::lessonSubmissions()),
                         [](const auto& test) { return test.param; });

class HostileMarks : public testing::TestWithParam<const char*> {};

// What confinement does to them is tests/grader/hostile's; here: they get nothing, and the report says why.
TEST_P(HostileMarks, AreNone) {
    const fs::path hostile = root / "tests/grader/hostile";
    const auto grader = graderOf("lesson_05_attenuation");
    const Report report =
        gradeFiles(*grader, {{"lesson_05_attenuation.cpp",
                              support::readFile(hostile / "runs" / (GetParam() + std::string(".cpp")))},
                             {"hostile.hpp", support::readFile(hostile / "hostile.hpp")}});
    EXPECT_EQ(report.score, 0) << said(report);
    const auto runs = std::find_if(report.checks.begin(), report.checks.end(),
                                   [](const Check& c) { return c.id == "runs"; });
    ASSERT_NE(runs, report.checks.end());
    EXPECT_EQ(runs->status, grader::CheckStatus::fail);
    EXPECT_FALSE(runs->message.empty());
}
INSTANTIATE_TEST_SUITE_P(Programs, HostileMarks,
                         testing::Values("aborts", "constant_frame", "headless", "huge_header", "no_frames",
                                         "own_report", "praise", "symbolic_link"),
                         [](const auto& test) { return test.param; });

TEST(Grade, BothPartsTogetherAreJudgedApart) {
    const auto grader = graderOf("lesson_05_attenuation");
    std::map<std::string, std::string> files = grader::shaderSubmission("A1");
    files["lesson_05_attenuation.cpp"] = support::readFile(root / "lessons/lesson_05_attenuation.cpp");
    const Report report = gradeFiles(*grader, files);
    EXPECT_EQ(lost(report), std::set<std::string>{"clamp"}) << said(report);
    EXPECT_EQ(report.maxScore, 100);
}

// No cosine is above 1: a clamp at both ends is right.
TEST(Grade, AClampAtBothEndsIsRight) {
    for (const char* lesson : {"lesson_02_directional_light", "lesson_05_attenuation"}) {
        const auto grader = graderOf(lesson);
        const Report report = gradeFiles(
            *grader, {{"terms/clamp.glsl", "float clamp_cosine(float c) { return clamp(c, 0.0, 1.0); }\n"}});
        EXPECT_EQ(report.score, 100) << said(report);
    }
}

// One scene, built in another way than the lesson's.
TEST(Grade, AnotherStyleIsRight) {
    const auto grader = graderOf("lesson_03_point_light");
    const Report report = gradeFiles(*grader, {{"mine.cpp", R"(#include "lab/lab.hpp"
#include <memory>
#include <vector>
using namespace THREE;
struct Turn {
    Mesh* mesh;
    void operator()(double t) const { mesh->rotation.y = 0.3 + 0.6 * t; }
};
int main(int n, char* v[]) {
    lab::App app(n, v, "mine");
    Scene s;
    s.background = 0x2e3440;
    PerspectiveCamera camera(36);
    Group g;
    g.position.set(0, 1, 0);
    s.add(g);
    PointLight bulb(0xDD6666);
    bulb.position.set(2, 0.5, 5);
    g.add(bulb);
    PlaneGeometry square(9, 9);
    MeshLambertMaterial grey(0x7788AA);
    Mesh floor(square, grey);
    floor.position.y = -1;
    floor.rotation.x = -1.5707963267948966;
    g.add(floor);
    std::vector<std::unique_ptr<DirectionalLight>> suns;
    for (int i = 0; i < 2; ++i) {
        suns.push_back(std::make_unique<DirectionalLight>(0xFFFFFF, 0.5));
        suns.back()->position.set(0, 0.3, -0.2);
        s.add(*suns.back());
    }
    DirectionalLight black(0x000000);
    s.add(black);
    TorusKnotGeometry knot(0.9, 0.34, 400, 64);
    MeshLambertMaterial orange;
    orange.color.set("#ff8855");
    Mesh mesh(knot, orange);
    mesh.position.set(0, 0.55, 0);
    mesh.rotation.set(0.5, 0.3, 0.2);
    g.add(mesh);
    return app.run(s, camera, Turn{&mesh});
}
)"}});
    EXPECT_EQ(report.score, 100) << said(report);
}

TEST(Grade, WhatDoesNotBuildHasItsReason) {
    const auto grader = graderOf("lesson_05_attenuation");
    const Report report = gradeFiles(
        *grader, {{"lesson_05_attenuation.cpp", "#include \"lab/lab.hpp\"\nint main() { return x; }\n"}});
    EXPECT_EQ(report.score, 0);
    EXPECT_NE(report.buildLog.find("lesson_05_attenuation.cpp:2"), std::string::npos) << report.buildLog;
    const Report shader =
        gradeFiles(*grader, {{"terms/clamp.glsl", "float clamp_cosine(float x) { return y; }\n"}});
    EXPECT_EQ(shader.score, 0);
    EXPECT_NE(said(shader).find("terms/clamp.glsl"), std::string::npos) << said(shader);
}

TEST(Grade, AnEmptySubmissionIsNotGradable) {
    const support::TemporaryDirectory directory;
    const Report report = graderOf("lesson_05_attenuation")->grade(directory.path()).report;
    EXPECT_EQ(report.status, ReportStatus::notGradable);
    EXPECT_FALSE(report.reason.empty());
}

}  // namespace
