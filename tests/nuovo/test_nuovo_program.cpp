// Runs the program itself: exit statuses, messages on unreadable input, the table.
// SPDX-License-Identifier: MIT
#include "fixture.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>

namespace fs = std::filesystem;

namespace nuovo::test {
namespace {

class NuovoProgram : public OnDisk {
  protected:
    /// The program's exit status; what it wrote to both streams ends in `output`.
    int run(const std::string& arguments) {
        const std::string command = std::string("'") + NUOVO_PROGRAM + "' " + arguments + " 2>&1";
        FILE* const pipe = popen(command.c_str(), "r");
        EXPECT_NE(pipe, nullptr);
        output.clear();
        char buffer[4096];
        for (std::size_t n = fread(buffer, 1, sizeof buffer, pipe); n > 0;
             n = fread(buffer, 1, sizeof buffer, pipe)) {
            output.append(buffer, n);
        }
        return WEXITSTATUS(pclose(pipe));
    }

    std::string inputs() const {
        return "--lessons '" + directory.string() + "' --slides '" + (directory / "slides.json").string() +
               "'";
    }

    std::string output;
};

TEST_F(NuovoProgram, SaysOkOrFailed) {
    write();
    EXPECT_EQ(run("check " + inputs()), 0) << output;
    EXPECT_NE(output.find("lesson_03_ambient   number ok  chain ok  count ok"), std::string::npos) << output;
    EXPECT_NE(output.find("ok: 4 lessons, 12 NUOVO lines, 1 PRIMA, 5 code items\n"), std::string::npos)
        << output;
    edit(k03, "mioMat.color", "miaMat.color");
    write();
    EXPECT_EQ(run("check " + inputs()), 1) << output;
    EXPECT_NE(output.find("number ok  chain FAILED  count ok"), std::string::npos) << output;
    EXPECT_NE(output.find(k03 + ":13: chain: "), std::string::npos) << output;
}

TEST_F(NuovoProgram, RefusesWrongUsage) {
    for (const char* const arguments :
         {"", "starters", "check --lesson x", "check more", "table --lang fr", "check --slides"}) {
        EXPECT_EQ(run(arguments), 2) << arguments;
        EXPECT_NE(output, "") << arguments;
    }
    EXPECT_EQ(run("--help"), 0);
    EXPECT_EQ(run("check --help"), 0);
}

TEST_F(NuovoProgram, RefusesUnreadableInput) {
    write();
    EXPECT_EQ(run("check --lessons '" + directory.string() + "/none'"), 4) << output;
    EXPECT_EQ(run("check --lessons '" + directory.string() + "' --slides /dev/zero"), 4) << output;
    fs::create_directory(directory / "empty");
    EXPECT_EQ(run("check --lessons '" + directory.string() + "/empty'"), 4) << output;
    fs::create_directory(directory / "lesson_04_folder.cpp");
    EXPECT_EQ(run("table " + inputs()), 4) << output;
    EXPECT_NE(output.find("lesson_04_folder.cpp: expected a file"), std::string::npos) << output;
}

TEST_F(NuovoProgram, RefusesBrokenSlides) {
    const std::string deep(200000, '[');
    const std::pair<std::string, const char*> cases[] = {
        {"", "expected JSON"},
        {std::string(kSlides).substr(0, 300), "expected JSON"},
        {deep + std::string(deep.size(), ']'), "the whole: expected an object"},
        {"{\"slides\": " + deep + std::string(deep.size(), ']') + "}", "slides[0]: expected an object"},
        {R"({"slides": [{"number": "36"}]})", "slides[0].number: expected"},
        {R"({"slides": [{"number": 1e999}]})", "expected JSON"},
        {R"({"slides": [{"number": 3}, {"number": 3}]})", "slides[1].number: expected every slide once"},
        {R"({"slides": [{"number": 3, "code": {}}]})", "slides[0].code: expected an array"},
        {R"({"slides": [{"number": 3, "code": [{"item": "3.1"}]}]})",
         "slides[0].code[0].lesson: expected a string"},
        {R"({"slides": [{"number": 3, "code": [{"item": "4.1", "lesson": "x", "cpp": ["y"]}]}]})",
         "an item of slide 3"},
        {R"({"slides": [{"number": 3, "code": [{"item": "3.1", "lesson": "x", "cpp": []}]}]})",
         "code[0].cpp: expected"},
        {R"({"slides": [{"number": 3, "code": [{"item": "3.1", "lesson": "x", "cpp": [7]}]}]})",
         "cpp[0]: expected a string"},
    };
    for (const auto& [text, message] : cases) {
        slides = text;
        write();
        EXPECT_EQ(run("check " + inputs()), 4) << text.substr(0, 100);
        EXPECT_NE(output.find(message), std::string::npos) << output;
    }
}

TEST_F(NuovoProgram, SurvivesOddBytes) {
    std::string noise(300000, '/');
    for (std::size_t i = 0; i < noise.size(); i += 7) {
        noise[i] = static_cast<char>(i * 31 % 256);
    }
    files["lesson_04_noise.cpp"] = noise + "// NUOVO 36";
    files["lesson_05_slashes.cpp"] = "x" + std::string(900000, '/');
    write();
    EXPECT_EQ(run("check " + inputs()), 1);
    EXPECT_EQ(output.find('\0'), std::string::npos);
}

TEST_F(NuovoProgram, PrintsTheTable) {
    write();
    ASSERT_EQ(run("table --lang en " + inputs()), 0) << output;
    EXPECT_EQ(output.substr(0, output.find("\n\n") + 1),
              "| lesson | slides | what is new | NUOVO lines |\n|---|---|---|---|\n"
              "| lesson_00_scene | 3, 34 | nothing is lit yet | 0 |\n"
              "| lesson_01_material | 9-15, 36.1-36.2 | the base colour D \\| black | 4 |\n"
              "| lesson_02_light | 16-30, 36.3 | P = (n . w) D (x) L | 4 |\n"
              "| lesson_03_ambient | 40-43 | + D (x) L_A | 4 |\n");
    EXPECT_NE(output.find("### lesson_01_material\n\nSlide 36: Lights in three.js\n\n"), std::string::npos)
        << output;
    EXPECT_NE(output.find("- 36.1 `THREE::Mesh miaMesh(buffers, mioMat);`\n  - instead of `THREE::Mesh "
                          "miaMesh(buffers);`\n"),
              std::string::npos)
        << output;
    ASSERT_EQ(run("table --lang it " + inputs()), 0) << output;
    EXPECT_NE(output.find("| lezione | slide |"), std::string::npos) << output;
    EXPECT_NE(output.find("Slide 36: Luci in three.js"), std::string::npos) << output;
    edit("lesson_03_ambient.cpp", "// Slides 40-43",
         "// Slides 40-41");  // the table adds what the tags cite beyond
    write();
    ASSERT_EQ(run("table --lang it " + inputs()), 0) << output;
    EXPECT_NE(output.find("| lesson_03_ambient | 40-41, 43, 42 |"), std::string::npos) << output;
    EXPECT_EQ(run("table " + inputs() + " > /dev/full"), 5) << output;
}

}  // namespace
}  // namespace nuovo::test
