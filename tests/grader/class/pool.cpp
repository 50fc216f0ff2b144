// Forked workers, waited for by signal.
// SPDX-License-Identifier: MIT
#include "grader/class/pool.hpp"

#include "lab/progress.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <map>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;

enum WorkerStatus { Done = 0, SaidNo = 1, Threw = 2 };

constexpr std::size_t longestMessage = 4000;  // a pipe takes it whole before anybody reads

// While it lives, these signals wait until they are asked for: the pool has children to end and results to keep whole.
class Signals {
  public:
    Signals() {
        sigset_t all;
        sigemptyset(&all);
        sigaddset(&all, SIGCHLD);
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            struct sigaction action {};
            if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
                sigaddset(&all, number);
        }
        wanted_ = all;
        sigprocmask(SIG_BLOCK, &all, &before_);
    }
    ~Signals() { restore(); }
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

    void restore() const { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    /// The next one within a second; 0: none.
    int next() const {
        const timespec second{1, 0};
        return std::max(0, sigtimedwait(&wanted_, nullptr, &second));
    }

  private:
    sigset_t wanted_{}, before_{};
};

struct Worker {
    std::size_t work;
    Clock::time_point start;
    int message;  // the reading end of a pipe: what it threw
    bool late = false;
};

[[noreturn]] void beWorker(std::size_t i, int message, pid_t parent,
                           const std::function<bool(std::size_t)>& work) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // whoever ends the pool ends all of it
    if (getppid() != parent)
        _exit(Threw);
    int status = Threw;
    std::string text = "it threw what is no exception";
    try {
        status = work(i) ? Done : SaidNo;
    } catch (const std::exception& error) {
        text = error.what();
    } catch (...) {
    }
    if (status == Threw) {
        [[maybe_unused]] const ssize_t ignored =
            write(message, text.data(), std::min(text.size(), longestMessage));
    }
    _exit(status);
}

std::string readAll(int file) {
    std::string text;
    char buffer[4096];
    for (ssize_t got = 0; (got = read(file, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(got));
    close(file);
    return text;
}

std::string whyOf(int status, const std::string& message, bool late) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == SaidNo)
        return "";
    if (late)
        return "the grader's process took too long and was ended";
    if (WIFSIGNALED(status))
        return std::string("the grader's process was ended by signal ") + strsignal(WTERMSIG(status));
    return message.empty() ? "the grader's process ended without a word" : message;
}

std::string timeLeft(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%d:%02d", static_cast<int>(seconds) / 60,
                  static_cast<int>(seconds) % 60);
    return text;
}

// The processes at work, and what is still to do.
class Pool {
  public:
    Pool(std::size_t count, int jobs, double limit)
        : count_(count), jobs_(static_cast<std::size_t>(jobs)), limit_(limit) {}
    bool isDone() const { return next_ == count_ && workers_.empty(); }
    void start(const std::function<bool(std::size_t)>& work, const Signals& signals) {
        while (next_ < count_ && workers_.size() < jobs_) {
            int ends[2];
            if (pipe2(ends, O_CLOEXEC) != 0)
                throw std::runtime_error(std::string("no pipe for a worker: ") + std::strerror(errno));
            std::cout.flush();
            const pid_t parent = getpid(), child = fork();
            if (child == 0) {
                signals.restore();
                close(ends[0]);
                beWorker(next_, ends[1], parent, work);
            }
            close(ends[1]);
            if (child < 0) {
                close(ends[0]);
                throw std::runtime_error(std::string("no process for a worker: ") + std::strerror(errno));
            }
            workers_[child] = {next_++, Clock::now(), ends[0]};
        }
    }
    /// Takes in all that have ended.
    bool takeIn(const std::function<void(std::size_t, const std::string&)>& failed) {
        const std::size_t before = finished_;
        int status = 0;
        for (pid_t child = 0; (child = waitpid(-1, &status, WNOHANG)) > 0;) {
            const auto found = workers_.find(child);
            if (found == workers_.end())
                continue;
            const Worker worker = found->second;
            workers_.erase(found);
            ++finished_;
            const std::string message = readAll(worker.message);
            if (!WIFEXITED(status) || WEXITSTATUS(status) != Done)
                failed(worker.work, whyOf(status, message, worker.late));
        }
        return finished_ != before;
    }
    void endLateOnes() {
        for (auto& [child, worker] : workers_)
            if (std::chrono::duration<double>(Clock::now() - worker.start).count() > limit_) {
                worker.late = true;
                kill(child, SIGKILL);
            }
    }
    void endAll() {
        for (const auto& each : workers_)
            kill(each.first, SIGKILL);
        for (const auto& each : workers_)
            waitpid(each.first, nullptr, 0);
        workers_.clear();
    }
    void show(lab::Progress& progress) const {
        const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        const auto done = static_cast<double>(finished_), all = static_cast<double>(count_);
        progress.step(done / all, std::to_string(finished_) + "/" + std::to_string(count_) + "  " +
                                      timeLeft(seconds / done * (all - done)));
    }

  private:
    std::size_t count_, jobs_, next_ = 0, finished_ = 0;
    double limit_;
    std::map<pid_t, Worker> workers_;
    Clock::time_point begin_ = Clock::now();
};

// As if the signal had come to a program that does nothing about it.
void endBy(int number, const Signals& signals) {
    std::signal(number, SIG_DFL);
    signals.restore();
    raise(number);
}

}  // namespace

void runPool(std::size_t count, int jobs, const std::function<bool(std::size_t)>& work,
             const std::function<void(std::size_t, const std::string&)>& failed, double limitSeconds) {
    Pool pool(count, jobs, limitSeconds);
    const Signals signals;
    lab::Progress progress;
    while (!pool.isDone()) {
        pool.start(work, signals);
        const int number = signals.next();
        if (number != 0 && number != SIGCHLD) {
            pool.endAll();
            progress.clear();
            endBy(number, signals);
        }
        if (pool.takeIn([&](std::size_t i, const std::string& why) {
                progress.clear();
                failed(i, why);
            }))
            pool.show(progress);
        pool.endLateOnes();
    }
}

}  // namespace grader
