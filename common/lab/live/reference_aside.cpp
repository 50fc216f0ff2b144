// One thread that waits for frames to draw.
// SPDX-License-Identifier: MIT
#include "lab/live/reference_aside.hpp"

#include "render/reference_renderer.hpp"

#include <sys/resource.h>

namespace lab {

namespace {

constexpr int politeness = 15;  // nice: a fraction of a core where others want one, all cores where none does

}  // namespace

ReferenceAside::ReferenceAside(std::function<void()> onChange)
    : onChange_(std::move(onChange)), thread_([this] { work(); }) {}

ReferenceAside::~ReferenceAside() {
    {
        const std::lock_guard lock(mutex_);
        leave_ = true;
        stop_ = true;
        next_.reset();
    }
    asked_.notify_one();
    thread_.join();
}

void ReferenceAside::ask(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                         const lighting::Settings& settings, const render::FrameRequest& request) {
    cancel();  // before the copying: both want the cores
    Job job{{scene, camera, settings, request.width, request.height, {settings.view, settings.only}},
            request.floats};
    {
        const std::lock_guard lock(mutex_);
        next_.emplace(std::move(job));
    }
    asked_.notify_one();
}

void ReferenceAside::cancel() {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    next_.reset();
    frame_.reset();
    failure_ = nullptr;
    share_ = 0;
}

bool ReferenceAside::busy() const {
    const std::lock_guard lock(mutex_);
    return next_.has_value() || (drawing_ && !stop_);
}

double ReferenceAside::share() const {
    const std::lock_guard lock(mutex_);
    return share_;
}

std::optional<image::Frame> ReferenceAside::take() {
    const std::lock_guard lock(mutex_);
    if (failure_ != nullptr)
        std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::exchange(frame_, std::nullopt);
}

void ReferenceAside::work() {
    // Linux: of this thread, and of those that it starts.
    setpriority(PRIO_PROCESS, 0, politeness);
    for (;;) {
        std::optional<Job> job;
        {
            std::unique_lock lock(mutex_);
            drawing_ = false;
            asked_.wait(lock, [this] { return leave_ || next_.has_value(); });
            if (leave_)
                return;
            job = std::exchange(next_, std::nullopt);
            drawing_ = true;
            stop_ = false;
        }
        draw(*job);
    }
}

void ReferenceAside::draw(const Job& job) {
    std::optional<image::Frame> frame;
    std::exception_ptr failure;
    const auto progress = [this](double share) {
        {
            const std::lock_guard lock(mutex_);
            if (stop_)
                return;
            share_ = share;
        }
        changed();
    };
    try {
        frame = render::drawReference(job.reference, job.floats, progress, &stop_);
    } catch (...) {
        failure = std::current_exception();
    }
    {
        const std::lock_guard lock(mutex_);
        drawing_ = false;
        if (stop_)
            return;
        frame_ = std::move(frame);
        failure_ = failure;
    }
    changed();
}

}  // namespace lab
