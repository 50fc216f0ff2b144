// A whole class through the program `grade`: every kind of submission, resumed, in shards, and killed in the middle.
// SPDX-License-Identifier: MIT
#include "grader/class/result.hpp"
#include "support/program.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

using grader::ReportStatus;
using support::readFile;
using support::writeFile;

constexpr const char* lesson = "lesson_05_attenuation";
constexpr const char* sourceName = "lesson_05_attenuation.cpp";

// Replaces the first; the text must be there.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

void writeZip(const fs::path& zip, const fs::path& folder) {
    archive* const out = archive_write_new();
    archive_write_set_format_zip(out);
    ASSERT_EQ(archive_write_open_filename(out, zip.c_str()), ARCHIVE_OK);
    for (const auto& file : fs::recursive_directory_iterator(folder)) {
        if (!file.is_regular_file())
            continue;
        const std::string text = readFile(file.path());
        archive_entry* const entry = archive_entry_new();
        archive_entry_set_pathname(
            entry, ("starter" / file.path().lexically_relative(folder)).c_str());  // a folder in the archive
        archive_entry_set_size(entry, static_cast<la_int64_t>(text.size()));
        archive_entry_set_filetype(entry, AE_IFREG);
        archive_entry_set_perm(entry, 0644);
        archive_write_header(out, entry);
        archive_write_data(out, text.data(), text.size());
        archive_entry_free(entry);
    }
    EXPECT_EQ(archive_write_close(out), ARCHIVE_OK);
    archive_write_free(out);
}

// `grade`, started and not waited for.
class Running {
  public:
    explicit Running(std::vector<std::string> words,
                     const std::vector<std::pair<std::string, std::string>>& environment = {}) {
        words[0] = std::string(LAMBERT_BIN_DIR) + "/" + words[0];
        std::vector<char*> list;
        for (std::string& word : words)
            list.push_back(word.data());
        list.push_back(nullptr);
        process_ = fork();
        if (process_ == 0) {
            const int null = open("/dev/null", O_RDWR);
            dup2(null, 0), dup2(null, 1), dup2(null, 2);
            for (const auto& [name, value] : environment)
                setenv(name.c_str(), value.c_str(), 1);
            execv(list[0], list.data());
            _exit(127);
        }
    }
    void send(int signal) const { kill(process_, signal); }
    /// Exit status, or 128 and the signal.
    int wait() const {
        int status = 0;
        waitpid(process_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

  private:
    pid_t process_ = 0;
};

template <class Condition>
bool happens(const Condition& condition, int seconds) {
    for (int i = 0; i < seconds * 50; ++i) {
        if (condition())
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

// Processes with this word on their command line: a pool and its workers.
int processesWith(const std::string& word) {
    int count = 0;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator("/proc", error)) {
        const std::string words = readFile(entry.path() / "cmdline");
        count += words.find(std::string(1, '\0') + word + std::string(1, '\0')) != std::string::npos;
    }
    return count;
}

const std::string unicodeName = "-Zo\xC3\xAB \xE2\x80\x9C\nBianchi\xFF.cpp";  // and a byte that is no UTF-8
const std::string longName = std::string(250, 'n');

struct Expected {
    std::string name;
    ReportStatus status;
    double score;
};

const std::vector<Expected> table = {
    {"solution", ReportStatus::graded, 100},  {"starter", ReportStatus::graded, 0},
    {"Rossi.zip", ReportStatus::graded, 100}, {"Rossi", ReportStatus::graded, 50},
    {"only.cpp", ReportStatus::graded, 100},  {"broken", ReportStatus::graded, 0},
    {"empty", ReportStatus::notGradable, 0},  {"loop", ReportStatus::graded, 0},
    {unicodeName, ReportStatus::graded, 100}, {"copy of Zo\xC3\xAB", ReportStatus::graded, 100},
    {longName, ReportStatus::notGradable, 0},
};

class Class : public testing::Test {
  protected:
    Class() : folder(directory.path() / "class"), out(directory.path() / "out") { makeClass(); }

    void makeClass() {
        const std::string solution = readFile(std::string(LAMBERT_SOURCE_DIR) + "/lessons/" + sourceName);
        const fs::path starter = folder / "starter";
        fs::create_directories(folder);
        ASSERT_EQ(support::run({"nuovo", "starter", lesson, "-o", starter.string(), "--lang", "en"},
                               directory.path())
                      .status,
                  0);
        for (const char* name : {"solution", "broken", "empty", "loop", "Rossi", "copy of Zo\xC3\xAB"})
            fs::create_directory(folder / name);
        fs::create_directory(folder / longName);
        writeFile(folder / "solution" / sourceName, solution);
        writeFile(folder / "Rossi" / sourceName, with(solution, "decay = 2", "decay = 1"));
        writeFile(folder / "broken" / sourceName, with(solution, "luce2.decay = 2;", "luce2.decay = ;"));
        writeFile(folder / "loop" / sourceName,
                  with("#include <unistd.h>\n" + solution, "// The scene,", "for (;;) sleep(1);\n//"));
        const std::string line = "    // TODO 31";
        const std::string started = readFile(starter / sourceName);
        const std::string solved =
            with(started, line, "    luce2.decay = 2; luce2.intensity = 25;\n    // done");
        writeFile(folder / "only.cpp", with(solved, "// done", "// I did it myself"));
        fs::copy(starter, directory.path() / "solved", fs::copy_options::recursive);
        writeFile(directory.path() / "solved" / sourceName, solved);
        writeZip(folder / "Rossi.zip", directory.path() / "solved");
        const std::string own =
            with(started, line,
                 "    const double quantoViveLaLampadina = 2;\n"
                 "    const double cinque = 5, venticinqueVolte = cinque * cinque;\n"
                 "    luce2.decay = quantoViveLaLampadina; luce2.intensity = venticinqueVolte;\n    // mine");
        writeFile(folder / unicodeName, own);
        writeFile(folder / "copy of Zo\xC3\xAB" / sourceName,
                  with(with(own, "// mine", "// all by myself"), "cinque = 5,", "cinque=5 ,\n\n"));
    }

    std::vector<std::string> words(const fs::path& to, const std::vector<std::string>& more) const {
        std::vector<std::string> all = {"grade",    lesson,      "--class", folder.string(),
                                        "--report", to.string(), "--lang",  "en"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    support::Outcome grade(const fs::path& to, const std::vector<std::string>& more) const {
        return support::run(words(to, more), directory.path());
    }
    std::size_t results(const fs::path& to) const {
        std::error_code error;
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(to / "results", error))
            count += !entry.path().filename().string().starts_with('.');
        return count;
    }

    // Each in turn, since each builds on what the one before has graded.
    void gradeAll();
    void checkPages() const;
    void resume();
    void shards() const;
    void killAndResume() const;

    support::TemporaryDirectory directory;
    fs::path folder, out;
    std::string marks;
};

void Class::gradeAll() {
    const support::Outcome outcome = grade(out, {"--jobs", "3"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");  // no progress where nobody looks
    EXPECT_EQ(results(out), table.size());
    for (const Expected& one : table) {
        const auto result = grader::readResult(out / "results" / one.name);
        ASSERT_TRUE(result) << one.name;
        EXPECT_EQ(result->report.status, one.status) << one.name << result->report.reason;
        EXPECT_EQ(result->report.score, one.score) << one.name;
        EXPECT_TRUE(grader::hasAllFiles(*result, out / "results" / one.name, "html")) << one.name;
    }
    checkPages();
}

void Class::checkPages() const {
    const std::string overview = readFile(out / "overview.html");
    EXPECT_NE(overview.find("./results/-Zo%C3%AB%20%E2%80%9C%0ABianchi%FF.cpp/report.html"),
              std::string::npos);
    const std::string how = "the same text but for comments and blanks";
    const std::size_t first = overview.find(how);
    ASSERT_NE(first, std::string::npos);
    const std::size_t second = overview.find(how, first + 1);  // each names the other, and nobody else
    ASSERT_NE(second, std::string::npos);
    EXPECT_EQ(overview.find(how, second + 1), std::string::npos);
    EXPECT_EQ(overview.find("the same file"), std::string::npos);
    for (const Expected& one : table) {
        const fs::path result = out / "results" / one.name;
        EXPECT_EQ(readFile(result / "report.html").find("same text"), std::string::npos);
        EXPECT_TRUE(grader::readResult(result)->report.similar.empty());
    }
}

void Class::resume() {
    const fs::path all = out / "results";
    for (const Expected& one : table)
        writeFile(all / one.name / "marker", "");
    // One was handed in again, one result was cut short, one lost its page, one submission is gone.
    writeFile(folder / "Rossi" / sourceName, readFile(folder / "solution" / sourceName));
    writeFile(all / "only.cpp" / "report.json", readFile(all / "only.cpp" / "report.json").substr(0, 700));
    fs::remove(all / "starter" / "report.html");
    fs::remove_all(folder / "loop");
    // Left over by processes of another machine: one that died hours ago, one that may be at work.
    const fs::path dead = all / ".00000000abcd.77.new", alive = all / ".00000000abcd.78.new";
    fs::create_directory(dead);
    fs::create_directory(alive);
    fs::last_write_time(dead, fs::file_time_type::clock::now() - std::chrono::hours(2));
    const support::Outcome outcome = grade(out, {"--jobs", "2", "--resume"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("not there any more, left out: loop"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(dead));
    EXPECT_TRUE(fs::exists(alive));
    for (const Expected& one : table) {
        const bool again = one.name == "Rossi" || one.name == "only.cpp" || one.name == "starter";
        EXPECT_EQ(fs::exists(all / one.name / "marker"), !again) << one.name;
    }
    marks = readFile(out / "marks.csv");
    EXPECT_NE(marks.find("\r\nRossi,lesson_05_attenuation,graded,100,100,"), std::string::npos) << marks;
    EXPECT_NE(marks.find("\r\nempty,lesson_05_attenuation,not_gradable,,100,"), std::string::npos) << marks;
    EXPECT_EQ(marks.find("\r\nloop,"), std::string::npos);
}

// All three at once, in one folder.
void Class::shards() const {
    const fs::path to = directory.path() / "sharded";
    std::vector<Running> running;
    for (const char* id : {"10", "12", "14"})
        running.emplace_back(
            words(to, {}), std::vector<std::pair<std::string, std::string>>{{"SLURM_ARRAY_TASK_ID", id},
                                                                            {"SLURM_ARRAY_TASK_MIN", "10"},
                                                                            {"SLURM_ARRAY_TASK_STEP", "2"},
                                                                            {"SLURM_ARRAY_TASK_COUNT", "3"}});
    for (const Running& one : running)
        EXPECT_EQ(one.wait(), 0);
    EXPECT_FALSE(fs::exists(to / "marks.csv"));
    const support::Outcome merged =
        support::run({"grade", "--merge", "--report", to.string(), "--lang", "en"}, directory.path());
    EXPECT_EQ(merged.status, 0) << merged.err;
    EXPECT_EQ(readFile(to / "marks.csv"), marks);
    // A result that is lost is told, and nobody is missing from the sheet.
    fs::remove_all(to / "results" / "solution");
    const support::Outcome lost = support::run(
        {"grade", "--merge", "--class", folder.string(), "--report", to.string(), "--lang", "en"},
        directory.path());
    EXPECT_EQ(lost.status, 75);
    EXPECT_NE(lost.err.find("without a whole result (grade again with --resume): solution"),
              std::string::npos);
    EXPECT_NE(readFile(to / "marks.csv").find("\r\nsolution,,infrastructure,,"), std::string::npos);
}

void Class::killAndResume() const {
    const fs::path to = directory.path() / "killed";
    for (const int signal : {SIGTERM, SIGKILL}) {
        const std::size_t before = results(to);
        const Running run(words(to, {"--jobs", "2", "--resume"}));
        EXPECT_TRUE(happens([&] { return results(to) > before; }, 60));
        run.send(signal);
        EXPECT_EQ(run.wait(), 128 + signal);
        EXPECT_TRUE(happens([&] { return processesWith(to.string()) == 0; }, 5));
        EXPECT_LT(results(to), table.size() - 1) << "it was over before it was killed";
    }
    EXPECT_FALSE(fs::exists(to / "marks.csv"));
    const support::Outcome outcome = grade(to, {"--jobs", "2", "--resume"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(readFile(to / "marks.csv"), marks);
    for (const auto& entry : fs::directory_iterator(to / "results"))
        EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST_F(Class, IsGradedResumedShardedAndMergedToTheSameMarks) {
    gradeAll();
    resume();
    shards();
    killAndResume();
}

TEST_F(Class, TroubleWithOneSubmissionIsNamedAndTheOthersGoOn) {
    for (const char* name : {"Rossi", "Rossi.zip", "broken", "loop", "copy of Zo\xC3\xAB", "only.cpp"})
        fs::remove_all(folder / name);
    fs::create_symlink("nowhere", folder / "lost");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const support::Outcome outcome = grade(out, {"--jobs", "2", "--format", "junit"});
    EXPECT_EQ(outcome.status, 75);
    EXPECT_NE(outcome.err.find("grade: lost: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("grade: pipe: "), std::string::npos) << outcome.err;
    const std::string sheet = readFile(out / "marks.csv");
    EXPECT_NE(sheet.find("\r\nlost,lesson_05_attenuation,infrastructure,,100"), std::string::npos) << sheet;
    EXPECT_NE(sheet.find("\r\nsolution,lesson_05_attenuation,graded,100,100"), std::string::npos) << sheet;
    EXPECT_TRUE(fs::exists(out / "results/solution/junit.xml"));
    EXPECT_NE(readFile(out / "overview.html").find("./results/solution/report.json"), std::string::npos);
}

TEST_F(Class, WhatCannotBeMeantIsRefused) {
    const auto refused = [&](const std::vector<std::string>& arguments, const std::string& words) {
        const support::Outcome outcome = support::run(arguments, directory.path());
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    };
    for (const char* shard : {"0/3", "4/3", "1", "a/b", "1/", "-1/3", "1/99999999"})
        refused(words(out, {"--shard", shard}), "expected I/N");
    refused(words(out, {"--format", "html,pdf"}), "found 'pdf'");
    refused(words(folder / "out", {}), "lies among the submissions");
    refused({"grade", "--merge", "--report", out.string()}, "results");
    fs::create_directory(directory.path() / "nobody");
    refused({"grade", lesson, "--class", "nobody", "--report", out.string()}, "is empty");
    refused({"grade", lesson, "--class", "nowhere", "--report", out.string()}, "No such file");
    EXPECT_FALSE(fs::exists(out));
}

}  // namespace
