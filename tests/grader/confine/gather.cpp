// Starts grade_inside and reads its two pipes: never more than a cap, never longer than a time.
// SPDX-License-Identifier: MIT
#include "grader/confine/pointers.hpp"
#include "grader/confine/start.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double graceSeconds = 10;  // for the start, the end of what is left, and the files

// Between fork and exec, in a program with threads: system calls only. The C library's setresuid would speak to threads
// that are not here.
[[noreturn]] void become(const std::vector<int>& kept, std::optional<uid_t> user, const int (&standard)[3],
                         char* const* command, char* const* environment) {
    for (int i = 0; i < 3; ++i) {
        ::dup2(standard[i], i);
    }
    for (const int file : kept) {
        ::fcntl(file, F_SETFD, 0);
    }
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::signal(SIGPIPE, SIG_DFL);
    if (user.has_value() &&
        (::syscall(SYS_setgroups, 0, nullptr) != 0 || ::syscall(SYS_setresgid, *user, *user, *user) != 0 ||
         ::syscall(SYS_setresuid, *user, *user, *user) != 0)) {
        ::_exit(126);
    }
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    ::execve(command[0], command, environment);
    ::_exit(127);
}

std::uint64_t resultCap(const Job& job) {
    std::uint64_t cap = sizeof(wire::Head) + 65536;
    for (const Wanted& wanted : job.wanted) {
        cap += sizeof(wire::FileHead) + wanted.bytes;
    }
    return cap;
}

// Appends up to the cap; answers false at the end of the pipe. `more`: something was passed over.
bool readSome(int pipe, std::string& text, std::uint64_t cap, bool& more) {
    char part[65536];
    const ssize_t got = ::read(pipe, part, sizeof(part));
    if (got < 0) {
        return errno == EINTR || errno == EAGAIN;
    }
    const std::uint64_t room = cap - std::min<std::uint64_t>(cap, text.size());
    const auto taken = std::min<std::uint64_t>(room, static_cast<std::uint64_t>(got));
    text.append(part, taken);
    more = more || taken < static_cast<std::uint64_t>(got);
    return got > 0;
}

// Both pipes to their ends. After the result's end, what is still said is waited for only shortly: nothing runs any more.
void readBoth(int said, int result, const Job& job, Gathered& gathered) {
    const std::uint64_t cap = resultCap(job);
    auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double>(job.limits.wallSeconds + graceSeconds));
    pollfd pipes[2] = {{said, POLLIN, 0}, {result, POLLIN, 0}};
    bool tooMuch = false;
    while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0 || tooMuch) {
            gathered.late = pipes[1].fd >= 0;
            return;
        }
        ::poll(pipes, 2, static_cast<int>(std::min<long long>(left, 1000)));
        if (pipes[0].revents != 0 &&
            !readSome(said, gathered.said, job.limits.saidBytes, gathered.saidMore)) {
            pipes[0].fd = -1;
        }
        if (pipes[1].revents != 0 && !readSome(result, gathered.result, cap, tooMuch)) {
            pipes[1].fd = -1;
            end = std::min(end, Clock::now() + std::chrono::seconds(1));
        }
        pipes[0].revents = pipes[1].revents = 0;
    }
}

// bubblewrap's namespace dies with it; grade_inside, where it is alone, first ends all that it has started.
void end(pid_t process, bool late) {
    if (late) {
        ::kill(process, SIGTERM);
        for (int i = 0; i < 500; ++i) {
            if (::waitpid(process, nullptr, WNOHANG) == process) {
                return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        ::kill(process, SIGKILL);
    }
    while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
}

}  // namespace

Gathered gather(Start start, const std::string& task, const Job& job) {
    const Descriptor null = nothing();
    auto [saidRead, saidWrite] = makePipe();
    auto [resultRead, resultWrite] = makePipe();
    start.files.push_back(inMemory(task));
    std::vector<int> kept;
    for (const Descriptor& file : start.files) {
        kept.push_back(file.number());
    }
    kept.push_back(resultWrite.number());
    for (std::string& word : start.command) {
        word = word == "{job}"      ? std::to_string(start.files.back().number())
               : word == "{result}" ? std::to_string(resultWrite.number())
                                    : word;
    }
    const std::vector<char*> command = pointers(start.command);
    const std::vector<char*> environment = pointers(start.environment);
    const int standard[3] = {null.number(), saidWrite.number(), saidWrite.number()};
    const pid_t process = ::fork();
    if (process < 0) {
        throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
    }
    if (process == 0) {
        become(kept, start.user, standard, command.data(), environment.data());
    }
    saidWrite.close();
    resultWrite.close();
    start.files.clear();
    Gathered gathered;
    readBoth(saidRead.number(), resultRead.number(), job, gathered);
    end(process, gathered.late);
    return gathered;
}

}  // namespace grader
