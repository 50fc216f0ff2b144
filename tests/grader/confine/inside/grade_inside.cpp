// grade_inside JOB RESULT: the first process inside a confinement, and its only trusted one. Starts the command, watches it,
// ends all that it started, and only then hands back what is wanted. The numbers are file descriptors.
// SPDX-License-Identifier: MIT
#include "grader/confine/inside/task.hpp"
#include "grader/confine/pointers.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace grader;
using inside::Task;
using wire::End;
using wire::Limit;

struct Ending {
    End end = End::trouble;
    int status = 0;
    Limit limit = Limit::none;
    std::string text;
};

std::string readAll(int file) {
    std::string all;
    char part[4096];
    for (ssize_t got = 0; (got = ::read(file, part, sizeof(part))) > 0;) {
        all.append(part, static_cast<std::size_t>(got));
    }
    return all;
}

[[noreturn]] void becomeCommand(Task task, int errors, pid_t supervisor) {
    try {
        ::setsid();
        ::signal(SIGPIPE, SIG_DFL);
        inside::putUpWalls(task, supervisor);
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // becoming another user has taken it back
        std::string program = task.command.at(0);
        if (program.find('/') == std::string::npos) {
            program = "/usr/bin/" + program;
        }
        sigset_t none;
        sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        ::execve(program.c_str(), pointers(task.command).data(), pointers(task.environment).data());
        throw std::runtime_error("cannot start " + program + ": " + std::strerror(errno));
    } catch (const std::exception& error) {
        const std::string text = error.what();
        inside::send(errors, text.data(), text.size());
    }
    ::_exit(127);
}

Limit exceeded(const Task& task) {
    const inside::Use use = inside::measure(task);
    if (use.memoryBytes > task.memoryBytes) {
        return Limit::memory;
    }
    // In namespaces the folder cannot hold more, and the command is told so.
    if (!task.namespaces && use.folderBytes > task.folderBytes) {
        return Limit::folder;
    }
    return use.files > task.files ? Limit::files : Limit::none;
}

Ending endingOf(const Task& task, int status, const rusage& used) {
    Ending ending;
    if (WIFEXITED(status)) {
        ending.end = End::exited;
        ending.status = WEXITSTATUS(status);
        return ending;
    }
    ending.end = End::killed;
    ending.status = WTERMSIG(status);
    const auto seconds = static_cast<std::uint64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
    if (ending.status == SIGXCPU || (ending.status == SIGKILL && seconds >= task.cpuSeconds)) {
        ending.limit = Limit::processor;
    } else if (ending.status == SIGXFSZ) {
        ending.limit = Limit::folder;
    }
    return ending;
}

// Blocked, so that one can wait for them: a process has ended, or the grader is gone or wants it to end.
sigset_t awaited() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGCHLD);
    sigaddset(&signals, SIGTERM);
    return signals;
}

// Waits for the end, and measures now and then what is used.
Ending watch(const Task& task, pid_t command) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(task.wallSeconds));
    const sigset_t news = awaited();
    auto nextLook = Clock::now() + std::chrono::milliseconds(20);
    for (;;) {
        int status = 0;
        rusage used{};
        for (pid_t gone = 0; (gone = ::wait4(-1, &status, WNOHANG, &used)) > 0;) {
            if (gone == command) {
                return endingOf(task, status, used);
            }
        }
        Limit limit = Limit::none;
        const auto now = Clock::now();
        if (now >= end) {
            limit = Limit::clock;
        } else if (now >= nextLook) {
            limit = exceeded(task);
            nextLook = Clock::now() + std::chrono::milliseconds(50);
        }
        if (limit != Limit::none) {
            const bool writes = limit == Limit::folder || limit == Limit::files;
            return {End::killed, writes ? SIGXFSZ : SIGKILL, limit, ""};
        }
        const timespec pause{0, 20'000'000};
        if (::sigtimedwait(&news, nullptr, &pause) == SIGTERM) {
            return {End::killed, SIGTERM, Limit::none, ""};
        }
    }
}

Ending runCommand(const Task& task) {
    const sigset_t news = awaited();
    ::sigprocmask(SIG_BLOCK, &news, nullptr);
    int errors[2] = {-1, -1};
    if (::pipe2(errors, O_CLOEXEC) != 0) {
        throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
    }
    const pid_t self = ::getpid();
    const pid_t command = ::fork();
    if (command < 0) {
        throw std::runtime_error(std::string("no process: ") + std::strerror(errno));
    }
    if (command == 0) {
        becomeCommand(task, errors[1], self);
    }
    ::close(errors[1]);
    Ending ending;
    ending.text = readAll(errors[0]);
    ::close(errors[0]);
    return ending.text.empty() ? watch(task, command) : ending;
}

void prepare(const Task& task) {
    ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);  // nobody inside looks into our memory or our open files
    if (!task.namespaces) {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0) {
            throw std::runtime_error("cannot become the reaper of what it starts");
        }
    }
    if (::chdir(task.box.c_str()) != 0) {
        throw std::runtime_error("cannot enter " + task.box + ": " + std::strerror(errno));
    }
}

void sendEnding(const Ending& ending, int pipe) {
    wire::Head head;
    head.end = ending.end;
    head.limit = ending.limit;
    head.status = ending.status;
    head.textBytes = static_cast<std::uint16_t>(ending.text.size() < 4000 ? ending.text.size() : 4000);
    inside::send(pipe, &head, sizeof(head));
    inside::send(pipe, ending.text.data(), head.textBytes);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        return 2;  // no program for people
    }
    const int job = std::atoi(argv[1]);
    const int result = std::atoi(argv[2]);
    for (int file = 3; file < 1024;
         ++file) {  // the command inherits what it reads and says, and nothing else
        ::fcntl(file, F_SETFD, FD_CLOEXEC);
    }
    ::signal(SIGPIPE, SIG_IGN);
    Task task;
    int out = -1;
    Ending ending;
    try {
        task = inside::readTask(readAll(job));
        prepare(task);
        out = ::open("out", O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (out < 0) {
            throw std::runtime_error(std::string("cannot open out: ") + std::strerror(errno));
        }
        ending = runCommand(task);
    } catch (const std::exception& error) {
        ending.text = error.what();
    }
    inside::endAll(task);
    sendEnding(ending, result);
    if (ending.end != End::trouble) {
        inside::sendFiles(task, out, result);
    }
    return 0;
}
