// The catalogue's equations held against shaders that students would hand in: drawn by OpenGL, each gives the frame that
// its row predicts. Neither was made from the other.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/hidden_scene.hpp"
#include "grader/catalogue/misconceptions.hpp"
#include "grader/submissions/submissions.hpp"
#include "render/shader_source.hpp"
#include "support/draw.hpp"
#include "support/program.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>

namespace {

using grader::Apart;
using grader::apart;
using grader::Files;
using grader::Finish;
using grader::Misconception;
using grader::WrongFrames;

constexpr int size = 96;
// As for the lab's own shaders: test_adequacy.cpp.
constexpr double oneTenthCode = 0.1;

// A right equation that is not a row of the catalogue: its frame is the truth.
bool isRow(const std::string& id) {
    const auto& rows = grader::misconceptions();
    return std::any_of(rows.begin(), rows.end(), [&](const Misconception& row) { return row.id == id; });
}

void write(const Files& files, const std::filesystem::path& folder) {
    for (const auto& [name, text] : files) {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
    }
}

// A hidden scene with what the catalogue says of it. Lights are in uniforms, so that all scenes share their programs.
class Scene {
  public:
    Scene(std::uint64_t seed, Finish finish)
        : loaded_(grader::hiddenScene(seed, finish)), frames(*loaded_.scene, *loaded_.camera, size, size) {}

    image::Floats draw(render::GlRenderer& renderer) const {
        lighting::Settings settings;
        settings.constantLights = 0;
        const image::Frame frame =
            renderer.render(*loaded_.scene, *loaded_.camera, settings, {size, size, true});
        return std::get<image::Floats>(frame.pixels);
    }

  private:
    THREE::LoadedScene loaded_;

  public:
    WrongFrames frames;
};

const std::vector<Scene>& scenes(Finish finish) {
    const auto make = [](Finish f) {
        std::vector<Scene> all;
        for (std::uint64_t seed = 0; seed < 2; ++seed)
            all.emplace_back(seed, f);
        return all;
    };
    static const std::vector<Scene> matte = make(Finish::matte), shiny = make(Finish::shiny);
    return finish == Finish::matte ? matte : shiny;
}

// Draws all scenes of a finish with a submission's shaders.
void judge(const std::string& id, render::GlRenderer& renderer, Finish finish) {
    const bool right = id[0] == 'R';
    for (const Scene& scene : scenes(finish)) {
        const WrongFrames& frames = scene.frames;
        const std::vector<float> predicted =
            isRow(id) ? frames.frame(grader::misconception(id)) : frames.truth();
        const image::Floats drawn = scene.draw(renderer);
        const Apart error = apart(predicted, drawn, frames.counted());
        const Apart wrong = apart(frames.truth(), drawn, frames.counted());
        std::printf("  %-4s %7.3f codes from its row, %6.2f %% of the truth are wrong\n", id.c_str(),
                    error.codes, 100 * wrong.share);
        EXPECT_LT(error.codes, oneTenthCode) << id << ", " << 100 * error.share << " %";
        EXPECT_EQ(wrong.clearly(), !right) << id;
    }
}

class Submitted : public testing::TestWithParam<char> {};

TEST_P(Submitted, DrawsWhatItsRowPredicts) {
    support::renderer();  // there is one context, and this makes it
    for (const std::string& id : grader::shaderSubmissions()) {
        if (id[0] != GetParam())
            continue;
        const support::TemporaryDirectory folder;
        write(grader::shaderSubmission(id), folder.path());
        render::GlRenderer renderer(render::findShaderDirectory(folder.path().string()));
        try {
            if (id[0] != 'H')
                judge(id, renderer, Finish::matte);
            if (id[0] == 'H' || id[0] == 'R')
                judge(id, renderer, Finish::shiny);
        } catch (const std::exception& e) {
            ADD_FAILURE() << id << ": " << e.what();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Letter, Submitted, testing::Values('A', 'B', 'C', 'D', 'E', 'F', 'G', 'H', 'R'),
                         [](const auto& test) { return std::string(1, test.param); });

}  // namespace
