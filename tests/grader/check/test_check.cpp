// `check` as a student meets it: verdicts, pictures, and a second look with every save.
// SPDX-License-Identifier: MIT
#include "grader/check/feedback.hpp"
#include "grader/check/trio.hpp"
#include "support/program.hpp"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using support::readFile;

constexpr const char* lesson = "lesson_02_directional_light.cpp";
const fs::path root = LAMBERT_SOURCE_DIR;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// A starter of lesson 02 in the folder `mine`.
struct Check : testing::Test {
    support::TemporaryDirectory directory;
    Check() { support::run({"nuovo", "starter", "2", "--lang", "en", "-o", "mine"}, directory.path()); }

    support::Outcome once(const std::string& file, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"check", "2", file, "--once"});
        return support::run(more, directory.path());
    }
    std::string solution() const { return readFile(root / "lessons" / lesson); }
    // As editors do: a new file takes the old one's name.
    void save(const std::string& text) {
        support::writeFile(directory.file("mine/.new"), text);
        fs::rename(directory.file("mine/.new"), directory.file(std::string("mine/") + lesson));
    }
};

TEST_F(Check, SaysWhatAStarterLacks) {
    const support::Outcome outcome = once("mine", {"--lang", "en"});
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "36.3  a directional light")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "check: not right yet")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "codes from 0 to 255")) << "the legend of the difference";
    EXPECT_EQ(directory.contents(), std::vector<std::string>{"mine"}) << "no picture was asked for";
}

TEST_F(Check, IsContentWithTheSolution) {
    save(solution());
    const support::Outcome outcome = once("mine/.", {"--lang", "it"});
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "check: tutto giusto")) << outcome.out;
    fs::copy(root / "lessons" / lesson, directory.path());
    EXPECT_EQ(once(lesson).status, 0) << "the file alone";
}

TEST_F(Check, TellsErrorsWithFileAndLine) {
    save("#include \"lab/lab.hpp\"\nint main() { return nothing; }\n");
    const support::Outcome program = once("mine", {"--picture", "picture.png"});
    EXPECT_EQ(program.status, 1);
    EXPECT_TRUE(contains(program.out, std::string(lesson) + ":2:")) << program.out;
    EXPECT_TRUE(fs::exists(directory.file("picture.png"))) << "the expected one is there nevertheless";
    support::writeFile(directory.file("cosine.glsl"),
                       "float cosine(vec3 n, vec3 w)\n{\n    return nothing;\n}\n");
    const support::Outcome shader = once("cosine.glsl");
    EXPECT_EQ(shader.status, 1);
    EXPECT_TRUE(contains(shader.out, "terms/cosine.glsl:3:")) << shader.out;
}

TEST_F(Check, LooksAtAShaderAlone) {
    const support::Outcome neutral = once("mine/terms/cosine.glsl");
    EXPECT_EQ(neutral.status, 1) << neutral.err;
    EXPECT_TRUE(contains(neutral.out, "not yet     cosine")) << neutral.out;
    EXPECT_FALSE(contains(neutral.out, "36.3")) << "the lesson is not looked at";
    const support::Outcome right = once((root / "shaders/terms/cosine.glsl").string());
    EXPECT_EQ(right.status, 0) << right.out;
}

TEST_F(Check, WritesMineExpectedAndDifference) {
    ASSERT_EQ(once("mine", {"--picture", "picture.ppm"}).status, 1);
    save(solution());
    ASSERT_EQ(once("mine", {"--picture", "right.ppm"}).status, 0);
    const std::string wrong = readFile(directory.file("picture.ppm")),
                      right = readFile(directory.file("right.ppm"));
    const std::string header = "P6\n1184 400\n255\n";
    ASSERT_EQ(wrong.substr(0, header.size()), header);
    ASSERT_EQ(wrong.size(), right.size());
    const auto part = [&](const std::string& picture, int which) {
        std::string codes;
        for (std::size_t y = 8; y < 392; ++y)
            codes +=
                picture.substr(header.size() + 3 * (y * 1184 + 8 + 392 * static_cast<std::size_t>(which)),
                               3 * std::size_t{384});
        return codes;
    };
    EXPECT_EQ(part(wrong, 1), part(right, 1)) << "in the middle what is expected";
    EXPECT_NE(part(wrong, 0), part(wrong, 1)) << "at the left what the starter draws";
    const auto alike = [](const std::string& a,
                          const std::string& b) {  // drivers round and cut edges otherwise
        std::size_t same = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            same +=
                std::abs(static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i])) <= 1 ? 1U : 0U;
        return static_cast<double>(same) / static_cast<double>(a.size());
    };
    EXPECT_GT(alike(part(right, 0), part(right, 1)), 0.999);
    EXPECT_GT(alike(part(right, 2), std::string(part(right, 2).size(), '\0')), 0.999)
        << "black: no difference";
    EXPECT_LT(alike(part(wrong, 2), std::string(part(wrong, 2).size(), '\0')), 0.9);
}

TEST_F(Check, RefusesWhatItCannotLookAt) {
    EXPECT_EQ(once("nowhere").status, 2);
    EXPECT_EQ(support::run({"check", "99", "mine", "--once"}, directory.path()).status, 2);
    EXPECT_EQ(support::run({"check", "2"}, directory.path()).status, 2);
    EXPECT_EQ(once("mine", {"--presenter", "7"}).status, 2);
    fs::create_directory(directory.file("empty"));
    const support::Outcome empty = once("empty");
    EXPECT_EQ(empty.status, 1) << empty.out << empty.err;
    EXPECT_EQ(support::run({"check", "--help"}, directory.path()).status, 0);
}

// A check that watches.
class Watching {
  public:
    explicit Watching(const fs::path& folder) : said_(folder / "said.txt") {
        const std::string program = std::string(LAMBERT_BIN_DIR) + "/check";
        child_ = fork();
        if (child_ != 0)
            return;
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        const int out = open(said_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (chdir(folder.c_str()) != 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0)
            _exit(126);
        execl(program.c_str(), program.c_str(), "2", "mine", "--lang", "en", nullptr);
        _exit(127);
    }
    ~Watching() {
        if (child_ > 0)
            end();
    }
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;

    // Waits until it has been said so often.
    bool says(const std::string& text, int times) const {
        for (int i = 0; i < 600; ++i) {
            const std::string said = readFile(said_);
            int found = 0;
            for (auto at = said.find(text); at != std::string::npos; at = said.find(text, at + 1))
                ++found;
            if (found >= times)
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        return false;
    }
    int end() {
        kill(child_, SIGTERM);
        int status = 0;
        waitpid(child_, &status, 0);
        child_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

  private:
    fs::path said_;
    pid_t child_ = -1;
};

TEST_F(Check, LooksAgainWithEverySave) {
    Watching check(directory.path());
    ASSERT_TRUE(check.says("check: not right yet", 1)) << readFile(directory.file("said.txt"));
    ASSERT_TRUE(check.says("waiting for the next save", 1));
    const std::string before = readFile(directory.file("check.png"));
    EXPECT_FALSE(before.empty()) << "without a display the picture is written";
    save(solution());
    ASSERT_TRUE(check.says("check: all right", 1)) << readFile(directory.file("said.txt"));
    ASSERT_TRUE(check.says("waiting for the next save", 2));
    EXPECT_NE(readFile(directory.file("check.png")), before);
    fs::last_write_time(directory.file(std::string("mine/") + lesson), fs::file_time_type::clock::now());
    std::this_thread::sleep_for(std::chrono::seconds(1));
    EXPECT_EQ(check.end(), 0);
    const std::string said = readFile(directory.file("said.txt"));
    EXPECT_EQ(said.find("check: all right"), said.rfind("check: all right"))
        << "what is the same is not built again";
}

TEST(Feedback, BreaksLinesAtBlanks) {
    EXPECT_EQ(grader::wrapped("", 9), std::vector<std::string>{""});
    EXPECT_EQ(grader::wrapped("  one two three", 9), (std::vector<std::string>{"  one two", "    three"}));
    EXPECT_EQ(grader::wrapped("perch\u00e9 \u00e8 cos\u00ec", 9),
              (std::vector<std::string>{"perch\u00e9 \u00e8", "  cos\u00ec"}))
        << "letters are counted, not bytes";
    EXPECT_EQ(grader::wrapped("immeasurable", 4), std::vector<std::string>{"immeasurable"});
}

grader::Check checkOf(const char* id, grader::CheckStatus status, const std::string& message) {
    grader::Check check;
    check.id = id;
    check.title = std::string("the ") + id;
    check.status = status;
    check.message = message;
    return check;
}

TEST(Feedback, FitsIntoAWindow) {
    using grader::CheckStatus;
    grader::Graded graded;
    graded.report.status = grader::ReportStatus::graded;
    for (const char* id : {"one", "two", "three", "four", "five"})
        graded.report.checks.push_back(checkOf(id, CheckStatus::fail, std::string(id) + " is wrong"));
    const auto full = grader::linesOf(graded, 60, 100), brief = grader::linesOf(graded, 60, 4);
    EXPECT_GT(full.size(), brief.size());
    EXPECT_LE(brief.size(), 4U);
    EXPECT_EQ(brief[1][0].text, "\u2717 the one")
        << "the first one is told, with a mark, not by its colour alone";
    EXPECT_EQ(brief[1][0].tone, lab::Tone::wrong);
    for (grader::Check& check : graded.report.checks)
        check.message = "a frame is missing";
    graded.report.checks.insert(graded.report.checks.begin(),
                                checkOf("draws", CheckStatus::fail, "it does not"));
    const std::string text = grader::textOf(graded);
    EXPECT_EQ(text.find("a frame is missing"), text.rfind("a frame is missing")) << "one cause is told once\n"
                                                                                 << text;
    EXPECT_FALSE(grader::allRight(graded.report));
}

TEST(Trio, StaysWithinItsWindow) {
    for (const auto& [width, height] : {std::pair{1280, 720}, {300, 900}, {20, 20}, {1, 1}, {4000, 200}}) {
        const grader::Places places = grader::placesIn(width, height, 28, 300);
        EXPECT_GE(places.size, 1);
        grader::Trio trio;
        trio.pictures[1] = {2, 2, image::Bytes(12, 255)};
        const image::Frame frame = grader::drawn(&trio, width, height, places, true);
        EXPECT_EQ(std::get<image::Bytes>(frame.pixels).size(), static_cast<std::size_t>(width * height * 3));
    }
}

}  // namespace
