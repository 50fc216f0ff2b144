// Loops over lights that are written out, and those that stay as they are.
// SPDX-License-Identifier: MIT
#include "render/shader_loops.hpp"
#include "render/shader_source.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>
#include <regex>

namespace {

using render::LoopWriter;

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

// The text with its first line's loop written out; "as it is" if it is to stay.
std::string written(const std::string& preamble, const std::string& text) {
    const LoopWriter writer(preamble);
    const std::vector<std::string> lines = linesOf(text);
    const auto loop = writer.read(lines, 0);
    if (!loop)
        return "as it is";
    std::string out;
    for (const render::LoopLine& line : writer.writeOut(*loop, lines)) {
        EXPECT_LT(line.from, lines.size());
        out += line.text + "\n";
    }
    return out;
}

const char* const constants = "#define LIGHTS_ARE_CONSTANTS 1\n#define N 3\n#define LONG_LOOPS 0\n";

std::string loopOver(const std::string& begin, const std::string& end) {
    return "#pragma unroll\nfor (int i = " + begin + "; i < " + end + "; ++i)\n  f(i);\n";
}

TEST(Loops, EveryTurnOfALine) {
    EXPECT_EQ(written(constants, loopOver("0", "2")),
              "{ const int i = 0;\n  f(i);\n}\n{ const int i = 1;\n  f(i);\n}\n");
    EXPECT_EQ(written(constants, loopOver("1", "N")),
              "{ const int i = 1;\n  f(i);\n}\n{ const int i = 2;\n  f(i);\n}\n");
    EXPECT_EQ(written(constants, loopOver("N", "N")), "") << "no turn";
    EXPECT_EQ(written(constants, loopOver("5", "N")), "");
}

TEST(Loops, EveryTurnOfABlock) {
    const std::string block =
        "#pragma unroll\nfor (int i = 0; i < 2; ++i) {\n  if (i > 0) {\n    f(i);\n  }\n}\nrest\n";
    EXPECT_EQ(written(constants, block), "{ const int i = 0;\n  if (i > 0) {\n    f(i);\n  }\n}\n"
                                         "{ const int i = 1;\n  if (i > 0) {\n    f(i);\n  }\n}\n");
    EXPECT_EQ(written(constants, "#pragma unroll\nfor (int i = 0; i < 1; ++i)\n  f(i,\n    g);\nrest\n"),
              "{ const int i = 0;\n  f(i,\n    g);\n}\n")
        << "a statement of two lines";
}

TEST(Loops, BoundsThatAreNoNumbersStay) {
    for (const char* const end : {"begin_0", "N + 1", "3.0", "M", "(3)"})
        EXPECT_EQ(written(constants, loopOver("0", end)), "as it is") << end;
    EXPECT_EQ(written(constants, loopOver("first", "3")), "as it is");
}

TEST(Loops, WithoutConstantsTheyStay) {
    EXPECT_EQ(written("#define LIGHTS_ARE_CONSTANTS 0\n#define LONG_LOOPS 0\n", loopOver("0", "2")),
              "as it is");
    EXPECT_EQ(written("", loopOver("0", "2")), "as it is");
}

TEST(Loops, TextThatIsNoLoopStaysAsItIs) {
    for (const char* const text :
         {"#pragma unrol\nfor (int i = 0; i < 2; ++i)\n  f(i);\n", "for (int i = 0; i < 2; ++i)\n  f(i);\n",
          "#pragma unroll\nfor (int i = 0; i < 2; i++)\n  f(i);\n",
          "#pragma unroll\nfor (int i = 0; j < 2; ++i)\n  f(i);\n",
          "#pragma unroll\nfor (int i = 0; i <= 2; ++i)\n  f(i);\n",
          "#pragma unroll\nfor (int i = 0; i < 2; ++j)\n  f(i);\n", "#pragma unroll\nwhile (true)\n  f(i);\n",
          "#pragma unroll\nfor (int i = 0; i < 2; ++i)\n  f(i)\n",
          "#pragma unroll\nfor (int i = 0; i < 2; ++i) {\n  f(i);\n",
          "#pragma unroll\nfor (uint i = 0; i < 2; ++i)\n  f(i);\n", "#pragma unroll\n",
          "#pragma unroll\nfor (\n", "#pragma unroll\nfor (int i = 0; i < 2; ++i)\n"})
        EXPECT_EQ(written(constants, text), "as it is") << text;
}

// Runs what was written for LONG_LOOPS in a tiny interpreter's stead: the same turns, four at a time.
TEST(Loops, FourLightsATurn) {
    const std::string preamble = "#define LIGHTS_ARE_CONSTANTS 0\n#define LONG_LOOPS 1\n";
    const std::string text = written(preamble, loopOver("a", "b"));
    EXPECT_EQ(text.substr(0, text.find('\n')), "for (int i_first = a; i_first < b; i_first += 4) {");
    EXPECT_NE(text.find("{ int i = i_first;\n  f(i);\n}\n"), std::string::npos) << text;
    const std::regex more(
        "if \\(i_first \\+ ([0-9]) < b\\) \\{ int i = i_first \\+ ([0-9]);\n  f\\(i\\);\n\\}\n");
    std::vector<std::string> turns;
    for (std::sregex_iterator it(text.begin(), text.end(), more), end; it != end; ++it) {
        EXPECT_EQ((*it)[1], (*it)[2]);
        turns.push_back((*it)[1]);
    }
    EXPECT_EQ(turns, (std::vector<std::string>{"1", "2", "3"}));
    EXPECT_TRUE(text.ends_with("}\n}\n"));
    for (int count = 0; count < 10; ++count) {  // what those lines do
        std::vector<int> done;
        for (int first = 0; first < count; first += 4) {
            done.push_back(first);
            for (const std::string& turn : turns)
                if (first + std::stoi(turn) < count)
                    done.push_back(first + std::stoi(turn));
        }
        ASSERT_EQ(done.size(), static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
    }
}

// An error inside a loop that was written out still names the line that the student wrote.
TEST(Loops, LinesKeepTheirNumbers) {
    support::TemporaryDirectory directory;
    support::writeFile(directory.file("main.frag"),
                       "one\n#pragma unroll\nfor (int i = 0; i < 2; ++i)\n  wrong(i);\nfive\n");
    const render::ShaderSource source = render::readShader(directory.path().string(), "main.frag", constants);
    EXPECT_EQ(source.text, std::string(constants) +
                               "one\n{ const int i = 0;\n  wrong(i);\n}\n{ const int i = 1;\n  "
                               "wrong(i);\n}\nfive\n");
    int told = 0;
    const std::vector<std::string> lines = linesOf(source.text);
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i] == "  wrong(i);") {
            const std::string message =
                render::explain("0:" + std::to_string(i + 1) + "(3): error: no such function",
                                directory.path().string(), source);
            EXPECT_EQ(message.rfind("main.frag:4:", 0), 0U) << message;
            ++told;
        }
    EXPECT_EQ(told, 2);
    EXPECT_EQ(source.lines.back().line, 5U);
}

}  // namespace
