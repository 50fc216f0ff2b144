// The thread, and a triangle that nobody sees.
// SPDX-License-Identifier: MIT
#include "render/compile_aside.hpp"

#include "render/gpu_geometry.hpp"
#include "render/render_target.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <sys/resource.h>
#include <utility>

namespace render {

namespace {

constexpr int politeness = 10;  // nice: drawing goes first where there are not cores enough for both

constexpr std::size_t mostAhead = 64;  // that wait; more would be compiled long after anybody wants them

// Mesa writes its shader cache on a thread that has the lowest priority, and tells nobody when it has. A picture that waits had rather
// wait for that than for compiling the same once more on the thread that draws.
constexpr std::chrono::milliseconds untilCached{25};

}  // namespace

// What a picture is drawn into, small: drivers compile for its format, and keep the result (Mesa in its shader cache, where the
// thread that draws finds it).
class CompileAside::Canvas {
  public:
    Canvas() : target_(16, 16, PixelFormat::codes, false) {
        glGenVertexArrays(1, &vertexArray_);
        glBindVertexArray(vertexArray_);
        glGenBuffers(1, &vertices_);
        glBindBuffer(GL_ARRAY_BUFFER, vertices_);
        const float nothing[18] = {};
        glBufferData(GL_ARRAY_BUFFER, sizeof nothing, nothing, GL_STATIC_DRAW);
        describeVertices();
        target_.bind();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_CULL_FACE);
        glDisable(GL_DITHER);
    }
    ~Canvas() {
        glDeleteBuffers(1, &vertices_);
        glDeleteVertexArrays(1, &vertexArray_);
    }
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    void draw(const Program& program) const {
        glUseProgram(program.id);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glUseProgram(0);
        glFinish();
    }

  private:
    GLuint vertexArray_ = 0, vertices_ = 0;
    RenderTarget target_;
};

CompileAside::CompileAside() {
    if (usable())
        thread_ = std::thread([this] { run(); });
}

CompileAside::~CompileAside() {
    {
        const std::lock_guard lock(mutex_);
        leave_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable())
        thread_.join();
    for (const Done& done : done_)
        glDeleteProgram(done.program.id);
}

void CompileAside::ask(Urgency urgency, const ProgramKey& key, std::function<Program()> build) {
    {
        const std::lock_guard lock(mutex_);
        if (raise(urgency, key))
            return;
        std::deque<Task>& queue = queues_[static_cast<std::size_t>(urgency)];
        queue.push_back({key, std::move(build)});
        if (urgency == Urgency::ahead && queue.size() > mostAhead)
            queue.pop_front();
    }
    changed_.notify_all();
}

// Whether the program is asked for already, at least as urgently as it is wanted after this call.
bool CompileAside::raise(Urgency urgency, const ProgramKey& key) {
    if (atHand_ == key && !dropAtHand_) {
        atHandUrgency_ = std::min(atHandUrgency_, urgency);
        return true;
    }
    for (std::size_t i = 0; i < queues_.size(); ++i) {
        std::deque<Task>& queue = queues_[i];
        const auto task =
            std::find_if(queue.begin(), queue.end(), [&](const Task& t) { return t.key == key; });
        if (task == queue.end())
            continue;
        if (i > static_cast<std::size_t>(urgency)) {
            queues_[static_cast<std::size_t>(urgency)].push_back(std::move(*task));
            queue.erase(task);
        }
        return true;
    }
    return std::any_of(done_.begin(), done_.end(), [&](const Done& done) { return done.key == key; });
}

std::vector<CompileAside::Done> CompileAside::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(done_, {});
}

bool CompileAside::idle() const {
    return !atHand_ && std::all_of(queues_.begin(), queues_.end(), [](const auto& q) { return q.empty(); });
}

bool CompileAside::asked(const ProgramKey& key) const {
    return atHand_ == key ||
           std::any_of(queues_.begin(), queues_.end(), [&key](const std::deque<Task>& queue) {
               return std::any_of(queue.begin(), queue.end(), [&key](const Task& t) { return t.key == key; });
           });
}

void CompileAside::wait(const ProgramKey* key) {
    std::unique_lock lock(mutex_);
    if (key != nullptr && asked(*key))
        raise(Urgency::wanted, *key);
    changed_.wait(lock, [this, key] { return key != nullptr ? !asked(*key) : idle(); });
}

void CompileAside::dropAll() {
    const std::lock_guard lock(mutex_);
    for (std::deque<Task>& queue : queues_)
        queue.clear();
    dropAtHand_ = atHand_.has_value();
    for (const Done& done : done_)
        glDeleteProgram(done.program.id);
    done_.clear();
}

bool CompileAside::isWanted() const {
    const std::lock_guard lock(mutex_);
    return !queues_[0].empty() || (atHand_ && !dropAtHand_ && atHandUrgency_ == Urgency::wanted);
}

void CompileAside::onWanted(std::function<void()> call) {
    const std::lock_guard lock(mutex_);
    onWanted_ = std::move(call);
}

CompileAside::Task CompileAside::next() {
    const auto queue = std::find_if(queues_.begin(), queues_.end(), [](const auto& q) { return !q.empty(); });
    Task task = std::move(queue->front());
    queue->pop_front();
    atHand_ = task.key;
    atHandUrgency_ = static_cast<Urgency>(queue - queues_.begin());
    dropAtHand_ = false;
    return task;
}

// Keeps what a task has come to, unless it is no longer asked for, and answers whether a picture waits for it.
bool CompileAside::keep(Done done) {
    const bool dropped = std::exchange(dropAtHand_, false);
    atHand_.reset();
    if (dropped)
        glDeleteProgram(done.program.id);
    else
        done_.push_back(std::move(done));
    return !dropped && atHandUrgency_ == Urgency::wanted;
}

CompileAside::Done CompileAside::work(const Task& task, const Canvas* canvas) {
    Done done{task.key, {}, true, "the driver has no memory for another context"};
    try {
        if (canvas != nullptr) {
            done.program = task.build();
            canvas->draw(done.program);
            done.failed = false;
        }
    } catch (const std::exception& error) {
        done.error = error.what();
    }
    return done;
}

void CompileAside::run() {
    setpriority(PRIO_PROCESS, 0, politeness);  // Linux: of this thread
    const bool current = context_.makeCurrent();
    {
        std::optional<Canvas> canvas;
        try {
            if (current)
                canvas.emplace();
        } catch (const std::exception&) {  // no memory for a few pixels: everything that is asked for fails
        }
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return leave_ || !idle(); });
            if (leave_)
                break;
            const Task task = next();
            lock.unlock();
            Done done = work(task, canvas ? &*canvas : nullptr);
            lock.lock();
            if (atHandUrgency_ != Urgency::ahead && !done.failed)
                changed_.wait_for(lock, untilCached, [this] { return leave_ || !queues_[0].empty(); });
            const std::function<void()> tell = keep(std::move(done)) ? onWanted_ : nullptr;
            changed_.notify_all();
            if (tell) {
                lock.unlock();
                tell();
                lock.lock();
            }
        }
    }
    if (current)
        context_.release();
}

}  // namespace render
