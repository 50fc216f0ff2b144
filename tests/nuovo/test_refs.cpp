// slides_refs/README.md and the list of pictures, on a small repository of their own.
// SPDX-License-Identifier: MIT
#include "fixture.hpp"
#include "refs.hpp"

#include <sstream>

namespace {

using namespace nuovo;
using namespace nuovo::test;
namespace fs = std::filesystem;

const char* const kCompanion = R"json({"slides": [{"number": 36,
    "title": {"it": "Luci", "en": "Lights"}, "says": {"it": "un'idea", "en": "an idea"},
    "equation": {"text": "|w| = 1"}, "lessons": ["lesson_01_material"], "terms": ["clamp"], "views": ["key 3"],
    "lines": [{"file": "lessons/lesson_02_light.cpp", "code": "miaScena.add(miaLuce)"}],
    "pictures": [{"file": "slide_36_a.png", "command": "lesson_01_material --terms -clamp",
                  "alt": {"it": "nero", "en": "\"black\""}},
                 {"file": "slide_36_b.png", "command": "lesson_02_light", "size": "9x8",
                  "alt": {"it": "b", "en": "b"}, "answer": true}],
    "predict": {"question": {"it": "che cosa?", "en": "what?"}, "answer": {"it": "questo", "en": "this"}}}],
    "term_lines": {"clamp": {"file": "shaders/terms/clamp.glsl", "code": "max(0.0"}},
    "errata_kinds": {"error": {"it": "errore: grave", "en": "error: grave"},
                     "misprint": {"it": "refuso", "en": "misprint"}},
    "errata": [{"slide": 36, "also": [3], "kind": "error", "says": {"it": "a", "en": "says | so"},
                "should_say": {"it": "b", "en": "should"}, "reason": {"it": "c", "en": "because"}},
               {"slide": 36, "also": [], "kind": "misprint", "says": {"it": "d", "en": "typo"},
                "should_say": {"it": "e", "en": "type"}, "reason": {"it": "f", "en": "letter"}}],
    "other_pictures": [{"file": "other.png", "command": "lesson_01_material --time 1", "size": "4x4"}],
    "pictures_elsewhere": ["chart.png"]})json";

const char* const kReadme = "Top.\n<!-- nuovo refs: lines -->\nold\n<!-- end of lines -->\nMiddle.\n"
                            "<!-- nuovo refs: slides -->\n<!-- end of slides -->\n"
                            "<!-- nuovo refs: errata -->\n<!-- end of errata -->\nBottom.\n";

class Refs : public test::OnDisk {
  protected:
    Refs() {
        for (const char* folder : {"lessons", "shaders/terms", "slides_refs"})
            fs::create_directories(directory / folder);
        for (const auto& [file, text] : files)
            put("lessons/" + file, text);
        put("shaders/terms/clamp.glsl", "// TERM clamp\nfloat f(float c)\n{ return max(0.0, c); }\n");
        put("slides_refs/slides.json", kCompanion);
        put("slides_refs/README.md", kReadme);
    }
    void put(const std::string& file, const std::string& text) const {
        std::ofstream(directory / file, std::ios::binary) << text;
    }
    std::string text(const std::string& file) const {
        std::ifstream stream(directory / file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    void replace(const std::string& file, const std::string& from, const std::string& to) const {
        std::string whole = text(file);
        ASSERT_NE(whole.find(from), std::string::npos) << from;
        put(file, whole.replace(whole.find(from), from.size(), to));
    }
    Companion companion() const { return readCompanion(directory / "slides_refs/slides.json"); }
    LessonSet lessons() const { return readLessons(directory / "lessons"); }
    int renew(bool isCheck) const {
        return renewReadme(companion(), lessons(), directory / "slides_refs/README.md", isCheck);
    }
    // What the refusal says; empty, which fails every expectation below, if there was none.
    template <class Action>
    static std::string refusal(const Action& action) {
        try {
            action();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(Refs, CheckWritesNothingAndRenewMakesItPass) {
    EXPECT_EQ(renew(true), 3);  // the first line between the first markers
    EXPECT_EQ(text("slides_refs/README.md"), kReadme);
    EXPECT_NE(renew(false), 0);
    EXPECT_EQ(renew(true), 0);
    const std::string readme = text("slides_refs/README.md");
    EXPECT_EQ(readme.rfind("Top.\n", 0), 0U);
    EXPECT_NE(readme.find("\nMiddle.\n"), std::string::npos);
    EXPECT_NE(readme.find("\nBottom.\n"), std::string::npos);
    EXPECT_EQ(readme.find("\nold\n"), std::string::npos);
}

TEST_F(Refs, LinksOpenTheLine) {
    renew(false);
    const std::string readme = text("slides_refs/README.md");
    for (const std::string& link : {
             "[`THREE::MeshLambertMaterial mioMat;`](../lessons/lesson_01_material.cpp#L" +
                 std::to_string(lineOf(k01, "THREE::MeshLambertMaterial")) + ")",
             "[`miaScena.add(miaLuce)`](../lessons/lesson_02_light.cpp#L" +
                 std::to_string(lineOf(k02, "miaScena.add(miaLuce)")) + ")",
             std::string("[`max(0.0`](../shaders/terms/clamp.glsl#L3)"),
         })
        EXPECT_NE(readme.find(link), std::string::npos) << link << "\n" << readme;
    EXPECT_EQ(readme.find("Slide 36.1"), std::string::npos) << "comments are no lines of code";
}

TEST_F(Refs, AMovedLineMakesItStale) {
    renew(false);
    replace("shaders/terms/clamp.glsl", "float f", "\nfloat f");
    EXPECT_NE(renew(true), 0);
}

TEST_F(Refs, AnswersAreHiddenAndTextIsEscaped) {
    renew(false);
    const std::string readme = text("slides_refs/README.md");
    const auto details = readme.find("<details><summary>Risposta");
    ASSERT_NE(details, std::string::npos);
    EXPECT_LT(readme.find("pictures/slide_36_a.png"), details);
    EXPECT_GT(readme.find("pictures/slide_36_b.png"), details);
    EXPECT_LT(readme.find("> **Before you look.** what?"), details);
    EXPECT_NE(readme.find("alt=\"&quot;black&quot;\""), std::string::npos);
    EXPECT_NE(readme.find("| 3, 36 | error | says \\| so | should | because |"), std::string::npos);
    EXPECT_NE(readme.find("| 36 | typo | type | letter |"), std::string::npos);
}

TEST_F(Refs, RefusesMarkersThatAreMissingTwiceOrSwapped) {
    put("slides_refs/README.md", "no markers");
    EXPECT_NE(refusal([&] { renew(true); }).find("found it nowhere"), std::string::npos);
    put("slides_refs/README.md", std::string(kReadme) + kReadme);
    EXPECT_NE(refusal([&] { renew(true); }).find("found it several times"), std::string::npos);
    put("slides_refs/README.md", kReadme);
    replace("slides_refs/README.md", "<!-- nuovo refs: slides -->\n<!-- end of slides -->\n",
            "<!-- end of slides -->\n<!-- nuovo refs: slides -->\n");
    EXPECT_NE(refusal([&] { renew(true); }).find("stands before its beginning"), std::string::npos);
}

TEST_F(Refs, RefusesLinesThatAreNotThereOrNotAlone) {
    replace("shaders/terms/clamp.glsl", "max(0.0", "max(0");
    EXPECT_NE(refusal([&] { renew(true); }).find("clamp.glsl: expected one line with \"max(0.0\", found 0"),
              std::string::npos);
    put("shaders/terms/clamp.glsl", "max(0.0\nmax(0.0\n");
    EXPECT_NE(refusal([&] { renew(true); }).find("found 2"), std::string::npos);
    fs::remove(directory / "shaders/terms/clamp.glsl");
    EXPECT_NE(refusal([&] { renew(true); }).find("cannot be read"), std::string::npos);
}

TEST_F(Refs, NamesTheFieldThatIsMissing) {
    replace("slides_refs/slides.json", "\"answer\": {\"it\"", "\"reply\": {\"it\"");
    const std::string message = refusal([&] { companion(); });
    EXPECT_NE(message.find("/slides/0/predict"), std::string::npos) << message;
    EXPECT_NE(message.find("answer"), std::string::npos) << message;
}

TEST_F(Refs, PrintsEveryPictureOnceWithItsCommand) {
    std::ostringstream out;
    printPictures(companion(), lessons(), out);
    EXPECT_EQ(out.str(), "interlude_brdf.png\tinterlude_brdf --size 320x320\n"
                         "lesson_00_scene.png\tlesson_00_scene --size 320x320\n"
                         "lesson_01_material.png\tlesson_01_material --size 320x320\n"
                         "lesson_02_light.png\tlesson_02_light --size 320x320\n"
                         "lesson_03_ambient.png\tlesson_03_ambient --size 320x320\n"
                         "other.png\tlesson_01_material --time 1 --size 4x4\n"
                         "slide_36_a.png\tlesson_01_material --terms -clamp --size 240x240\n"
                         "slide_36_b.png\tlesson_02_light --size 9x8\n"
                         "chart.png\t\n");
}

TEST_F(Refs, RefusesAPictureThatIsDrawnInTwoWays) {
    replace("slides_refs/slides.json", "slide_36_b.png", "slide_36_a.png");
    EXPECT_NE(
        refusal([&] { picturesToDraw(companion(), lessons()); }).find("slide_36_a.png is drawn in two ways"),
        std::string::npos);
    put("slides_refs/slides.json", kCompanion);
    replace("slides_refs/slides.json", "[\"chart.png\"]", "[\"other.png\"]");
    EXPECT_NE(refusal([&] { picturesToDraw(companion(), lessons()); }).find("pictures_elsewhere"),
              std::string::npos);
}

}  // namespace
