// Breaks each rule once, in lessons on disk, and expects the failure at its file and line.
// SPDX-License-Identifier: MIT
#include "fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace nuovo::test {
namespace {

class Nuovo : public OnDisk {
  protected:
    /// Expects one failure of the rule at file:line, and its place and row in what is printed.
    void expectFailure(Rule rule, const std::string& file, int line) const {
        const Report found = report();
        std::ostringstream text;
        std::ostringstream matrix;
        printFailures(found, text);
        printMatrix(found, matrix);
        const auto it =
            std::find_if(found.failures.begin(), found.failures.end(), [&](const Failure& failure) {
                return failure.rule == rule && failure.file == directory / file && failure.line == line;
            });
        ASSERT_NE(it, found.failures.end())
            << "expected " << name(rule) << " at " << file << ':' << line << ", found\n"
            << text.str();
        const std::string place =
            (directory / file).string() + ':' + std::to_string(line) + ": " + name(rule) + ": ";
        EXPECT_NE(text.str().find(place), std::string::npos) << text.str();
        EXPECT_FALSE(it->expected.empty() || it->found.empty() || it->remedy.empty()) << text.str();
        EXPECT_NE(matrix.str().find(std::string(name(rule)) + " FAILED"), std::string::npos) << matrix.str();
    }
};

TEST_F(Nuovo, TheSmallChainIsValid) {
    std::ostringstream text;
    printFailures(report(), text);
    EXPECT_EQ(text.str(), "");
}

TEST_F(Nuovo, ChainCatchesAnUntaggedNewLine) {
    edit(k02, "DirectionalLight miaLuce;  // NUOVO 36.3", "DirectionalLight miaLuce;");
    expectFailure(Rule::Chain, k02, lineOf(k02, "DirectionalLight"));
}

TEST_F(Nuovo, ChainCatchesALostLine) {
    edit(k02, "    mioMat.color.set(0xFF8855);\n", "");
    expectFailure(Rule::Chain, k02, lineOf(k02, "return app"));
}

TEST_F(Nuovo, ChainCatchesAnEditedOldLine) {
    edit(k01, "// PRIMA THREE::Mesh miaMesh(buffers);", "// PRIMA THREE::Mesh miaMesh(buffer);");
    expectFailure(Rule::Chain, k01, 12);
    const Report found = report();
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.failures[0].expected[0], "lesson_00_scene.cpp:9:     THREE::Mesh miaMesh(buffers);");
    EXPECT_EQ(found.failures[0].found[0], "lesson_01_material.cpp:12:     THREE::Mesh miaMesh(buffer);");
}

TEST_F(Nuovo, ChainCatchesAnotherLessonsName) {
    edit(k02, "\"lesson_02_light\"", "\"lesson_01_material\"");
    expectFailure(Rule::Chain, k02, lineOf(k02, "lab::App"));
}

TEST_F(Nuovo, ChainKeepsIndentationByteForByte) {
    edit(k01, "    // PRIMA THREE", "  // PRIMA   THREE");  // restores to the same four blanks
    EXPECT_TRUE(report().ok());
    edit(k01, "  // PRIMA   THREE", "  // PRIMA THREE");
    expectFailure(Rule::Chain, k01, 12);
}

TEST_F(Nuovo, CountRefusesATagInLesson00) {
    edit(k00, "miaMesh(buffers);", "miaMesh(buffers);  // NUOVO 3");
    expectFailure(Rule::Count, k00, 9);
}

TEST_F(Nuovo, CountRefusesAStepWithoutNewLines) {
    files["lesson_04_empty.cpp"] = "// lesson_04_empty: none\n\nint x;\n";
    expectFailure(Rule::Count, "lesson_04_empty.cpp", 1);
}

TEST_F(Nuovo, CountRefusesTwentyOneNewLines) {
    std::string lines;
    for (int i = 0; i < 17; ++i) {
        lines += "    x();  // NUOVO 42\n";
    }
    edit(k03, "    luceAmbiente.intensity", lines.substr(22) + "    luceAmbiente.intensity");  // 20 in all
    EXPECT_TRUE(report().ok());
    edit(k03, "    luceAmbiente.intensity", lines.substr(0, 22) + "    luceAmbiente.intensity");
    expectFailure(Rule::Count, k03, lineOf(k03, "intensity"));
}

TEST_F(Nuovo, CountRefusesFourOldLines) {
    edit(k01, "miaMesh(buffers);\n", "miaMesh(buffers);\n    // PRIMA a();\n    // PRIMA b();\n");
    edit(k00, "miaMesh(buffers);\n", "miaMesh(buffers);\n    a();\n    b();\n");
    EXPECT_TRUE(report().ok());
    edit(k01, "// PRIMA b();\n", "// PRIMA b();\n    // PRIMA c();\n");
    edit(k00, "b();\n", "b();\n    c();\n");
    expectFailure(Rule::Count, k01, 15);
}

TEST_F(Nuovo, SlidesRefusesASlideThatIsNotThere) {
    edit(k03, "// NUOVO 42", "// NUOVO 41");
    expectFailure(Rule::Slides, k03, lineOf(k03, "intensity"));
}

TEST_F(Nuovo, SlidesRefusesAnItemThatIsNotThere) {
    edit(k03, "// NUOVO 42", "// NUOVO 42.1");
    expectFailure(Rule::Slides, k03, lineOf(k03, "intensity"));
}

TEST_F(Nuovo, SlidesRefusesWhatTheHeaderDoesNotName) {
    edit(k03, "// NUOVO 42", "// NUOVO 34");
    expectFailure(Rule::Slides, k03, lineOf(k03, "intensity"));
}

TEST_F(Nuovo, ItemsRefusesALostLine) {
    edit(k03, "    miaScena.add(luceAmbiente);  // NUOVO 43\n", "");
    expectFailure(Rule::Items, k03, lineOf(k03, "AmbientLight"));
}

TEST_F(Nuovo, ItemsRefusesTheWrongOrder) {
    edit(k03, "    THREE::AmbientLight luceAmbiente;  // NUOVO 43\n", "");
    edit(k03, "(luceAmbiente);  // NUOVO 43\n",
         "(luceAmbiente);  // NUOVO 43\n    THREE::AmbientLight luceAmbiente;  // NUOVO 43\n");
    expectFailure(Rule::Items, k03, lineOf(k03, "miaScena.add(luceAmbiente)"));
}

TEST_F(Nuovo, ItemsRefusesALineThatIsNotOnTheSlide) {
    edit(k03, "// NUOVO 42", "// NUOVO 43");
    expectFailure(Rule::Items, k03, lineOf(k03, "intensity"));
}

TEST_F(Nuovo, ItemsRefusesAnotherLessonsItem) {
    edit(k03, "// Slides 40-43", "// Slides 36, 40-43");
    edit(k03, "// NUOVO 42", "// NUOVO 36.2");
    expectFailure(Rule::Items, k03, lineOf(k03, "intensity"));
}

TEST_F(Nuovo, ItemsRefusesAnItemWithoutLesson) {
    const auto at = slides.find("lesson_03_ambient");
    slides.replace(at, 17, "lesson_03_ambience");
    expectFailure(Rule::Items, "slides.json", 1);
}

TEST_F(Nuovo, CommentRefusesAnUnexplainedRun) {
    edit(k03, "    // Slide 43: luce ambiente, perché no  // NUOVO 43\n", "");
    expectFailure(Rule::Comment, k03, lineOf(k03, "AmbientLight"));
}

TEST_F(Nuovo, CommentIsNotAskedOfAReplacedLine) {
    files = {{k00, "int a;\nint b;\n"}, {k01, "int a;\nint c;  // NUOVO 36\n// PRIMA int b;\n"}};
    slides = R"({"slides": [{"number": 36}]})";
    EXPECT_TRUE(report().ok());
    files[k01] = "int a;\nint c;  // NUOVO 36\nint d;  // NUOVO 36\n// PRIMA int b;\n";
    expectFailure(Rule::Comment, k01, 2);
}

TEST_F(Nuovo, WidthCountsCharactersBeforeTheTag) {
    const std::string line = "    // Slide 43: luce ambiente, perché no";
    const std::string dots(84 - (line.size() - 1), '.');  // é is two bytes
    edit(k03, line, line + dots);
    EXPECT_TRUE(report().ok());
    edit(k03, dots, dots + '.');
    expectFailure(Rule::Width, k03, lineOf(k03, "Slide 43"));
}

TEST_F(Nuovo, TagsRefusesEveryOtherSpelling) {
    const char* const spellings[] = {"  // NUOVO: 42",   "  // NUOVO 42 ",      "  // NUOVO 42\r",
                                     "  // nuovo 42",    "  // Nuovo: 42",      "  //NUOVO 42",
                                     "  // NUOVO  42",   "  // NUOVO",          "  // NUOVO 42.",
                                     "  // NUOVO 042",   "  // NUOVA 42",       "  /* NUOVO 42 */",
                                     "// NUOVO 42",      "  // NUOVO 42-43",    "  // nuovo",
                                     "  // NUOVO 42x",   "  // NUOVO slide 42", "  // NUOVO 42  // NUOVO 42",
                                     "  // NUOVO 99999", "  // PRIMA 42"};
    const std::string valid = files.at(k03);
    for (const char* const spelling : spellings) {
        SCOPED_TRACE(spelling);
        files[k03] = valid;
        edit(k03, "  // NUOVO 42", spelling);
        expectFailure(Rule::Tags, k03, lineOf(k03, "intensity"));
    }
}

TEST_F(Nuovo, TagsRefusesEveryOtherPrima) {
    const char* const spellings[] = {"    //PRIMA THREE::Mesh",           "    // PRIMA: THREE::Mesh",
                                     "    // prima: THREE::Mesh",         "    a(); // PRIMA THREE::Mesh",
                                     "    // PRIMA // PRIMA THREE::Mesh", "\n    // PRIMA THREE::Mesh"};
    const std::string valid = files.at(k01);
    for (const char* const spelling : spellings) {
        SCOPED_TRACE(spelling);
        files[k01] = valid;
        edit(k01, "    // PRIMA THREE::Mesh", spelling);
        expectFailure(Rule::Tags, k01, spelling[0] == '\n' ? 13 : 12);
    }
}

TEST_F(Nuovo, TagsRefusesTagsThatMarkNothing) {
    edit(k03, "    return app", "  // NUOVO 42\n    return app");
    expectFailure(Rule::Tags, k03, lineOf(k03, "  // NUOVO 42\n    return"));
    edit(k03, "// Slides 40-43", "// Slides 40-43  // NUOVO 42");
    expectFailure(Rule::Tags, k03, 2);
}

TEST_F(Nuovo, PlaceRefusesMarksOutsideTheChain) {
    edit("interlude_brdf.cpp", "{ return 0; }", "{ return 0; }  // NUOVO 36\n");
    expectFailure(Rule::Place, "interlude_brdf.cpp", 3);
}

TEST_F(Nuovo, NumberRefusesGapRepetitionAndOtherNames) {
    files["lesson_04_a.cpp"] = files["lesson_04_b.cpp"] = files["lesson_06_c.cpp"] = files["lesson_7_d.cpp"] =
        "int x;\n";
    expectFailure(Rule::Number, "lesson_04_b.cpp", 1);
    expectFailure(Rule::Number, "lesson_06_c.cpp", 1);
    expectFailure(Rule::Number, "lesson_7_d.cpp", 1);
}

TEST(NuovoLesson, HeaderIsReadTolerantly) {
    const auto slidesOf = [](const std::string& line) {
        std::string text;
        for (const SlideRange& range :
             parseLesson("lesson_09_x.cpp", "// Any title\n" + line + "\n\n").slides) {
            text += toString(range) + ' ';
        }
        return text;
    };
    EXPECT_EQ(slidesOf("// Slides 29-30, 37.5-37.6, 38: two lamps"), "29-30 37.5-37.6 38 ");
    EXPECT_EQ(slidesOf("// Slide: 31."), "31 ");
    EXPECT_EQ(slidesOf("//slides 40\xE2\x80\x93"
                       "43, and more"),
              "40-43 ");
    EXPECT_EQ(slidesOf("// no such line"), "");
    EXPECT_EQ(parseLesson("lesson_09_x.cpp", "// Any title\n").title, "Any title");
    EXPECT_EQ(parseLesson("lesson_09_x.cpp", "").title, "");
}

TEST(NuovoLesson, NamesAndMarksAreWholeWords) {
    EXPECT_EQ(withoutOwnName("lesson_01_a b", "lesson_01_a"), "\x1f b");
    EXPECT_EQ(withoutOwnName("lesson_01_ab xlesson_01_a", "lesson_01_a"), "lesson_01_ab xlesson_01_a");
    const Lesson lesson =
        parseLesson("lesson_01_x.cpp", "int PRIMARY, X_PRIMA;  // prima di un nuovo giorno\n");
    EXPECT_EQ(lesson.lines.at(0).kind, LineKind::Same);
}

TEST(NuovoLesson, CommentsAreFoundOutsideQuotes) {
    EXPECT_EQ(commentStart("a(\"// no\");  // yes"), 13U);
    EXPECT_EQ(commentStart("a('\"', 1'000); // yes"), 15U);
    EXPECT_EQ(commentStart("a(\"\\\"// no\");"), std::string::npos);
}

}  // namespace
}  // namespace nuovo::test
