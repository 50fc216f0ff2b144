// Compiles programs on a thread of its own, so that a window goes on while they come about.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/context.hpp"
#include "render/program.hpp"

#include <array>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace render {

/// Why a program is asked for; what is more urgent is compiled first, and what was asked first among equals.
enum class Urgency {
    wanted,  ///< a picture waits for it
    better,  ///< it draws faster than the one in use
    ahead  ///< it may be wanted next
};

/// A thread with a context that shares programs with the one that is current where this is made.
class CompileAside {
  public:
    CompileAside();
    /// Finishes the program at hand; those that wait are dropped.
    ~CompileAside();
    CompileAside(const CompileAside&) = delete;
    CompileAside& operator=(const CompileAside&) = delete;

    /// False where the driver has no second context: then nothing can be asked.
    bool usable() const { return context_.usable(); }

    /// A program that is ready to use, or could not be compiled.
    struct Done {
        ProgramKey key;
        Program program;
        bool failed = false;
        std::string error = {};  ///< why
    };
    /// Calls `build` on the thread, and draws with what it returns, because drivers finish compiling when they first draw. A program
    /// that is asked for already is not compiled twice; it becomes as urgent as it is now. Of those `ahead` that wait, the oldest is
    /// dropped where there are very many.
    void ask(Urgency urgency, const ProgramKey& key, std::function<Program()> build);
    /// What has become ready since the last call.
    std::vector<Done> take();
    /// Waits until that program is ready to take, or not asked for; without one, until nothing is left to do.
    void wait(const ProgramKey* key = nullptr);
    /// Drops what waits, what is at hand and what is ready: shader files have changed.
    void dropAll();
    /// Whether a program is `wanted` and not ready.
    bool isWanted() const;
    /// Is called on the thread when a program that was `wanted` is ready, or has failed.
    void onWanted(std::function<void()> call);

  private:
    struct Task {
        ProgramKey key;
        std::function<Program()> build;
    };
    class Canvas;
    using Queues = std::array<std::deque<Task>, 3>;  // by urgency
    void run();
    bool idle() const;
    Task next();
    static Done work(const Task& task, const Canvas* canvas);
    bool keep(Done done);
    bool asked(const ProgramKey& key) const;
    bool raise(Urgency urgency, const ProgramKey& key);

    SharedContext context_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Queues queues_;
    std::optional<ProgramKey> atHand_;
    Urgency atHandUrgency_ = Urgency::ahead;
    bool dropAtHand_ = false;
    std::vector<Done> done_;
    std::function<void()> onWanted_;
    bool leave_ = false;
    std::thread thread_;
};

}  // namespace render
