// What is taken from a submission, and what is left out.
// SPDX-License-Identifier: MIT
#include "grader/submission/submission.hpp"

#include "grader/submission/files.hpp"
#include "support/program.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <cstdlib>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace {

namespace fs = std::filesystem;
using grader::Language;
using grader::Submission;
using support::writeFile;

const std::string lesson = "#include \"lab/lab.hpp\"\nint main() {}\n";

grader::Expectations expectations() {
    grader::Expectations expected;
    expected.lesson = "lesson_05_attenuation";
    expected.shaders = {"lighting.glsl", "mesh.vert", "terms/clamp.glsl", "terms/cosine.glsl"};
    expected.starters = {{{"terms/clamp.glsl", "// TODO\nfloat clamp_cosine(float x) { return x; }\n"}}};
    return expected;
}

Submission read(const fs::path& path) { return grader::readSubmission(path, expectations(), Language::en); }

std::string noteOf(const Submission& submission, const std::string& path) {
    for (const grader::SubmittedFile& file : submission.files)
        if (file.path == path)
            return file.role + ": " + file.note;
    return "not listed";
}

// A zip's bytes; a name may be anything.
std::string zipped(const std::vector<std::pair<std::string, std::string>>& files) {
    std::string bytes(1 << 20, '\0');
    std::size_t used = 0;
    archive* out = archive_write_new();
    archive_write_set_format_zip(out);
    archive_write_open_memory(out, bytes.data(), bytes.size(), &used);
    for (const auto& [name, text] : files) {
        archive_entry* entry = archive_entry_new();
        archive_entry_set_pathname(entry, name.c_str());
        archive_entry_set_size(entry, static_cast<la_int64_t>(text.size()));
        archive_entry_set_filetype(entry, AE_IFREG);
        archive_write_header(out, entry);
        archive_write_data(out, text.data(), text.size());
        archive_entry_free(entry);
    }
    archive_write_free(out);
    bytes.resize(used);
    return bytes;
}

class Folder : public testing::Test {
  protected:
    support::TemporaryDirectory directory;
    fs::path at(const std::string& name) const {
        fs::create_directories((directory.path() / name).parent_path());
        return directory.path() / name;
    }
};

TEST_F(Folder, GivesLessonHeadersAndShaders) {
    writeFile(at("mine/lesson_05_attenuation.cpp"), lesson);
    writeFile(at("mine/help.hpp"), "int f();\n");
    writeFile(at("mine/terms/clamp.glsl"), "float clamp_cosine(float x) { return max(0.0, x); }\n");
    writeFile(at("mine/README.md"), "words\n");
    const Submission submission = read(directory.path() / "mine/");
    EXPECT_EQ(submission.name, "mine");
    EXPECT_EQ(submission.problem, "");
    ASSERT_TRUE(submission.lesson.has_value());
    EXPECT_EQ(submission.lesson->text, lesson);
    EXPECT_EQ(submission.headers.size(), 1U);
    EXPECT_TRUE(submission.has("terms/clamp.glsl"));
    EXPECT_TRUE(noteOf(submission, "README.md").starts_with("leftOut"));
}

TEST_F(Folder, TermsThatNobodyWroteAreLeftOutBesideALesson) {
    const std::string neutral = "float  clamp_cosine( float x ) { return x; } // mine\n";
    writeFile(at("mine/lesson_05_attenuation.cpp"), lesson);
    writeFile(at("mine/terms/clamp.glsl"), neutral);
    EXPECT_FALSE(read(directory.path() / "mine").has("terms/clamp.glsl"));
    writeFile(at("alone/terms/clamp.glsl"), neutral);
    const Submission alone = read(directory.path() / "alone");
    EXPECT_TRUE(alone.has("terms/clamp.glsl"));
    EXPECT_EQ(alone.untouched, std::set<std::string>{"clamp"});
    writeFile(at("mine/terms/cosine.glsl"), "float cosine(vec3 n, vec3 w) { return dot(n, w); }\n");
    EXPECT_TRUE(read(directory.path() / "mine").has("terms/clamp.glsl"))
        << "one term was written, so all are judged";
}

TEST_F(Folder, OfSeveralProgramsTheOneWithTheLessonsNameCounts) {
    writeFile(at("mine/old.cpp"), lesson);
    writeFile(at("mine/sub/lesson_05_attenuation.cpp"), lesson + "// this\n");
    EXPECT_EQ(read(directory.path() / "mine").lesson->text, lesson + "// this\n");
    writeFile(at("two/a.cpp"), lesson);
    writeFile(at("two/b.cpp"), lesson);
    EXPECT_NE(read(directory.path() / "two").problem.find("several"), std::string::npos);
    writeFile(at("other/a.cpp"), lesson);
    writeFile(at("other/b.cpp"), "int unrelated;\n");
    EXPECT_EQ(read(directory.path() / "other").lesson->name, "a.cpp");
}

TEST_F(Folder, NothingToJudgeIsAProblemInBothLanguages) {
    fs::create_directories(directory.path() / "empty");
    EXPECT_NE(read(directory.path() / "empty").problem.find("no file to judge"), std::string::npos);
    EXPECT_NE(grader::readSubmission(directory.path() / "empty", expectations(), Language::it)
                  .problem.find("nessun file"),
              std::string::npos);
    EXPECT_THROW(read(directory.path() / "missing"), std::runtime_error);
}

TEST_F(Folder, LinksPipesAndLargeFilesAreLeftOut) {
    writeFile(at("mine/lesson_05_attenuation.cpp"), lesson);
    fs::create_symlink("/etc/passwd", at("mine/a.hpp"));
    fs::create_directory_symlink("/", at("mine/root"));
    ASSERT_EQ(mkfifo(at("mine/b.hpp").c_str(), 0600), 0);
    writeFile(at("mine/c.hpp"), std::string(grader::largestFile + 1, ' '));
    const Submission submission = read(directory.path() / "mine");
    EXPECT_TRUE(submission.headers.empty());
    EXPECT_NE(noteOf(submission, "a.hpp").find("no plain file"), std::string::npos);
    EXPECT_NE(noteOf(submission, "b.hpp").find("no plain file"), std::string::npos);
    EXPECT_NE(noteOf(submission, "c.hpp").find("too large"), std::string::npos);
}

TEST_F(Folder, TooManyFilesEnd) {
    for (int i = 0; i < 300; ++i)
        writeFile(at("mine/" + std::to_string(i) + ".hpp"), "\n");
    const Submission submission = read(directory.path() / "mine");
    EXPECT_EQ(submission.headers.size(), grader::mostFiles);
}

TEST_F(Folder, ArchivesAreReadAsFoldersAre) {
    const std::string bytes =
        zipped({{"a/lesson_05_attenuation.cpp", lesson}, {"__MACOSX/a/._lesson_05_attenuation.cpp", "x"}});
    writeFile(at("Rossi.zip"), bytes);
    const Submission submission = read(directory.path() / "Rossi.zip");
    EXPECT_EQ(submission.name, "Rossi.zip");
    ASSERT_TRUE(submission.lesson.has_value());
    EXPECT_EQ(submission.lesson->text, lesson);
    writeFile(at("Rossi_123_file/handed in.zip"), bytes);  // as Moodle gives them
    EXPECT_TRUE(read(directory.path() / "Rossi_123_file").lesson.has_value());
    writeFile(at("twice.zip"), zipped({{"inner.zip", bytes}}));
    EXPECT_TRUE(read(directory.path() / "twice.zip").lesson.has_value());
}

TEST_F(Folder, BadArchivesAreNoCrash) {
    writeFile(at("words.zip"), "this is no zip");
    EXPECT_NE(read(directory.path() / "words.zip").problem, "");
    const std::string bytes = zipped({{"lesson_05_attenuation.cpp", lesson}});
    for (std::size_t size = 0; size < bytes.size(); size += 7) {
        writeFile(at("cut.zip"), bytes.substr(0, size));
        EXPECT_FALSE(read(directory.path() / "cut.zip").name.empty());
    }
    writeFile(at("bomb.zip"), zipped({{"a.hpp", std::string(900'000, ' ')}, {"../../escape.cpp", lesson}}));
    EXPECT_EQ(read(directory.path() / "bomb.zip").lesson->name, "../../escape.cpp")
        << "a name is data, nothing is written there";
}

TEST_F(Folder, TheHashIsOfTheFilesOnly) {
    writeFile(at("a/lesson_05_attenuation.cpp"), lesson);
    writeFile(at("b/lesson_05_attenuation.cpp"), lesson);
    EXPECT_EQ(read(directory.path() / "a").hash, read(directory.path() / "b").hash);
    writeFile(at("b/lesson_05_attenuation.cpp"), lesson + " ");
    EXPECT_NE(read(directory.path() / "a").hash, read(directory.path() / "b").hash);
}

TEST(WithoutComments, LeavesWhatACompilerSees) {
    EXPECT_EQ(grader::withoutComments("int  a ; // b\n/* c\n */ int d;"), "int a;int d;");
    EXPECT_EQ(grader::withoutComments("f(\"// no comment\", '\"');"), "f(\"// no comment\",'\"');");
    EXPECT_EQ(grader::withoutComments("#if X  // y\nint a;\n#endif\nint b;"),
              "#if X\nint a;\n#endif\nint b;");
    EXPECT_EQ(grader::withoutComments("a - -b"), "a--b");  // good enough to compare two texts
    EXPECT_EQ(grader::withoutComments("\"open\n/*"), "\"open");
    EXPECT_EQ(grader::withoutComments(""), "");
}

}  // namespace
