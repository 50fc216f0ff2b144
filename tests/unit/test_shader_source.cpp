// Includes put together, and drivers' messages led back to the file and line that a student wrote.
// SPDX-License-Identifier: MIT
#include "image/home.hpp"
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

// A lab of its own, whose shaders are main.frag and two files that it includes, and a folder to lay over it.
struct ShaderOverlay : testing::Test {
    support::TemporaryDirectory lab;
    support::TemporaryDirectory mine;
    ShaderOverlay() {
        std::filesystem::create_directories(own("terms"));
        support::writeFile(own("mesh.vert"), "v\n");
        support::writeFile(own("main.frag"), "a\n#include \"one.glsl\"\n#include \"terms/two.glsl\"\n");
        support::writeFile(own("one.glsl"), "wrong\n");
        support::writeFile(own("terms/two.glsl"), "2\n");
        std::filesystem::create_directories(mine.file("terms"));
        image::setHome(lab.path().string());
    }
    ~ShaderOverlay() override { image::setHome(""); }
    std::string own(const std::string& name) const { return lab.file("share/lambert-lab/shaders/" + name); }
    // What findShaderDirectory says to it; empty if it finds the folder.
    static std::string refusal(const std::string& asked) {
        try {
            EXPECT_EQ(render::findShaderDirectory(asked), asked);
        } catch (const render::ShaderError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(ShaderOverlay, TakesItsFilesAndTheLabsOthers) {
    support::writeFile(mine.file("terms/two.glsl"), "mine\n#include \"three.glsl\"\n");
    support::writeFile(mine.file("three.glsl"), "3\n");
    const std::string directory = render::findShaderDirectory(mine.path().string());
    const render::ShaderSource source = render::readShader(directory, "main.frag", "");
    EXPECT_EQ(source.text, "a\nwrong\nmine\n3\n");
    ASSERT_EQ(source.lines.size(), 4U);
    EXPECT_EQ(source.lines[0].file, own("main.frag")) << "the lab's own by their full path";
    EXPECT_EQ(source.lines[2].file, "terms/two.glsl");
    EXPECT_EQ(source.lines[3].file, "three.glsl") << "one that the lab does not have";
    const std::string theirs = render::explain("0:2(1): error: x", directory, source);
    EXPECT_EQ(theirs.rfind(own("one.glsl") + ":1:", 0), 0U) << theirs;
    EXPECT_NE(theirs.find("  > 1 | wrong"), std::string::npos) << theirs;
    const std::string ours = render::explain("0:3(1): error: x", directory, source);
    EXPECT_EQ(ours.rfind("terms/two.glsl:1:", 0), 0U) << ours;
    EXPECT_NE(ours.find("  > 1 | mine"), std::string::npos) << ours;
}

TEST_F(ShaderOverlay, RefusesFoldersThatCannotBeMeant) {
    EXPECT_NE(refusal(mine.path().string()).find("has none of the lab's shader files"), std::string::npos);
    EXPECT_NE(refusal(mine.file("nowhere")).find("there is no folder"), std::string::npos);
    support::writeFile(mine.file("two.glsl"), "2\n");
    EXPECT_NE(refusal(mine.path().string()).find("terms/cosine.glsl"), std::string::npos)
        << "it stands one folder too high";
    EXPECT_NE(refusal(mine.file("two.glsl")).find("there is no folder"), std::string::npos);
    support::writeFile(mine.file("one.glsl"), "1\n");
    EXPECT_EQ(refusal(mine.path().string()), "");
    EXPECT_EQ(render::findShaderDirectory(""), own("").substr(0, own("").size() - 1));
    image::setHome(mine.path().string());
    EXPECT_NE(refusal(mine.path().string()).find("the lab's shaders are gone"), std::string::npos);
}

}  // namespace
