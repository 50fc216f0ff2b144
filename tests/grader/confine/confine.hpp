// Runs what nobody trusts: a command that sees only what it is given, within limits, and of which only some files come back.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/text.hpp"  // harmless(): what Outcome::said went through

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace grader {

/// What a command may use. All of them hold inside the confinement; the wall clock also from outside.
struct Limits {
    double wallSeconds = 20;
    double cpuSeconds = 20;  ///< of each process
    std::uint64_t memoryBytes = std::uint64_t{3}
                                << 30;  ///< address space of each process; memory of all together
    int processes = 64;  ///< and threads. Not below: llvmpipe waits for ever where it gets no threads
    std::uint64_t fileBytes = std::uint64_t{64} << 20;  ///< of each file that it writes
    std::uint64_t folderBytes = std::uint64_t{128}
                                << 20;  ///< of all that it writes together (/box is in memory)
    std::uint64_t files = 10'000;  ///< and folders, that it makes
    std::uint64_t saidBytes = 64 << 10;  ///< of stdout and stderr; the rest is passed over
};

/// A file or folder of the machine that can be read inside.
struct Mount {
    std::filesystem::path from;
    std::string to;  ///< absolute
};

/// A file that the command is to leave at /box/out/<name>.
struct Wanted {
    std::string name;
    std::uint64_t bytes;  ///< exactly, or at most
    bool exactly = true;
};

/// What to run. The current folder is /box, and /box/out is there. Where there are no namespaces, "inside" is a folder of its
/// own: the texts are files in it, the mounts links. So that a job works in both, its words name files from /box on
/// ("in/list.txt", "../lab/bin/program"), or as "{root}/lab/bin/program": {root} becomes nothing, or that folder.
/// What must find its own place (image/home.hpp) is given as a text: a link would lead it to where it comes from.
struct Job {
    std::vector<std::string> command;  ///< {root} is replaced; command[0] is a path, or found in /usr/bin
    std::vector<Mount> mounts;
    std::vector<std::pair<std::string, std::string>>
        texts;  ///< files of any bytes, by their absolute names inside, not in a mount; executable, read-only outside /box
    std::vector<std::pair<std::string, std::string>>
        environment;  ///< {root} is replaced; added to PATH, HOME=/box, LANG=C.UTF-8 and what Mesa needs
    std::vector<Wanted> wanted;
    Limits limits;
};

/// How it ended.
enum class Ended {
    exited,  ///< by itself, with `status`
    killed,  ///< by signal `status`: its own, or ours at a limit (SIGKILL: memory; SIGXFSZ: what it writes)
    outOfTime,  ///< by us, at the end of its time (wall or processor)
    notStarted  ///< the confinement's own trouble, in `trouble`: infrastructure, never the submission's fault
};

/// One wanted file.
struct Returned {
    std::string bytes;
    std::string
        problem;  ///< empty, or why there are no bytes: "was not written", "is a symbolic link", "is 12 bytes long, expected 110592"
};

struct Outcome {
    Ended how = Ended::notStarted;
    int status = 0;
    std::string trouble;  ///< of notStarted only
    std::string limit;  ///< which limit ended it, in words: "more than 2 s on the clock"; else empty
    std::string
        said;  ///< stdout and stderr as they came, made harmless: valid UTF-8, no control characters but line feed
    bool saidMore = false;  ///< more than saidBytes
    std::vector<Returned> files;  ///< in the order of Job::wanted
    double seconds = 0;  ///< on the wall, start and end of the confinement included
};

/// How commands are confined on this machine.
enum class Walls {
    bubblewrap,  ///< namespaces of its own: no network, no other process, no file but the mounts
    landlock,  ///< no namespaces to be had: another user where we are root, Landlock, seccomp, limits
    limits  ///< the kernel has no Landlock either: limits only
};

class Confinement {
  public:
    /// Tries what works here, strongest first. Throws std::runtime_error with what was tried if nothing does.
    Confinement();
    /// As asked, for tests. Throws if it does not work here.
    explicit Confinement(Walls walls);

    Walls walls() const { return walls_; }
    /// In words, for the report: what holds, and if it is not the strongest, why not and what is missing.
    const std::string& description() const { return description_; }
    /// Runs the job to its end. Everything that it started is gone when this returns. Thread-safe. Where we
    /// are root it runs as a user that no other job of this machine has at the time; `slot` says where looking for one begins.
    Outcome run(const Job& job, int slot = 0) const;

  private:
    Walls walls_;
    std::string description_;
};

/// Which: "bubblewrap", "landlock", "limits".
const char* name(Walls walls);

}  // namespace grader
