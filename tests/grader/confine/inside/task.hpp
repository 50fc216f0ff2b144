// What grade_inside was asked to do, and the parts that do it.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/wire.hpp"

#include <cstdint>
#include <string>
#include <sys/types.h>
#include <vector>

namespace grader::inside {

/// A wanted file: at most so many bytes, or exactly.
struct Wanted {
    std::string name;
    std::uint64_t bytes = 0;
    bool exactly = true;
};

/// Job, as it came over the pipe.
struct Task {
    bool namespaces = false;  ///< we are the first process of our own PID namespace
    bool landlock = false;
    std::int64_t user = -1;  ///< to become before the command runs; -1: stay who we are
    std::string box;
    double wallSeconds = 0;
    std::uint64_t cpuSeconds = 0;
    std::uint64_t memoryBytes = 0;
    std::uint64_t processes = 0;
    std::uint64_t fileBytes = 0;
    std::uint64_t folderBytes = 0;
    std::uint64_t files = 0;
    std::vector<std::string> command;
    std::vector<std::string> environment;  ///< NAME=value
    std::vector<std::string> readable;  ///< files and folders, for Landlock
    std::vector<Wanted> wanted;
};

/// Reads what Writer wrote (confine.cpp). Throws std::runtime_error.
Task readTask(std::string bytes);

/// In the child, before it becomes the command: another user, limits, Landlock, system calls. Throws std::runtime_error.
void putUpWalls(const Task& task, pid_t supervisor);
/// putUpWalls's last part: the system calls that nobody in here needs are refused from now on, to all descendants, too.
void refuseSystemCalls(const Task& task, pid_t supervisor);

/// What the command and its descendants use together.
struct Use {
    std::uint64_t memoryBytes = 0;
    std::uint64_t folderBytes = 0;
    std::uint64_t files = 0;
};
Use measure(const Task& task);

/// Kills all that is left but us, and waits until it is gone.
void endAll(const Task& task);

/// Writes all bytes; the program ends if nobody reads.
void send(int pipe, const void* bytes, std::size_t size);
/// Sends each wanted file of the folder `out`, which was opened before anything ran. All else must have ended.
void sendFiles(const Task& task, int out, int pipe);

}  // namespace grader::inside
