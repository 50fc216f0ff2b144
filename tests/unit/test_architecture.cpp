// Reads the sources: dependencies point one way, files stay short, lessons stay free of branches and of GL.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = LAMBERT_SOURCE_DIR;
constexpr std::size_t longest = 350;  // lines of a file, so that a student can read it in one go
const std::set<std::string>
    longFiles{};  // what may be longer, by name from the root, with a reason beside it

// Who may include whom: lessons -> lab -> render -> lighting -> three, image beside them.
const std::map<std::string, std::set<std::string>> allowed = {
    {"three", {"three"}},
    {"image", {"image"}},
    {"lighting", {"lighting", "three"}},
    {"render", {"render", "lighting", "three", "image"}},
    {"lab", {"lab", "render", "lighting", "three", "image"}},
    {"lessons", {"lab", "render", "lighting", "three"}},
};

struct Include {
    std::string file;
    char quote;  // " or <
};

std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

// `line` without the blanks and tabs it begins with.
std::string_view trimmed(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    return start == std::string_view::npos ? std::string_view() : line.substr(start);
}

// What follows "#include" in this line; empty if it includes nothing.
std::string_view included(std::string_view line) {
    constexpr std::string_view word = "include";
    line = trimmed(line);
    if (!line.starts_with('#'))
        return {};
    line = trimmed(line.substr(1));
    return line.starts_with(word) ? trimmed(line.substr(word.size())) : std::string_view();
}

std::vector<Include> includesOf(const std::string& text) {
    std::vector<Include> includes;
    for (const std::string& line : linesOf(text)) {
        const std::string_view target = included(line);
        const std::size_t end = target.find_first_of("\">", 1);
        if (end != std::string_view::npos)
            includes.push_back({std::string(target.substr(1, end - 1)), target[0]});
    }
    return includes;
}

// "common/three/color.hpp" belongs to three, "lessons/x.cpp" to lessons.
std::string layerOf(const std::string& name) {
    const fs::path path(name);
    auto part = path.begin();
    if (*part == "common")
        ++part;
    return part->string();
}

// Why this file may not include that one; "" if it may.
std::string complaint(const std::string& file, const Include& include) {
    const std::string target = *fs::path(include.file).begin();
    const std::string layer = layerOf(file);
    if (include.quote == '<') {
        if (allowed.contains(target) && include.file.find('/') != std::string::npos)
            return file + ": <" + include.file + "> is ours, expected it in quotes";
        static const std::set<std::string> graphics = {"GLES2", "GLES3", "EGL", "GL", "GLFW", "KHR"};
        if (graphics.contains(target) && layer != "render" && layer != "lab")
            return file + ": <" + include.file + "> is known to render and lab only";
        return "";
    }
    const auto mayUse = allowed.find(layer);
    if (mayUse == allowed.end())
        return file + ": no layer is called '" + layer + "'; add it to the table in test_architecture.cpp";
    if (include.file.find("..") != std::string::npos || !mayUse->second.contains(target))
        return file + ": includes \"" + include.file + "\", which " + layer + " must not know of";
    // The reference judges the other path, so it shares nothing with it but the scene, and the names of terms and views.
    const std::string reference = "lighting/reference/";
    if (file.find(reference) != std::string::npos && target == "lighting" &&
        !include.file.starts_with(reference) && include.file != "lighting/terms.hpp" &&
        include.file != "lighting/views.hpp")
        return file + ": includes \"" + include.file + "\", which the reference must not share";
    return "";
}

// Source files under some folders, named from the root, sorted.
std::vector<std::string> filesBelow(const std::vector<std::string>& folders,
                                    const std::set<std::string>& endings) {
    std::vector<std::string> files;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file() && endings.contains(entry.path().extension().string()))
                files.push_back(fs::relative(entry.path(), root).generic_string());
    std::sort(files.begin(), files.end());
    return files;
}

// A program without its comments, and its string literals by themselves.
struct Stripped {
    std::string code;  // literals are left as ""
    std::vector<std::string> literals;
};

// Where the literal that begins at `start` ends: behind its closing quote.
std::size_t endOfLiteral(const std::string& text, std::size_t start) {
    std::size_t i = start + 1;
    while (i < text.size() && text[i] != text[start] && text[i] != '\n')
        i += text[i] == '\\' ? 2 : 1;
    return std::min(i + 1, text.size());
}

bool partOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

Stripped strip(const std::string& text) {
    Stripped result;
    for (std::size_t i = 0; i < text.size();) {
        const bool afterWord = i > 0 && partOfWord(text[i - 1]);
        if (text.compare(i, 2, "//") == 0) {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.compare(i, 2, "/*") == 0) {
            const std::size_t end = text.find("*/", i + 2);
            i = end == std::string::npos ? text.size() : end + 2;
            result.code += ' ';
        } else if (text[i] == '"' || (text[i] == '\'' && !afterWord)) {  // 1'000 begins no literal
            const std::size_t end = endOfLiteral(text, i);
            result.literals.push_back(text.substr(i, end - i));
            result.code += "\"\"";
            i = end;
        } else {
            result.code += text[i++];
        }
    }
    return result;
}

// A word that a lesson must not contain: a branch, a name of GL or EGL, or the R of a raw string, which strip() would
// misread. `for` is allowed: slide 38's sum over the lights is a loop over lights.
bool forbidden(const std::string& word) {
    static const std::set<std::string> words = {"if", "else", "while", "do", "switch", "goto", "R"};
    const auto isCall = [&word](const std::string& prefix) {
        return word.starts_with(prefix) && word.size() > prefix.size() &&
               std::isupper(static_cast<unsigned char>(word[prefix.size()])) != 0;
    };
    return words.contains(word) || isCall("gl") || isCall("egl") || word.starts_with("GL_");
}

// What a lesson must not contain: forbidden words, `?`, paths. Empty for a good one.
std::vector<std::string> lessonComplaints(const std::string& text) {
    std::string withoutIncludes;
    for (const std::string& line : linesOf(text))
        if (included(line).empty())
            withoutIncludes += line + '\n';
    const Stripped lesson = strip(withoutIncludes);
    std::vector<std::string> found;
    for (std::size_t i = 0; i < lesson.code.size();) {
        std::size_t end = i;
        while (end < lesson.code.size() && partOfWord(lesson.code[end]))
            ++end;
        if (const std::string word = lesson.code.substr(i, end - i); forbidden(word))
            found.push_back(word);
        if (end == i && lesson.code[end++] == '?')
            found.emplace_back("?");
        i = end;
    }
    for (const std::string& literal : lesson.literals)
        if (literal.find('/') != std::string::npos)
            found.push_back(literal);
    return found;
}

// Whether a file begins with a comment that says what it is for, and the licence below it.
bool beginsWithPurposeAndLicence(const std::string& text) {
    const std::vector<std::string> lines = linesOf(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].starts_with("//") && !lines[i].starts_with("#"))
            return false;
        if (lines[i] == "// SPDX-License-Identifier: MIT" || lines[i] == "# SPDX-License-Identifier: MIT")
            return i > 0;
    }
    return false;
}

// --- the rules

TEST(Architecture, DependenciesPointOneWay) {
    const std::vector<std::string> files = filesBelow({"common", "lessons"}, {".cpp", ".hpp"});
    std::size_t ours = 0;
    for (const std::string& file : files)
        for (const Include& include : includesOf(read(root / file))) {
            EXPECT_EQ(complaint(file, include), "");
            if (include.quote != '"')
                continue;
            ++ours;
            EXPECT_TRUE(fs::exists(root / "common" / include.file))
                << file << ": \"" << include.file
                << "\" is not below common/; quotes are for our own headers";
        }
    EXPECT_GT(ours, files.size() / 2) << "hardly any include was found: is the pattern still right?";
}

TEST(Architecture, FilesAreShort) {
    const std::vector<std::string> files = filesBelow({"common", "lessons", "tests"}, {".cpp", ".hpp"});
    EXPECT_FALSE(files.empty());
    for (const std::string& file : files) {
        const std::size_t limit = longFiles.contains(file) ? std::string::npos : longest;
        EXPECT_LE(linesOf(read(root / file)).size(), limit) << file << ": split it";
    }
    for (const std::string& file : longFiles)
        EXPECT_GT(linesOf(read(root / file)).size(), longest) << file << " needs no exemption any more";
}

TEST(Architecture, EveryFileSaysWhatItIsForAndItsLicence) {
    const std::vector<std::string> files = filesBelow(
        {"common", "lessons", "tests", "shaders"}, {".cpp", ".hpp", ".glsl", ".vert", ".frag", ".sh", ".py"});
    EXPECT_FALSE(files.empty());
    for (const std::string& file : files)
        EXPECT_TRUE(beginsWithPurposeAndLicence(read(root / file)))
            << file << ": expected a comment on line 1 and 'SPDX-License-Identifier: MIT' below it";
    for (const char* file : {"lessons/run", "tests/run"})
        EXPECT_TRUE(beginsWithPurposeAndLicence(read(root / file))) << file;
}

TEST(Architecture, LessonsAreFreeOfBranchesGLAndPaths) {
    std::vector<std::string> lessons;
    for (const std::string& file : filesBelow({"lessons"}, {".cpp"}))
        lessons.push_back(file);
    for (const char* known : {"lesson_00_scene", "interlude_brdf", "scene_viewer"})
        EXPECT_EQ(std::count(lessons.begin(), lessons.end(), "lessons/" + std::string(known) + ".cpp"), 1)
            << known;
    for (const std::string& file : lessons)
        for (const std::string& found : lessonComplaints(read(root / file)))
            ADD_FAILURE() << file << ": a lesson must not contain " << found;
}

// --- the rules' own tests: what is wrong must be noticed, and what is right must pass

TEST(ArchitectureRules, IncludesAreFoundHoweverTheyAreWritten) {
    const std::vector<Include> found =
        includesOf("#include \"a/b.hpp\"\n  # include <c>\n// #include \"no.hpp\"\n\t#include\"d.hpp\"\n");
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].file, "a/b.hpp");
    EXPECT_EQ(found[1].file, "c");
    EXPECT_EQ(found[1].quote, '<');
    EXPECT_EQ(found[2].file, "d.hpp");
}

TEST(ArchitectureRules, EachForbiddenDirectionIsNoticed) {
    const std::string layers[] = {"three", "lighting", "render", "lab"};  // lowest first
    const auto fileOf = [](const std::string& layer) { return "common/" + layer + "/a.cpp"; };
    for (std::size_t from = 0; from < 4; ++from)
        for (std::size_t to = 0; to < 4; ++to)
            EXPECT_EQ(complaint(fileOf(layers[from]), {layers[to] + "/b.hpp", '"'}).empty(), to <= from)
                << layers[from] << " -> " << layers[to];
    for (const std::string& layer : layers) {
        EXPECT_EQ(complaint(fileOf(layer), {"image/b.hpp", '"'}).empty(),
                  layer == "render" || layer == "lab");
        EXPECT_NE(complaint("common/image/a.cpp", {layer + "/b.hpp", '"'}), "");
        EXPECT_NE(complaint(fileOf(layer), {"lessons/b.hpp", '"'}), "");
        EXPECT_NE(complaint(fileOf(layer), {"tests/b.hpp", '"'}), "");
        EXPECT_NE(complaint(fileOf(layer), {layer + "/../../tests/b.hpp", '"'}), "");
        EXPECT_NE(complaint(fileOf(layer), {"b.hpp", '"'}), "");
        EXPECT_EQ(complaint("lessons/a.cpp", {layer + "/b.hpp", '"'}), "");
        EXPECT_EQ(complaint(fileOf(layer), {"GLES3/gl3.h", '<'}).empty(),
                  layer == "render" || layer == "lab");
    }
    EXPECT_NE(complaint("lessons/a.cpp", {"tests/b.hpp", '"'}), "");
    EXPECT_NE(complaint("common/three/a.cpp", {"lab/b.hpp", '<'}), "");
    EXPECT_NE(complaint("common/new/a.cpp", {"three/b.hpp", '"'}), "");
    EXPECT_NE(complaint("common/lighting/reference/a.hpp", {"lighting/frame_plan.hpp", '"'}), "");
    EXPECT_EQ(complaint("common/lighting/reference/a.hpp", {"lighting/terms.hpp", '"'}), "");
    EXPECT_EQ(complaint("common/three/a.cpp", {"vector", '<'}), "");
    EXPECT_EQ(complaint("common/three/a.cpp", {"glm/vec3.hpp", '<'}), "");
}

TEST(ArchitectureRules, EachForbiddenWordOfALessonIsNoticed) {
    for (const char* bad : {"if (a) b();", "else b();", "while(true);", "switch (x) {}", "a ? b : c", "do {",
                            "x = 1'000; if (a)", "glEnable(1);", "f(GL_BLEND);", "load(\"models/a.obj\");",
                            "load(\"/tmp\");", "auto s = R\"(text)\";", "s = \"\\\"\"; if (a)"})
        EXPECT_EQ(lessonComplaints(bad).size(), 1u) << bad;
}

TEST(ArchitectureRules, AGoodLessonPasses) {
    EXPECT_EQ(
        lessonComplaints("#include \"lab/lab.hpp\"\n// if this is so, why? see docs/x\n/* for glUse */\n"
                         "auto gloss = format(\"if? for\", 'x', 1'000);\nint notify, glue = iffy;\n"
                         "for (Light& luce : anello) scena.add(luce);\n"),
        std::vector<std::string>{});
}

TEST(ArchitectureRules, AMissingLicenceOrPurposeIsNoticed) {
    EXPECT_TRUE(beginsWithPurposeAndLicence("// What.\n// SPDX-License-Identifier: MIT\nint a;\n"));
    EXPECT_TRUE(beginsWithPurposeAndLicence("#!/bin/sh\n# What.\n# SPDX-License-Identifier: MIT\n"));
    EXPECT_FALSE(beginsWithPurposeAndLicence("// SPDX-License-Identifier: MIT\nint a;\n"));
    EXPECT_FALSE(beginsWithPurposeAndLicence("// What.\nint a;\n// SPDX-License-Identifier: MIT\n"));
    EXPECT_FALSE(beginsWithPurposeAndLicence("// What.\n// SPDX-License-Identifier: GPL\n"));
    EXPECT_FALSE(beginsWithPurposeAndLicence(""));
}

}  // namespace
