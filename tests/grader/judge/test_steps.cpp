// Marks of a lesson's steps, from scenes as students' programs could have made them.
// SPDX-License-Identifier: MIT
#include "grader/judge/steps.hpp"
#include "grader/judge/unseen.hpp"
#include "support/program.hpp"
#include "three/three.hpp"

#include <gtest/gtest.h>

namespace {

using grader::Check;
using Scene = std::shared_ptr<const THREE::LoadedScene>;
using Change = std::function<void(THREE::Scene&)>;

const std::filesystem::path root = LAMBERT_SOURCE_DIR;

const grader::Texts& texts() {
    static const grader::Texts all(root / "slides_refs/misconceptions.json");
    return all;
}

// A lesson's steps, as the grader looks at them with a seed.
class Lesson {
  public:
    using ChangeRubric = std::function<void(grader::Rubric&)>;
    Lesson(
        const std::string& name, std::uint64_t seed,
        const ChangeRubric& changeRubric = [](grader::Rubric&) {})
        : rubric_(grader::Rubric::read(root / "lessons" / (name + ".rubric.json"))) {
        rubric_.size = 96;
        changeRubric(rubric_);
        std::vector<grader::View> views = grader::hiddenViews(rubric_, seed, false);
        for (const grader::View& view : views)
            dumps_.push_back(dump(view));
        std::vector<Scene> scenes;
        for (const std::string& text : dumps_)
            scenes.push_back(load(text));
        steps_ =
            std::make_unique<grader::Steps>(rubric_, texts(), grader::Language::en, std::move(views), scenes);
    }
    const grader::Rubric& rubric() const { return rubric_; }
    std::vector<std::string> unseen() const { return grader::unseen(rubric_, steps_->expected()); }
    /// The checks that lose points when the program's scene is the lesson's, changed like this.
    std::set<std::string> lost(const Change& change) const { return idsOf(checks(change)); }
    std::vector<Check> checks(const Change& change) const {
        std::vector<std::vector<float>> frames;
        std::vector<Scene> scenes;
        for (const std::string& text : dumps_) {
            auto scene = std::make_shared<THREE::LoadedScene>(THREE::ObjectLoader().parse(text, "scene"));
            change(*scene->scene);
            frames.push_back(grader::ExpectedFrame(scene, rubric_.size, lighting::Switches(), "").pixels());
            scenes.push_back(std::move(scene));
        }
        return judge(frames, [&](std::size_t view) { return scenes[view]; });
    }
    std::vector<Check> judge(const std::vector<std::vector<float>>& frames,
                             const grader::Steps::SceneAt& sceneAt) const {
        return steps_->judge(frames, std::vector<std::string>(frames.size(), "was not written"), sceneAt)
            .checks;
    }
    std::vector<std::vector<float>> right() const {
        std::vector<std::vector<float>> frames;
        for (const grader::ExpectedFrame& frame : steps_->expected())
            frames.push_back(frame.pixels());
        return frames;
    }
    static std::set<std::string> idsOf(const std::vector<Check>& checks) {
        std::set<std::string> ids;
        for (const Check& check : checks)
            if (check.score < check.maxScore) {
                EXPECT_FALSE(check.message.empty()) << check.id;
                ids.insert(check.id);
            }
        return ids;
    }

  private:
    std::string dump(const grader::View& view) const {
        const support::TemporaryDirectory directory;
        std::vector<std::string> line{
            rubric_.lesson, "--dump-scene",           "scene.json", "--size", "96x96",
            "--time",       std::to_string(view.time)};
        for (const std::string& option : grader::optionsOf(view, "lamp.json"))
            line.push_back(option);
        support::writeFile(directory.path() / "lamp.json", grader::lampState(rubric_.lesson, 96));
        const support::Outcome outcome = support::run(line, directory.path());
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return support::readFile(directory.path() / "scene.json");
    }
    static Scene load(const std::string& text) {
        return std::make_shared<THREE::LoadedScene>(THREE::ObjectLoader().parse(text, "scene"));
    }

    grader::Rubric rubric_;
    std::vector<std::string> dumps_;
    std::unique_ptr<grader::Steps> steps_;
};

// The i-th object of a kind.
template <class T>
T& nth(THREE::Scene& scene, std::size_t index) {
    T* found = nullptr;
    std::size_t i = 0;
    scene.traverse([&](THREE::Object3D& object) {
        if (auto* one = dynamic_cast<T*>(&object); one != nullptr && i++ == index)
            found = one;
    });
    if (found == nullptr)
        throw std::out_of_range("the scene has no such object");
    return *found;
}
void remove(THREE::Object3D& object) { object.parent()->remove(object); }
THREE::MeshPhongMaterial& shiny(THREE::Scene& scene, std::size_t mesh) {
    return dynamic_cast<THREE::MeshPhongMaterial&>(*nth<THREE::Mesh>(scene, mesh).material);
}

struct Wrong {
    const char* lesson;
    const char* what;
    std::set<std::string> lost;
    Change change;
};
std::ostream& operator<<(std::ostream& out, const Wrong& wrong) {
    return out << wrong.lesson << ": " << wrong.what;
}

const std::set<std::string> nothing;

const std::vector<Wrong>& changes() {
    using THREE::AmbientLight, THREE::DirectionalLight, THREE::Mesh, THREE::PointLight;
    static const std::vector<Wrong> all{
        {"lesson_01_material",
         "the colour's channels are swapped",
         {"36.2"},
         [](THREE::Scene& s) { nth<Mesh>(s, 0).material->color.set(0x5588FF); }},
        {"lesson_01_material",
         "the floor's colour is another",
         {"36"},
         [](THREE::Scene& s) { nth<Mesh>(s, 1).material->color.set(0x778899); }},
        {"lesson_02_directional_light",
         "no light",
         {"36.3", "36.4"},
         [](THREE::Scene& s) { remove(nth<DirectionalLight>(s, 0)); }},
        {"lesson_02_directional_light",
         "the light shines the other way",
         {"36.4"},
         [](THREE::Scene& s) { nth<DirectionalLight>(s, 0).position.multiplyScalar(-1); }},
        {"lesson_02_directional_light", "a direction of another length", nothing,
         [](THREE::Scene& s) { nth<DirectionalLight>(s, 0).position.multiplyScalar(7); }},
        {"lesson_02_directional_light",
         "the light is grey",
         {"36.4"},
         [](THREE::Scene& s) { nth<DirectionalLight>(s, 0).color.set(0x888888); }},
        {"lesson_02_directional_light", "half of the colour is in the intensity", nothing,
         [](THREE::Scene& s) {
             nth<DirectionalLight>(s, 0).color.multiplyScalar(0.5);
             nth<DirectionalLight>(s, 0).intensity = 2;
         }},
        {"lesson_03_point_light",
         "the bulb hangs on the other side",
         {"37.6"},
         [](THREE::Scene& s) { nth<PointLight>(s, 0).position.x *= -1; }},
        {"lesson_03_point_light", "two bulbs of half the strength", nothing,
         [](THREE::Scene& s) {
             auto other = std::make_unique<PointLight>(nth<PointLight>(s, 0).color, 0.5);
             other->position = nth<PointLight>(s, 0).position;
             nth<PointLight>(s, 0).intensity = 0.5;
             s.add(std::move(other));
         }},
        {"lesson_03_point_light",
         "no sun any more",
         {"before"},
         [](THREE::Scene& s) { remove(nth<DirectionalLight>(s, 0)); }},
        {"lesson_04_ambient",
         "ten times too bright",
         {"43"},
         [](THREE::Scene& s) { nth<AmbientLight>(s, 0).intensity = 10; }},
        {"lesson_04_ambient", "two halves", nothing,
         [](THREE::Scene& s) {
             nth<AmbientLight>(s, 0).intensity = 0.5;
             s.add(std::make_unique<AmbientLight>(THREE::Color(0x101010), 0.5));
         }},
        {"lesson_05_attenuation",
         "decay forgotten",
         {"31"},
         [](THREE::Scene& s) { nth<PointLight>(s, 0).decay = 0; }},
        {"lesson_05_attenuation",
         "intensity forgotten",
         {"31"},
         [](THREE::Scene& s) { nth<PointLight>(s, 0).intensity = 1; }},
        {"lesson_06_many_lights",
         "one lamp is missing",
         {"38", "39"},
         [](THREE::Scene& s) { remove(nth<PointLight>(s, 3)); }},
        {"lesson_06_many_lights",
         "twice as strong as the slider says",
         {"39"},
         [](THREE::Scene& s) {
             for (std::size_t i = 1; i <= 12; ++i)
                 nth<PointLight>(s, i).intensity *= 2;
         }},
        {"lesson_07_normal_space",
         "not squashed",
         {"33"},
         [](THREE::Scene& s) { nth<Mesh>(s, 0).scale.set(1, 1, 1); }},
        {"lesson_08_shading_frequency",
         "both balls smooth",
         {"33"},
         [](THREE::Scene& s) { nth<Mesh>(s, 3).material->flatShading = false; }},
        {"lesson_09_phong",
         "exponent forgotten",
         {"45"},
         [](THREE::Scene& s) { shiny(s, 0).shininess = 30; }},
        {"lesson_09_phong",
         "K_S forgotten",
         {"45"},
         [](THREE::Scene& s) { shiny(s, 0).specular.set(0x111111); }},
    };
    return all;
}

class StepMarks : public testing::TestWithParam<Wrong> {};

TEST_P(StepMarks, LackWhatIsWrongAndNothingElse) {
    const Lesson lesson(GetParam().lesson, 2026);
    EXPECT_EQ(lesson.lost([](THREE::Scene&) {}), nothing);
    EXPECT_EQ(lesson.lost(GetParam().change), GetParam().lost);
}

INSTANTIATE_TEST_SUITE_P(Changes, StepMarks, testing::ValuesIn(changes()));

// Of one check, in a lesson's scene changed like this.
Check checkOf(const Lesson& lesson, const std::string& id, const Change& change) {
    const std::vector<Check> checks = lesson.checks(change);
    const auto one = std::find_if(checks.begin(), checks.end(), [&](const Check& c) { return c.id == id; });
    if (one == checks.end())
        throw std::out_of_range("the lesson has no such check");
    return *one;
}

// What a lamp has by itself is nobody's work.
TEST(Steps, ALampAsItComesEarnsItsPresenceOnly) {
    const auto plain = [](THREE::Scene& scene) {
        auto& bulb = nth<THREE::PointLight>(scene, 0);
        bulb.position.set(0, 0, 0);
        bulb.updateMatrix();
        bulb.color.set(0xFFFFFF);
    };
    const Lesson lesson("lesson_03_point_light", 2026);
    EXPECT_EQ(checkOf(lesson, "37.5", plain).score, 35);
    EXPECT_EQ(checkOf(lesson, "37.6", plain).score, 0);
}

// A place in a hidden view is not the number that the student wrote.
TEST(Steps, NamePlacesThatTheViewMovedWithoutNumbers) {
    const Lesson lesson("lesson_03_point_light", 2026);
    const Check check = checkOf(lesson, "37.6", [](THREE::Scene& scene) {
        auto& bulb = nth<THREE::PointLight>(scene, 0);
        bulb.position.y += 1;
        bulb.updateMatrix();
        bulb.color.set(0x66DD66);
    });
    EXPECT_NE(check.message.find("the position is not right"), std::string::npos) << check.message;
    EXPECT_NE(check.message.find("(0.46"), std::string::npos) << check.message;
}

// Lamps that give no light are no lamps too many, and nobody's mistake.
TEST(Steps, DoNotCountLampsThatAreDark) {
    const Lesson lesson("lesson_03_point_light", 2026);
    const auto change = [](THREE::Scene& scene) {
        nth<THREE::PointLight>(scene, 0).color.set(0x66DD66);
        auto& dark = scene.add(std::make_unique<THREE::PointLight>(0xFFFFFF, 0));
        dark.position.copy(nth<THREE::PointLight>(scene, 0).position);
        scene.add(std::make_unique<THREE::DirectionalLight>(0x000000));
        scene.updateMatrixWorld();
    };
    EXPECT_EQ(lesson.lost(change), (std::set<std::string>{"37.6"}));
}

// A program that lies about its scene gains nothing by it.
TEST(Steps, DoNotBelieveASceneThatDoesNotGiveTheFrames) {
    const Lesson lesson("lesson_05_attenuation", 1);
    std::vector<std::vector<float>> frames = lesson.right();
    for (std::vector<float>& frame : frames)
        for (float& value : frame)
            value *= 0.7F;
    const auto none = [](std::size_t) { return Scene(); };
    EXPECT_EQ(Lesson::idsOf(lesson.judge(frames, none)), (std::set<std::string>{"31", "before"}));
}

TEST(Steps, AMissingFrameFailsTheStepsThatNeedIt) {
    const Lesson lesson("lesson_06_many_lights", 1);
    std::vector<std::vector<float>> frames = lesson.right();
    frames[1].clear();  // the slider's
    const auto none = [](std::size_t) { return Scene(); };
    const std::vector<Check> checks = lesson.judge(frames, none);
    const auto slider =
        std::find_if(checks.begin(), checks.end(), [](const Check& one) { return one.id == "39"; });
    ASSERT_NE(slider, checks.end());
    EXPECT_EQ(slider->score, 0);
    EXPECT_NE(slider->message.find("was not written"), std::string::npos) << slider->message;
}

class Views : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Lessons, Views,
                         testing::Values("lesson_01_material", "lesson_02_directional_light",
                                         "lesson_03_point_light", "lesson_04_ambient",
                                         "lesson_05_attenuation", "lesson_06_many_lights",
                                         "lesson_07_normal_space", "lesson_08_shading_frequency",
                                         "lesson_09_phong"));

TEST_P(Views, ShowWhatTheStepsAskFor) {
    EXPECT_EQ(Lesson(GetParam(), 2026).unseen(), std::vector<std::string>());
}

TEST(Views, AreBlindFromFarAway) {
    const Lesson lesson("lesson_02_directional_light", 2026, [](grader::Rubric& rubric) {
        rubric.distance = {3000, 3000};
    });
    EXPECT_EQ(lesson.unseen(),
              (std::vector<std::string>{"directional[0] of step 36.3", "directional[0] of step 36.4"}));
}

TEST(Views, AreBlindForWhatIsOutsideThem) {
    const Lesson lesson("lesson_08_shading_frequency", 2026, [](grader::Rubric& rubric) {
        rubric.fov = 5;  // of the knot alone
    });
    EXPECT_EQ(lesson.unseen(), (std::vector<std::string>{"mesh[2] of step 33", "mesh[3] of step 33"}));
}

TEST(Aspects, ArePatternsWithRanges) {
    EXPECT_TRUE(grader::matches("point[1-12].color", "point[7].color"));
    EXPECT_TRUE(grader::matches("point[1-12].*", "point[12].decay"));
    EXPECT_FALSE(grader::matches("point[1-12].color", "point[0].color"));
    EXPECT_FALSE(grader::matches("point[1-12].color", "point[7].decay"));
    EXPECT_TRUE(grader::matches("mesh[0].?cale", "mesh[0].scale"));
    EXPECT_FALSE(grader::matches("mesh[0]", "mesh[0].scale"));
}

}  // namespace
