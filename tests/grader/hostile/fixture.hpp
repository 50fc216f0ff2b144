// What the tests of hostile submissions share: a machine with a secret, and what must be as before when they are over.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/builder.hpp"
#include "grader/confine/testable_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace grader {

/// In the names of tests.
inline void PrintTo(Walls walls, std::ostream* out) { *out << name(walls); }

}  // namespace grader

namespace hostile {

namespace fs = std::filesystem;

inline const std::string secret = "SECRET-of-the-grader";

/// One submission and what becomes of it; every text is a regular expression.
struct Case {
    const char* name;
    const char* ends;  ///< of all of endingOf()
    const char* problem;  ///< of all of the frame's problem; "" is a frame without one
    const char* says = "";  ///< somewhere in what it said, or in the compiler's log
};

/// In the names of tests.
inline void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

/// A slot for each, apart from those that graders begin with, so that what runs beside it is not taken for the test's own.
inline int slotOf(const std::string& name, grader::Walls walls) {
    return static_cast<int>(std::hash<std::string>()(name + grader::name(walls)) % 399) + 100;
}

/// "exited 0", "killed 9: more than 256 MB of memory", "out of time: more than 1 s on the clock", "not started: why"
inline std::string endingOf(const grader::Outcome& outcome) {
    const std::string limit = outcome.limit.empty() ? "" : ": " + outcome.limit;
    switch (outcome.how) {
    case grader::Ended::exited:
        return "exited " + std::to_string(outcome.status) + limit;
    case grader::Ended::killed:
        return "killed " + std::to_string(outcome.status) + limit;
    case grader::Ended::outOfTime:
        return "out of time" + limit;
    case grader::Ended::notStarted:
        break;
    }
    return "not started: " + outcome.trouble;
}

inline std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline std::string listing(const fs::path& folder) {
    std::ostringstream text;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        text << entry.path().string() << ' ' << fs::last_write_time(entry.path()).time_since_epoch().count()
             << '\n';
    }
    return text.str();
}

inline void expectMatch(const std::string& text, const char* pattern, const char* what) {
    EXPECT_TRUE(std::regex_match(text, std::regex(pattern)))
        << what << ": " << text << "\nexpected: " << pattern;
}

inline grader::Limits tight() {
    grader::Limits limits;
    limits.wallSeconds = 1;
    limits.cpuSeconds = 5;
    limits.memoryBytes = std::uint64_t{256} << 20;
    limits.fileBytes = std::uint64_t{4} << 20;
    limits.folderBytes = std::uint64_t{16} << 20;
    limits.files = 500;
    limits.saidBytes = 16'384;
    return limits;
}

/// Its folder stands for the machine; TMPDIR is in it.
class Machine {
  public:
    Machine() {
        std::string pattern = (fs::temp_directory_path() / "test-hostile-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) {
            throw std::runtime_error("no folder for the test");
        }
        root_ = pattern;
        ::chmod(root_.c_str(), 0755);
        fs::create_directories(root_ / "tmp");
        ::chmod((root_ / "tmp").c_str(), 0777);
        std::ofstream(root_ / "secret.txt") << secret << '\n';
        ::setenv("TMPDIR", (root_ / "tmp").c_str(), 1);
        ::setenv("LAMBERT_SECRET", secret.c_str(), 1);
        before_ = listing(root_);
    }
    ~Machine() {
        std::error_code ignored;
        fs::remove_all(root_, ignored);
        ::unsetenv("TMPDIR");
    }
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    std::string secretFile() const { return (root_ / "secret.txt").string(); }

    /// No file more or less, no process of the slot's user.
    void expectUntouched(int slot) const {
        EXPECT_TRUE(fs::is_empty(root_ / "tmp"));
        EXPECT_EQ(contents(secretFile()), secret + "\n");
        std::string now = listing(root_);
        const auto withoutTmp = [](std::string text) {
            return std::regex_replace(text, std::regex("[^\n]*/tmp [^\n]*\n"), "");
        };
        EXPECT_EQ(withoutTmp(now), withoutTmp(before_));
        for (const auto& entry : fs::directory_iterator("/proc")) {
            struct stat status {};
            const bool process =
                std::isdigit(static_cast<unsigned char>(entry.path().filename().string()[0])) != 0;
            if (!process || ::stat(entry.path().c_str(), &status) != 0) {
                continue;
            }
            if (::geteuid() == 0) {
                EXPECT_NE(status.st_uid, static_cast<uid_t>(64000 + slot))
                    << contents(entry.path() / "cmdline");
            }
            EXPECT_NE(contents(entry.path() / "comm"), "hostile-daemon\n");
        }
    }

  private:
    fs::path root_;
    std::string before_;
};

inline fs::path folder() { return fs::path(LAMBERT_SOURCE_DIR) / "tests/grader/hostile"; }

/// Every file of a folder is in one of the tables, and says first what it does.
template <typename... Tables>
void expectAllInTables(const fs::path& files, const Tables&... tables) {
    for (const auto& entry : fs::directory_iterator(folder() / files)) {
        const std::string name = entry.path().stem().string();
        const auto isIn = [&](const auto& table) {
            return std::any_of(std::begin(table), std::end(table),
                               [&](const Case& one) { return one.name == name; });
        };
        EXPECT_TRUE((isIn(tables) || ...)) << name;
        EXPECT_EQ(contents(entry.path()).substr(0, 3), "// ") << name;
    }
}

inline grader::Source sourceOf(const std::string& path, const Machine& machine) {
    const fs::path sources = LAMBERT_SOURCE_DIR;
    const auto define = [](const char* name, const fs::path& file) {
        return std::string("#define ") + name + " \"" + file.string() + "\"\n";
    };
    grader::Source source;
    source.name = fs::path(path).filename().string();
    source.text = contents(folder() / path);
    source.headers = {
        {"hostile.hpp", define("SECRET_FILE", machine.secretFile()) +
                            define("LESSON_FILE", sources / "lessons/lesson_05_attenuation.cpp") +
                            define("SHADER_FILE", sources / "shaders/terms/clamp.glsl") +
                            contents(folder() / "hostile.hpp")}};
    return source;
}

/// Readable, for the name of a test.
struct CaseName {
    template <typename T>
    std::string operator()(const testing::TestParamInfo<T>& info) const {
        return std::string(std::get<1>(info.param).name) + "_" + grader::name(std::get<0>(info.param));
    }
};

}  // namespace hostile
