// Chooses the walls, checks jobs and runs them.
// SPDX-License-Identifier: MIT
#include "grader/confine/confine.hpp"

#include "grader/confine/start.hpp"
#include "image/home.hpp"

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <unistd.h>

namespace grader {

namespace {

const char* const descriptions[] = {
    "namespaces of its own (bubblewrap): no network, no other process, no file but what it is given; system "
    "calls filtered (seccomp); time, memory, processes and files limited",
    "no namespaces: files guarded by Landlock; network and signals to others refused by a filter of system "
    "calls (seccomp); time, memory, processes and files limited; what it writes lies on the disk until its "
    "end",
    "limits only: time, memory, processes and files; network and signals to others refused by a filter of "
    "system calls (seccomp). It can read every file of this machine that its user can"};

std::string whoRuns() {
    return ::geteuid() == 0 ? "; runs as a user of no name" : "; runs as the grader's own user";
}

void replaceRoot(std::string& word, const std::string& root) {
    const std::string mark = "{root}";
    for (std::size_t at = 0; (at = word.find(mark, at)) != std::string::npos; at += root.size()) {
        word.replace(at, mark.size(), root);
    }
}

// Jobs are made by the grader: a broken one is a mistake of its own, and said so.
void check(const Job& job) {
    const auto refuse = [](const std::string& what) {
        throw std::runtime_error("the job is broken: " + what);
    };
    const auto checkPath = [&](const std::string& path) {
        if (path.size() < 2 || path[0] != '/' || path.find("/..") != std::string::npos ||
            path.find('\0') != std::string::npos) {
            refuse("'" + path + "' is no absolute path");
        }
    };
    if (job.command.empty()) {
        refuse("it has no command");
    }
    for (const Mount& mount : job.mounts) {
        checkPath(mount.to);
        std::error_code error;
        if (!std::filesystem::exists(mount.from, error)) {
            refuse("it needs " + mount.from.string() + ", which is not there, or not for this user");
        }
    }
    for (const auto& text : job.texts) {
        checkPath(text.first);
    }
    for (const Wanted& wanted : job.wanted) {
        if (wanted.name.empty() || wanted.name[0] == '.' || wanted.name.find('/') != std::string::npos ||
            wanted.name.find('\0') != std::string::npos) {
            refuse("'" + wanted.name + "' is no name of a wanted file");
        }
    }
}

}  // namespace

const char* name(Walls walls) {
    return walls == Walls::bubblewrap ? "bubblewrap" : walls == Walls::landlock ? "landlock" : "limits";
}

const std::vector<std::string>& systemFolders() {
    static const std::vector<std::string> folders = {
        "/usr/bin",     "/usr/lib",     "/usr/lib32",       "/usr/lib64",         "/usr/libx32",
        "/usr/include", "/usr/libexec", "/usr/share/glvnd", "/usr/share/drirc.d", "/bin",
        "/lib",         "/lib64",       "/etc/ld.so.cache", "/etc/alternatives"};
    return folders;
}

const std::string& gradeInside() {
    static const std::string bytes = [] {
        const auto path = image::home() / "lib/lambert-lab/grade_inside";
        std::ifstream file(path, std::ios::binary);
        std::string all{std::istreambuf_iterator<char>(file), {}};
        if (all.empty()) {
            throw std::runtime_error("cannot read " + path.string() + "; build or install it there");
        }
        return all;
    }();
    return bytes;
}

std::vector<std::string> rooted(const std::vector<std::string>& words, const std::string& root) {
    std::vector<std::string> replaced = words;
    for (std::string& word : replaced) {
        replaceRoot(word, root);
    }
    return replaced;
}

std::string taskOf(const Job& job, Walls walls, const std::string& root, std::optional<uid_t> user,
                   const std::vector<std::string>& readable) {
    wire::Writer out;
    out.number(walls == Walls::bubblewrap ? 1 : 0);
    out.number(walls == Walls::landlock ? 1 : 0);
    out.number(user.has_value() ? std::uint64_t{*user} + 1 : 0);
    out.text(root + "/box");
    out.number(static_cast<std::uint64_t>(job.limits.wallSeconds * 1000));
    out.number(static_cast<std::uint64_t>(std::ceil(job.limits.cpuSeconds)));
    out.number(job.limits.memoryBytes);
    out.number(static_cast<std::uint64_t>(job.limits.processes));
    out.number(job.limits.fileBytes);
    out.number(job.limits.folderBytes);
    out.number(job.limits.files);
    out.list(rooted(job.command, root));
    std::vector<std::string> environment = {
        "PATH=/usr/bin:/bin", "HOME=" + root + "/box",      "TMPDIR=" + root + "/box",       "LANG=C.UTF-8",
        "LP_NUM_THREADS=1",   "LIBGL_ALWAYS_SOFTWARE=true", "MESA_SHADER_CACHE_DISABLE=true"};
    for (const auto& [key, value] : job.environment) {
        environment.push_back(key + "=" + value);
        replaceRoot(environment.back(), root);
    }
    out.list(environment);
    out.list(readable);
    out.number(job.wanted.size());
    for (const Wanted& wanted : job.wanted) {
        out.text(wanted.name);
        out.number(wanted.bytes);
        out.number(wanted.exactly ? 1 : 0);
    }
    return out.bytes();
}

Confinement::Confinement() : walls_(Walls::bubblewrap) {
    std::string tried;
    for (const Walls walls : {Walls::bubblewrap, Walls::landlock, Walls::limits}) {
        try {
            *this = Confinement(walls);
            description_ += tried.empty() ? "" : ". Stronger walls do not work here: " + tried;
            return;
        } catch (const std::runtime_error& error) {
            tried += (tried.empty() ? "" : "; ") + std::string(error.what());
        }
    }
    throw std::runtime_error("no way to confine a submission works here: " + tried +
                             "; install bubblewrap, and allow user namespaces to it");
}

Confinement::Confinement(Walls walls)
    : walls_(walls), description_(descriptions[static_cast<int>(walls)] + whoRuns()) {
    Job job;
    job.command = {"true"};
    const Outcome outcome = run(job, 499);
    if (outcome.how != Ended::exited || outcome.status != 0) {
        throw std::runtime_error(std::string(name(walls)) + ": " +
                                 (outcome.trouble.empty() ? "`true` fails in it" : outcome.trouble));
    }
}

Outcome Confinement::run(const Job& job, int slot) const {
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome;
    try {
        check(job);
        const Gathered gathered =
            walls_ == Walls::bubblewrap ? runInBubblewrap(job, slot) : runInFolder(job, walls_, slot);
        readResult(gathered, job, outcome);
    } catch (const std::exception& error) {
        outcome = Outcome();
        outcome.trouble = harmless(error.what());
        outcome.files.assign(job.wanted.size(), {"", "was not written"});
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return outcome;
}

}  // namespace grader
