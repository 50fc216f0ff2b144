// 200 seeds: whatever hidden views come up, the lessons' own programs have full marks, and the lessons before them none for the new steps.
// SPDX-License-Identifier: MIT
#include "grader/judge/marks.hpp"
#include "grader/judge/steps.hpp"
#include "image/oiio.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using Scene = std::shared_ptr<const THREE::LoadedScene>;

const fs::path root = LAMBERT_SOURCE_DIR;

const std::vector<std::string> chain{
    "lesson_00_scene",       "lesson_01_material",     "lesson_02_directional_light",
    "lesson_03_point_light", "lesson_04_ambient",      "lesson_05_attenuation",
    "lesson_06_many_lights", "lesson_07_normal_space", "lesson_08_shading_frequency",
    "lesson_09_phong"};

// A lesson of the chain, and the seeds to try.
struct Case {
    std::size_t number;
    std::uint64_t first, count;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << chain[c.number] << " from seed " << c.first;
}

// What one program draws and says of its scene, at some views.
class Program {
  public:
    Program(const std::string& name, int size) : name_(name), size_(size) {
        support::writeFile(directory_.path() / "lamp.json", grader::lampState(name, size));
    }
    Scene sceneAt(const grader::View& view) const {
        std::vector<std::string> line{name_,    "--dump-scene",           "scene.json", "--size", sizeText(),
                                      "--time", std::to_string(view.time)};
        for (const std::string& option : optionsOf(view, "lamp.json"))
            line.push_back(option);
        if (support::run(line, directory_.path()).status != 0)
            return nullptr;
        return std::make_shared<THREE::LoadedScene>(
            THREE::ObjectLoader().load(directory_.file("scene.json")));
    }
    std::vector<std::vector<float>> frames(const std::vector<grader::View>& views) const {
        std::string lines;
        for (std::size_t i = 0; i < views.size(); ++i) {
            lines += "--frame " + std::to_string(i) + ".exr --time " + std::to_string(views[i].time);
            for (const std::string& option : optionsOf(views[i], "lamp.json"))
                lines += " " + option;
            lines += "\n";
        }
        support::writeFile(directory_.path() / "frames.txt", lines);
        support::run({name_, "--size", sizeText(), "--frames-from", "frames.txt"}, directory_.path());
        std::vector<std::vector<float>> all(views.size());
        for (std::size_t i = 0; i < views.size(); ++i) {
            const fs::path file = directory_.path() / (std::to_string(i) + ".exr");
            if (fs::exists(file))
                all[i] = image::toFloats(image::readFrame(file.string()));
            fs::remove(file);
        }
        return all;
    }

  private:
    std::string sizeText() const { return std::to_string(size_) + "x" + std::to_string(size_); }
    std::string name_;
    int size_;
    support::TemporaryDirectory directory_;
};

class Seeds : public testing::TestWithParam<Case> {};

TEST_P(Seeds, FullMarksForTheLessonAndNoneForTheOneBefore) {
    const grader::Texts texts(root / "slides_refs/misconceptions.json");
    const std::string& lesson = chain[GetParam().number];
    grader::Rubric rubric = grader::Rubric::read(root / "lessons" / (lesson + ".rubric.json"));
    rubric.size = 96;
    rubric.views = 1;
    const Program right(lesson, rubric.size), before(chain[GetParam().number - 1], rubric.size);
    std::vector<grader::View> all;  // of all seeds: a program draws them in one go
    for (std::uint64_t seed = GetParam().first; seed < GetParam().first + GetParam().count; ++seed)
        for (const grader::View& view : grader::hiddenViews(rubric, seed, false))
            all.push_back(view);
    const auto rightFrames = right.frames(all), framesBefore = before.frames(all);
    const auto count = static_cast<std::ptrdiff_t>(rubric.variants.size());
    for (std::ptrdiff_t first = 0; first < std::ssize(all); first += count) {
        const auto ofSeed = [&](const auto& list) {
            return std::vector(list.begin() + first, list.begin() + first + count);
        };
        const std::uint64_t seed = GetParam().first + static_cast<std::uint64_t>(first / count);
        const std::vector<grader::View> views = ofSeed(all);
        std::vector<Scene> scenes;
        for (const grader::View& view : views)
            scenes.push_back(right.sceneAt(view));
        grader::Steps steps(rubric, texts, grader::Language::en, views, scenes);
        steps.explains = false;
        const std::vector<std::string> missing(views.size(), "was not written");
        const auto marks = [&](const Program& program, const std::vector<std::vector<float>>& frames) {
            auto verdict = steps.judge(ofSeed(frames), missing,
                                       [&](std::size_t i) { return program.sceneAt(views[i]); });
            grader::countOldOnlyWithNew(verdict.checks, grader::Language::en);
            grader::Report report;
            report.checks = std::move(verdict.checks);
            grader::addUp(report, rubric.points);
            return report.score;
        };
        EXPECT_EQ(marks(right, rightFrames), 100) << "seed " << seed;
        EXPECT_EQ(marks(before, framesBefore), 0) << "seed " << seed;
    }
}

std::vector<Case> cases(std::uint64_t first, std::uint64_t count, std::uint64_t each) {
    std::vector<Case> all;
    for (std::size_t number = 1; number < chain.size(); ++number)
        for (std::uint64_t seed = first; seed < first + count; seed += each)
            all.push_back({number, seed, std::min(each, first + count - seed)});
    return all;
}
std::string nameOf(const testing::TestParamInfo<Case>& test) {
    return chain[test.param.number] + "_" + std::to_string(test.param.first);
}

INSTANTIATE_TEST_SUITE_P(Sample, Seeds, testing::ValuesIn(cases(0, 2, 2)), nameOf);
INSTANTIATE_TEST_SUITE_P(All, Seeds, testing::ValuesIn(cases(2, 198, 50)), nameOf);

}  // namespace
