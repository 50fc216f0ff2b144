// Forked workers, waited for one by one.
// SPDX-License-Identifier: MIT
#include "grader/class/pool.hpp"

#include "lab/progress.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <map>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;

enum WorkerStatus { Done = 0, SaidNo = 1, Threw = 2 };

struct Worker {
    std::size_t work;
    int slot;
    Clock::time_point start;
    int message;  // the reading end of a pipe: what it threw
};

[[noreturn]] void beWorker(std::size_t i, int slot, int message, pid_t parent,
                           const std::function<bool(std::size_t, int)>& work) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // whoever ends the pool ends all of it
    if (getppid() != parent)
        _exit(Threw);
    int status = Threw;
    try {
        status = work(i, slot) ? Done : SaidNo;
    } catch (const std::exception& error) {
        const std::string text = error.what();
        [[maybe_unused]] const ssize_t ignored =
            write(message, text.data(), std::min<std::size_t>(text.size(), 4000));
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

std::string whyOf(int status, const std::string& message, bool tooLong) {
    if (tooLong)
        return "the grader's process took too long and was ended";
    if (WIFSIGNALED(status))
        return std::string("the grader's process was ended by signal ") + strsignal(WTERMSIG(status));
    if (WEXITSTATUS(status) == SaidNo)
        return "";
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
    Pool(std::size_t count, int jobs, double limit) : count_(count), limit_(limit) {
        for (int slot = jobs - 1; slot >= 0; --slot)
            free_.push_back(slot);
    }
    bool isDone() const { return next_ == count_ && workers_.empty(); }
    void start(const std::function<bool(std::size_t, int)>& work) {
        while (next_ < count_ && !free_.empty()) {
            int ends[2];
            if (pipe(ends) != 0)
                throw std::runtime_error(std::string("no pipe for a worker: ") + std::strerror(errno));
            std::cout.flush();
            const pid_t parent = getpid(), child = fork();
            if (child == 0) {
                close(ends[0]);
                beWorker(next_, free_.back(), ends[1], parent, work);
            }
            close(ends[1]);
            if (child < 0)
                throw std::runtime_error(std::string("no process for a worker: ") + std::strerror(errno));
            workers_[child] = {next_++, free_.back(), Clock::now(), ends[0]};
            free_.pop_back();
        }
    }
    /// Takes in one that has ended, if one has.
    bool takeIn(const std::function<void(std::size_t, const std::string&)>& failed) {
        int status = 0;
        const pid_t child = waitpid(-1, &status, WNOHANG);
        const auto found = workers_.find(child);
        if (child <= 0 || found == workers_.end())
            return false;
        const Worker worker = found->second;
        workers_.erase(found);
        free_.push_back(worker.slot);
        ++finished_;
        const std::string message = readAll(worker.message);
        if (!WIFEXITED(status) || WEXITSTATUS(status) != Done)
            failed(worker.work, whyOf(status, message, late_.count(child) != 0));
        late_.erase(child);
        return true;
    }
    void endLateOnes() {
        for (const auto& [child, worker] : workers_)
            if (std::chrono::duration<double>(Clock::now() - worker.start).count() > limit_) {
                late_[child] = true;
                kill(child, SIGKILL);
            }
    }
    void show(lab::Progress& progress) const {
        const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        std::string text = std::to_string(finished_) + "/" + std::to_string(count_);
        if (finished_ > 0)
            text += "  " + timeLeft(seconds / static_cast<double>(finished_) *
                                    static_cast<double>(count_ - finished_));
        progress.step(static_cast<double>(finished_) / static_cast<double>(std::max<std::size_t>(count_, 1)),
                      text);
    }

  private:
    std::size_t count_, next_ = 0, finished_ = 0;
    double limit_;
    std::vector<int> free_;
    std::map<pid_t, Worker> workers_;
    std::map<pid_t, bool> late_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

void runPool(std::size_t count, int jobs, const std::function<bool(std::size_t, int)>& work,
             const std::function<void(std::size_t, const std::string&)>& failed, double limitSeconds) {
    Pool pool(count, jobs, limitSeconds);
    lab::Progress progress;
    while (!pool.isDone()) {
        pool.start(work);
        if (pool.takeIn([&](std::size_t i, const std::string& why) {
                progress.clear();
                failed(i, why);
            })) {
            pool.show(progress);
            continue;
        }
        pool.endLateOnes();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

}  // namespace grader
