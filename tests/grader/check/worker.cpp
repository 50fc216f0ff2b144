// The thread that judges.
// SPDX-License-Identifier: MIT
#include "grader/check/worker.hpp"

#include <utility>

namespace grader {

Worker::Worker(const GraderOptions& options, std::filesystem::path file, std::function<void()> wake)
    : options_(options), file_(std::move(file)), wake_(std::move(wake)), thread_([this] { run(); }) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
    }
    asks_.notify_one();
    thread_.join();
}

void Worker::look(bool again) {
    {
        const std::lock_guard lock(mutex_);
        asked_ = true;
        again_ = again_ || again;
    }
    asks_.notify_one();
}

bool Worker::busy() const {
    const std::lock_guard lock(mutex_);
    return busy_;
}

std::optional<Round> Worker::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(round_, std::nullopt);
}

void Worker::tell(Round round) {
    {
        const std::lock_guard lock(mutex_);
        round_ = std::move(round);
        busy_ = false;
    }
    wake_();
}

void Worker::judge(const Grader& grader, bool again) {
    Round round;
    try {
        std::string hash = grader.hashOf(file_);
        if (!again && hash == judged_)
            return;
        {
            const std::lock_guard lock(mutex_);
            busy_ = true;
        }
        wake_();
        judged_ = std::move(hash);
        round.graded = grader.grade(file_);
    } catch (const std::exception& error) {  // as while an editor has taken the file away for a moment
        judged_.clear();
        round.trouble = error.what();
    }
    tell(std::move(round));
}

void Worker::run() {
    std::optional<Grader> grader;
    try {
        grader.emplace(options_);
    } catch (...) {
        Round round;
        round.fatal = std::current_exception();
        return tell(std::move(round));
    }
    for (;;) {
        bool again = false;
        {
            std::unique_lock lock(mutex_);
            asks_.wait(lock, [this] { return asked_ || quit_; });
            if (quit_)
                return;
            asked_ = false;
            again = std::exchange(again_, false);
        }
        judge(*grader, again);
    }
}

}  // namespace grader
