// A starter is wrong, its lesson right, and so is each shader exercise: judged by frames from hidden places, against the
// reference. tests/nuovo/test_starter_build has built the starters.
// SPDX-License-Identifier: MIT
#include "starter.hpp"

#include "image/compare.hpp"
#include "image/oiio.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

const fs::path lab = LAMBERT_SOURCE_DIR;
const fs::path work = STARTER_WORK_DIR;

// Where a student has not looked: another camera and other times; jitter of camera, lights and meshes.
const std::vector<Arguments> hidden{{"--jitter", "29", "--time", "2.5"},
                                    {"--camera", "-3,3.5,5,0,1,0,45", "--time", "1.3"}};

// The share of pixels that are off by more than half a code. Of right frames, seen: at most 0.0001, along silhouettes; of
// wrong ones: at least 0.038 (lesson 09 without its highlights).
constexpr double most = 0.002;
constexpr double least = 0.02;

image::Frame frameOf(const std::string& program, const Arguments& options) {
    const support::TemporaryDirectory directory;
    Arguments all{program, "--frame", "frame.exr", "--size", "160x120"};
    all.insert(all.end(), options.begin(), options.end());
    const support::Outcome outcome = support::run(all, directory.path());
    EXPECT_EQ(outcome.status, 0) << program << ": " << outcome.err;
    return image::readFrame(directory.file("frame.exr"));
}

// The share of pixels that differ from the reference's frame of the lesson, for each hidden place.
class Judge {
  public:
    explicit Judge(const std::string& lesson) {
        for (Arguments options : hidden) {
            options.insert(options.end(), {"--renderer", "reference"});
            right_.push_back(frameOf(lesson, options));
        }
    }
    std::vector<double> shares(const std::string& program, const Arguments& more = {}) const {
        std::vector<double> result;
        for (std::size_t i = 0; i < hidden.size(); ++i) {
            Arguments options = hidden[i];
            options.insert(options.end(), more.begin(), more.end());
            const image::Difference d = image::compare(right_[i], frameOf(program, options), 0.5 / 255);
            result.push_back(static_cast<double>(d.above) / static_cast<double>(d.pixels));
        }
        return result;
    }
    void expectRight(const std::string& what, const std::string& program, const Arguments& more = {}) const {
        const std::vector<double> all = shares(program, more);
        EXPECT_LT(*std::max_element(all.begin(), all.end()), most)
            << what << ": " << testing::PrintToString(all);
    }
    // From every hidden place.
    void expectWrong(const std::string& what, const std::string& program, const Arguments& more = {}) const {
        const std::vector<double> all = shares(program, more);
        EXPECT_GT(*std::min_element(all.begin(), all.end()), least)
            << what << ": " << testing::PrintToString(all);
    }

  private:
    std::vector<image::Frame> right_;
};

// What a student may write, knowing only what the TODO says: where it stands in the starter's file, and by what.
struct Answer {
    const char* term;
    const char* from;
    const char* to;
};
const Answer answers[] = {
    {"albedo", "return vec3(1.0);", "return D;"},
    {"cosine", "v) { return 1.0; }", "v) { return dot(n, v); }"},
    {"cosine", "d2) { return 1.0; }", "d2) { return sqrt(d2); }"},
    {"clamp", "return cosine;", "return max(0.0, cosine);"},
    {"light_color", "return vec3(L.a);", "return L.rgb;"},
    {"point", "#if TERM_POINT\n",
     "#if TERM_POINT\nfor (int i = 0; i < NUM_POINT_LIGHTS; ++i) {\nvec3 w = normalize(point_position(i) - "
     "Q);\n"
     "P += clamp_cosine(dot(n, w)) * D * light_color(point_L(i));\n}\n"},
    {"ambient", "#if TERM_AMBIENT\n", "#if TERM_AMBIENT\nP += D * ambientLight;\n"},
    {"attenuation", "return 1.0;", "return pow(sqrt(d2), k);"},
    {"specular", "#if TERM_SPECULAR\n",
     "#if TERM_SPECULAR\nuniform vec3 eyePosition;\nuniform vec3 specularColor;\nuniform float shininess;\n"},
    {"specular", "return vec3(0.0);", "return normalize(eyePosition - Q);"},
    {"specular", "return diffuse;",
     "vec3 R = 2.0 * dot(n, w) * n - w;\nreturn dot(n, w) > 0.0 ? diffuse + f * specularColor * "
     "pow(max(0.0, dot(R, v)), shininess) : diffuse;"},
};

std::string answered(const std::string& term, std::string text) {
    for (const Answer& answer : answers)
        if (answer.term == term) {
            const std::size_t at = text.find(answer.from);
            EXPECT_NE(at, std::string::npos) << term << " has no " << answer.from;
            if (at != std::string::npos)
                text.replace(at, std::string(answer.from).size(), answer.to);
        }
    return text;
}

std::vector<nuovo::Lesson> chain() { return nuovo::readLessons(lab / "lessons").chain; }

std::vector<std::string> stemsWithStarter() {
    std::vector<std::string> stems;
    for (const nuovo::Lesson& lesson : chain())
        if (lesson.number > 0)
            stems.push_back(lesson.stem);
    return stems;
}

class StarterOf : public testing::TestWithParam<std::string> {
  protected:
    const std::string lesson = GetParam();
    const fs::path starter = work / "starters" / lesson;
    // As the programs of support::run are found: below the lab's bin/.
    const std::string program = fs::relative(work / "bin" / lesson, LAMBERT_BIN_DIR).string();
    const Judge judge{lesson};
    std::vector<std::string> terms;

    StarterOf() {
        if (fs::exists(starter / "terms"))
            for (const auto& entry : fs::directory_iterator(starter / "terms"))
                terms.push_back(entry.path().stem().string());
    }
    // Makes `folder` hold some terms of the starter, as they are or answered.
    void writeTerms(const fs::path& folder, const std::vector<std::string>& which, bool answer) const {
        fs::create_directories(folder / "terms");
        for (const std::string& term : which) {
            const fs::path file = fs::path("terms") / (term + ".glsl");
            const std::string text = support::readFile(starter / file);
            support::writeFile(folder / file, answer ? answered(term, text) : text);
        }
    }
    Arguments shaders() const {
        return terms.empty() ? Arguments{} : Arguments{"--shaders", starter.string()};
    }
};

// One test, because what takes long is the reference's frames.
TEST_P(StarterOf, IsWrongUntilAllOfItIsAnswered) {
    judge.expectRight("the lesson", lesson);
    judge.expectWrong("the starter", program, shaders());
    const auto all = chain();
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].stem == lesson)
            judge.expectWrong("the previous lesson", all[i - 1].stem);
    if (terms.empty())
        return;
    judge.expectWrong("the starter with the lab's own shaders", program);
    for (const std::string& term : terms) {
        const support::TemporaryDirectory folder;
        writeTerms(folder.path(), {term}, false);
        judge.expectWrong("the lesson with a neutral " + term, lesson, {"--shaders", folder.path().string()});
    }
    const support::TemporaryDirectory folder;
    writeTerms(folder.path(), terms, true);
    judge.expectRight("the lesson with its terms answered", lesson, {"--shaders", folder.path().string()});
    for (const std::string& term : terms)
        fs::copy_file(lab / "shaders/terms" / (term + ".glsl"), folder.path() / "terms" / (term + ".glsl"),
                      fs::copy_options::overwrite_existing);
    judge.expectRight("the lesson with the lab's terms", lesson, {"--shaders", folder.path().string()});
}

INSTANTIATE_TEST_SUITE_P(Chain, StarterOf, testing::ValuesIn(stemsWithStarter()),
                         [](const auto& test) { return test.param; });

}  // namespace
