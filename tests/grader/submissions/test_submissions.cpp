// The catalogue's equations held against what students would hand in: drawn by OpenGL, each gives the frame that its row
// predicts. Neither was made from the other.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/hidden_scene.hpp"
#include "grader/catalogue/misconceptions.hpp"
#include "grader/submissions/submissions.hpp"
#include "render/shader_source.hpp"
#include "support/draw.hpp"
#include "support/program.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>

namespace {

using grader::Apart;
using grader::apart;
using grader::Files;
using grader::Finish;
using grader::Misconception;
using grader::WrongFrames;

constexpr int size = 96;
// As for the lab's own shaders (test_adequacy.cpp). Measured here: 0.014, H4's, whose power makes it of a tiny error.
constexpr double oneTenthCode = 0.1;
// C11's normals jump from triangle to triangle, and no edge is left out there: a pixel on the border is the one's or the
// other's. Measured: 2 pixels.
const std::set<std::string> jumps{"C11"};

bool isRow(const std::string& id) {
    const auto& rows = grader::misconceptions();
    return std::any_of(rows.begin(), rows.end(), [&](const Misconception& row) { return row.id == id; });
}

// Lights are in uniforms, so that all scenes share a submission's programs, or `constant` in them.
image::Floats draw(THREE::LoadedScene& loaded, render::GlRenderer& renderer, bool constant = false) {
    loaded.scene->updateMatrixWorld();
    loaded.camera->updateWorldMatrix();
    THREE::validate(*loaded.scene, *loaded.camera);
    lighting::Settings settings;
    if (!constant)
        settings.constantLights = 0;
    const image::Frame frame = renderer.render(*loaded.scene, *loaded.camera, settings, {size, size, true});
    return std::get<image::Floats>(frame.pixels);
}

// What the catalogue says of a hidden scene.
const WrongFrames& predictions(std::uint64_t seed, Finish finish) {
    static std::map<std::pair<std::uint64_t, Finish>, WrongFrames> all;
    const auto key = std::pair(seed, finish);
    if (!all.contains(key)) {
        const THREE::LoadedScene hidden = grader::hiddenScene(seed, finish);
        all.emplace(key, WrongFrames(*hidden.scene, *hidden.camera, size, size));
    }
    return all.at(key);
}

// Holds a submission's frame against its row; a right one that is no row (R13, R14) against the truth.
void judge(const std::string& id, const image::Floats& drawn, const WrongFrames& frames) {
    const Apart error =
        apart(isRow(id) ? frames.frame(grader::misconception(id)) : frames.truth(), drawn, frames.counted());
    const Apart wrong = apart(frames.truth(), drawn, frames.counted());
    std::printf("  %-4s %7.3f codes from its row, %6.2f %% from the truth\n", id.c_str(), error.codes,
                100 * wrong.share);
    EXPECT_EQ(wrong.clearly(), id[0] != 'R') << id;
    if (jumps.contains(id))
        EXPECT_FALSE(error.clearly()) << id << " differs from its row on " << error.share;
    else
        EXPECT_LT(error.codes, oneTenthCode) << id << " differs from its row on " << error.share;
}

void judgeShaders(const std::string& id, render::GlRenderer& renderer, Finish finish, bool constant) {
    for (std::uint64_t seed = 0; seed < (constant ? 1U : 2U); ++seed) {
        THREE::LoadedScene hidden = grader::hiddenScene(seed, finish);
        judge(id, draw(hidden, renderer, constant), predictions(seed, finish));
    }
}

void write(const Files& files, const std::filesystem::path& folder) {
    for (const auto& [name, text] : files) {
        std::filesystem::create_directories((folder / name).parent_path());
        support::writeFile(folder / name, text);
    }
}

class Shaders : public testing::TestWithParam<char> {};

TEST_P(Shaders, DrawWhatTheirRowPredicts) {
    support::renderer();  // there is one context, and this makes it
    for (const std::string& id : grader::shaderSubmissions()) {
        if (id[0] != GetParam())
            continue;
        const support::TemporaryDirectory folder;
        write(grader::shaderSubmission(id), folder.path());
        render::GlRenderer renderer(render::findShaderDirectory(folder.path().string()));
        const bool right = id[0] == 'R', shines = right || id[0] == 'H';
        judgeShaders(id, renderer, shines ? Finish::shiny : Finish::matte, false);
        if (right)  // whatever the lab compiles of it
            judgeShaders(id, renderer, Finish::matte, true);
    }
}

INSTANTIATE_TEST_SUITE_P(Letter, Shaders, testing::Values('A', 'B', 'C', 'D', 'E', 'F', 'G', 'H', 'R'),
                         [](const auto& test) { return std::string(1, test.param); });

// What a grader must not give a name to, however near one is.
TEST(Unnamed, AreWrongAndNoRowExplainsThem) {
    support::renderer();
    for (const std::string& name : grader::unnamedSubmissions()) {
        const support::TemporaryDirectory folder;
        write(grader::unnamedSubmission(name), folder.path());
        render::GlRenderer renderer(render::findShaderDirectory(folder.path().string()));
        for (std::uint64_t seed = 0; seed < 2; ++seed) {
            THREE::LoadedScene hidden = grader::hiddenScene(seed, Finish::matte);
            const image::Floats drawn = draw(hidden, renderer);
            const WrongFrames& frames = predictions(seed, Finish::matte);
            std::pair<double, std::string> nearest(1, "");
            for (const Misconception& row : grader::misconceptions())
                nearest =
                    std::min(nearest, {apart(frames.frame(row), drawn, frames.counted()).share, row.id});
            std::printf("  %-28s %6.2f %% from %s\n", name.c_str(), 100 * nearest.first,
                        nearest.second.c_str());
            EXPECT_GE(nearest.first, 0.002) << name << " is as " << nearest.second;
        }
    }
}

TEST(Submissions, AreThereForEveryRowThatAShaderCanDraw) {
    const std::vector<std::string> written = grader::shaderSubmissions();
    const std::set<std::string> ids(written.begin(), written.end());
    for (const Misconception& row : grader::misconceptions())
        EXPECT_NE(ids.contains(row.id), grader::cannotBeWritten().contains(row.id)) << row.id;
    for (const std::string& id : ids)
        EXPECT_TRUE(isRow(id) || id[0] == 'R') << id;
    for (const auto& [id, why] : grader::cannotBeWritten())
        EXPECT_TRUE(isRow(id)) << id;
    EXPECT_THROW(grader::shaderSubmission("A0"), std::runtime_error);
}

// A lesson's mistake is one of its scene: the same change to a hidden scene, drawn by the lab's own shaders.
using Change = void (*)(THREE::LoadedScene&);

template <class T, class Apply>
void forEach(THREE::LoadedScene& loaded, const Apply& apply) {
    std::vector<T*> all;
    loaded.scene->traverse([&](THREE::Object3D& object) {
        if (auto* one = dynamic_cast<T*>(&object))
            all.push_back(one);
    });
    for (T* one : all)
        apply(*one);
}

template <class Apply>
void forEachMaterial(THREE::LoadedScene& loaded, const Apply& apply) {
    forEach<THREE::Mesh>(
        loaded, [&](THREE::Mesh& mesh) { apply(dynamic_cast<THREE::MeshPhongMaterial&>(*mesh.material)); });
}

// A copy of `light` on the camera, at the same numbers; the light itself goes out.
template <class L>
L& putOnCamera(THREE::LoadedScene& loaded, std::unique_ptr<L> copy, THREE::Light& light) {
    copy->color = light.color;
    copy->intensity = std::exchange(light.intensity, 0);
    copy->position = light.position;
    return loaded.camera->add(std::move(copy));
}

void sunsAsBulbs(THREE::LoadedScene& loaded) {
    forEach<THREE::DirectionalLight>(loaded, [&](THREE::DirectionalLight& sun) {
        auto bulb = std::make_unique<THREE::PointLight>(sun.color, std::exchange(sun.intensity, 0));
        bulb->position = sun.position;
        loaded.scene->add(std::move(bulb));
    });
}

void lightsOnTheCamera(THREE::LoadedScene& loaded) {
    forEach<THREE::DirectionalLight>(loaded, [&](THREE::DirectionalLight& sun) {
        auto& copy = putOnCamera(loaded, std::make_unique<THREE::DirectionalLight>(), sun);
        loaded.camera->add(copy.target);
    });
    forEach<THREE::PointLight>(loaded, [&](THREE::PointLight& bulb) {
        putOnCamera(loaded, std::make_unique<THREE::PointLight>(0xFFFFFF, 1, 0, bulb.decay), bulb);
    });
}

const std::map<std::string, std::pair<Finish, Change>> lessons{
    {"B2", {Finish::matte, sunsAsBulbs}},
    {"B4",
     {Finish::matte,
      [](THREE::LoadedScene& loaded) {
          forEach<THREE::DirectionalLight>(
              loaded, [](THREE::DirectionalLight& sun) { sun.position.multiplyScalar(-1); });
      }}},
    {"B10", {Finish::matte, lightsOnTheCamera}},
    {"D1",
     {Finish::matte,
      [](THREE::LoadedScene& loaded) {
          forEach<THREE::PointLight>(loaded, [](THREE::PointLight& bulb) { bulb.decay = 1; });
      }}},
    {"D2",
     {Finish::matte,
      [](THREE::LoadedScene& loaded) {
          forEach<THREE::PointLight>(loaded, [](THREE::PointLight& bulb) { bulb.decay = 0; });
      }}},
    {"H3Z",
     {Finish::shiny,
      [](THREE::LoadedScene& loaded) {
          forEachMaterial(loaded, [](THREE::MeshPhongMaterial& m) { m.shininess = 0; });
      }}},
    {"H14",
     {Finish::shiny,
      [](THREE::LoadedScene& loaded) {
          forEachMaterial(loaded, [](THREE::MeshPhongMaterial& m) { m.shininess = 30; });
      }}},
};

TEST(Lessons, DrawWhatTheirRowPredicts) {
    render::GlRenderer& renderer = support::renderer();
    for (const auto& [id, mistake] : lessons) {
        EXPECT_FALSE(grader::lessonSubmission(id).empty());
        for (std::uint64_t seed = 0; seed < 2; ++seed) {
            THREE::LoadedScene hidden = grader::hiddenScene(seed, mistake.first);
            mistake.second(hidden);
            judge(id, draw(hidden, renderer), predictions(seed, mistake.first));
        }
    }
}

TEST(Lessons, FitTheLabsOwn) {
    for (const std::string& id : grader::lessonSubmissions())
        for (const auto& [name, text] : grader::lessonSubmission(id)) {
            EXPECT_TRUE(isRow(id)) << id;
            EXPECT_NE(text, support::readFile(std::filesystem::path(LAMBERT_SOURCE_DIR) / "lessons" / name));
        }
}

// The message for an edit of one file, a: "one\n  two\nthree\n"; or what becomes of it.
std::string outcome(const std::string& edit) {
    try {
        return grader::edited({}, edit, "X.edit",
                              [](const std::string& name) -> std::string {
                                  if (name != "a")
                                      throw std::runtime_error("no " + name);
                                  return "one\n  two\nthree\ntwo\n";
                              })
            .at("a");
    } catch (const std::runtime_error& e) {
        return e.what();
    }
}

TEST(Edits, ChangeWholeLinesAndKeepTheirPlace) {
    EXPECT_EQ(outcome("file a\n"), "one\n  two\nthree\ntwo\n");
    EXPECT_EQ(outcome("# why\nfile a\n- one\n"), "  two\nthree\ntwo\n");
    EXPECT_EQ(outcome("file a\n- two\n- three\n+ 2\n+\n+   3\n"), "one\n  2\n\n    3\ntwo\n");
    EXPECT_EQ(outcome("file a\n- one\n+ two\n+ one\n\n- three\n+ 3\n"), "two\none\n  two\n3\ntwo\n");
}

TEST(Edits, SayWhatDoesNotFit) {
    EXPECT_EQ(outcome("file a\n\n- two\n+ 2\n"),
              "X.edit:3: expected 'two' exactly once in a, found it 2 times. Write what the file says now.");
    EXPECT_EQ(outcome("file a\n- four\n"),
              "X.edit:2: expected 'four' exactly once in a, found it 0 times. Write what the file says now.");
    EXPECT_EQ(outcome("- one\n"), "X.edit:1: a change before the first 'file NAME'");
    EXPECT_EQ(outcome("file b\n"), "no b");
    EXPECT_TRUE(outcome("file a\nhello\n").starts_with("X.edit:2: found 'hello', expected"))
        << outcome("hello");
    EXPECT_TRUE(outcome("file a\n+ one\n").starts_with("X.edit:2: found '+ one', expected"));
}

}  // namespace
