// What the grader refuses before it judges, and what its results are keyed on.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/hidden_scene.hpp"
#include "grader/grading/command_line.hpp"
#include "grader/grading/drawings.hpp"
#include "grader/grading/grader.hpp"
#include "image/home.hpp"
#include "support/program.hpp"
#include "three/three.hpp"

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

const fs::path root = LAMBERT_SOURCE_DIR;

std::string toolHash() {
    grader::GraderOptions options;
    options.lesson = "lesson_02_directional_light";
    return grader::Grader(options).toolHash();
}

// What a program says of its scene is read outside the walls.
TEST(Grader, RefusesAHugeSceneBeforeItIsDrawn) {
    THREE::SphereGeometry ball(1, 500, 500);
    THREE::MeshLambertMaterial paint;
    THREE::LoadedScene scene = grader::hiddenScene(1, grader::Finish::matte);
    const auto json = [&] { return THREE::toJSON(*scene.scene, scene.camera); };
    EXPECT_NE(grader::loadScene(json()), nullptr);
    for (int i = 0; i < 10; ++i)
        scene.scene->add(std::make_unique<THREE::Mesh>(ball, paint));
    EXPECT_THROW(grader::loadScene(json()), std::runtime_error);
    THREE::LoadedScene many = grader::hiddenScene(1, grader::Finish::matte);
    for (int i = 0; i < 2000; ++i)
        many.scene->add(std::make_unique<THREE::PointLight>());
    EXPECT_THROW(grader::loadScene(THREE::toJSON(*many.scene, many.camera)), std::runtime_error);
}

// A course's own rubric, whose cameras see too little: full marks for everybody, if it were not refused.
TEST(Grader, RefusesViewsThatShowTooLittle) {
    const support::TemporaryDirectory directory;
    std::string rubric = support::readFile(root / "lessons/lesson_02_directional_light.rubric.json");
    const std::string distance = "\"distance\": [6, 8]";
    ASSERT_NE(rubric.find(distance), std::string::npos);
    rubric.replace(rubric.find(distance), distance.size(), "\"distance\": [3000, 3000]");
    support::writeFile(directory.path() / "far.json", rubric);
    const support::Outcome outcome =
        support::run({"grade", "2", "--submission", root / "lessons/lesson_02_directional_light.cpp",
                      "--report", "out", "--rubric", "far.json"},
                     directory.path());
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("no hidden view shows directional[0] of step 36.3"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(directory.path() / "out"));
}

// --resume must not keep reports whose words are no longer the lab's.
TEST(Grader, IsAnotherToolWithOtherTexts) {
    const support::TemporaryDirectory directory;
    const fs::path real = image::home(), share = directory.path() / "share/lambert-lab";
    const auto link = [](const fs::path& from, const fs::path& to, const std::string& but) {
        fs::create_directories(to);
        for (const auto& entry : fs::directory_iterator(from))
            if (entry.path().filename() != but)
                fs::create_symlink(entry.path(), to / entry.path().filename());
    };
    link(real, directory.path(), "share");
    link(real / "share/lambert-lab", share, "slides_refs");
    fs::copy(fs::canonical(real / "share/lambert-lab/slides_refs"), share / "slides_refs",
             fs::copy_options::recursive);
    const std::string before = toolHash();
    image::setHome(directory.path());
    const std::string same = toolHash();
    const fs::path words = share / "slides_refs/misconceptions.json";
    support::writeFile(words, support::readFile(words) + "\n");
    const std::string after = toolHash();
    image::setHome("");
    EXPECT_EQ(same, before);
    EXPECT_NE(after, before);
}

// What is in the way of a report is deleted only if it is one.
TEST(Grader, ReplacesNothingButReports) {
    const support::TemporaryDirectory directory;
    grader::Graded graded;
    grader::replaceReport(graded, directory.path() / "out", "csv");
    grader::replaceReport(graded, directory.path() / "out", "html");
    support::writeFile(directory.path() / "out/thesis.txt", "mine");
    EXPECT_THROW(grader::replaceReport(graded, directory.path() / "out", "html"), std::runtime_error);
    EXPECT_TRUE(fs::exists(directory.path() / "out/thesis.txt"));
}

}  // namespace
