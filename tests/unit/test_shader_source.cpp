// Includes put together, and drivers' messages led back to the file and line that a student wrote.
// SPDX-License-Identifier: MIT
#include "render/error.hpp"
#include "render/shader_source.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

namespace {

struct ShaderSource : testing::Test {
    support::TemporaryDirectory directory;
    void write(const std::string& name, const std::string& text) {
        support::writeFile(directory.file(name), text);
    }
    render::ShaderSource read() {
        return render::readShader(directory.path().string(), "main.frag", "#version 300 es\n");
    }
};

TEST_F(ShaderSource, EachFileOnceInItsPlace) {
    write("main.frag", "a\n#include \"one.glsl\"\nb\n  #  include \"two.glsl\"  \nc\n");
    write("one.glsl", "1\n#include \"two.glsl\"\n#include \"main.frag\"\n");
    write("two.glsl", "2\n");
    const render::ShaderSource source = read();
    EXPECT_EQ(source.text, "#version 300 es\na\n1\n2\nb\nc\n");
    ASSERT_EQ(source.lines.size(), 6U);
    EXPECT_EQ(source.lines[0].line, 0U) << "the framework's own";
    EXPECT_EQ(source.lines[3].file, "two.glsl");
    EXPECT_EQ(source.lines[5].file, "main.frag");
    EXPECT_EQ(source.lines[5].line, 5U);
}

TEST_F(ShaderSource, OnlyIncludesAreIncludes) {
    const std::string text =
        "#define include \"x\"\n// #include \"x\"\n#include <x>\n#include x\n#includes \"x\"\n";
    write("main.frag", text);
    EXPECT_EQ(read().text, "#version 300 es\n" + text);
}

TEST_F(ShaderSource, AMissingFileIsNamedWithWhoAsked) {
    write("main.frag", "a\n#include \"gone.glsl\"\n");
    try {
        read();
        FAIL() << "a missing file was accepted";
    } catch (const render::ShaderError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("main.frag:2: "), std::string::npos) << message;
        EXPECT_NE(message.find("gone.glsl"), std::string::npos) << message;
    }
}

TEST_F(ShaderSource, EveryDriversMessageNamesTheFile) {
    write("main.frag", "a\n#include \"one.glsl\"\nb\n");
    write("one.glsl", "1\nwrong\n3\n");
    const render::ShaderSource source = read();  // "wrong" is line 4 of what the driver gets
    for (const char* message : {"0:4(3): error: no such thing", "0(4) : error C1008: no such thing",
                                "ERROR: 0:4: no such thing", "0:4: error: no such thing"}) {
        const std::string text = render::explain(message, directory.path().string(), source);
        EXPECT_EQ(text.rfind("one.glsl:2:", 0), 0U) << message << " became " << text;
        EXPECT_NE(text.find("no such thing"), std::string::npos) << text;
        EXPECT_NE(text.find("  > 2 | wrong"), std::string::npos) << text;
    }
    for (const char* message : {"something else", "0:999(1): error: x", "0:1(1): error: in the preamble", ""})
        EXPECT_NE(render::explain(message, directory.path().string(), source).find(message),
                  std::string::npos);
}

}  // namespace
