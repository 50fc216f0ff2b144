// Compiles programs on a thread of its own, so that a window goes on while they come about.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/context.hpp"
#include "render/program.hpp"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace render {

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
    };
    /// Calls `build` on the thread, and draws with what it returns, because drivers finish compiling when they first draw.
    void ask(ProgramKey key, std::function<Program()> build);
    /// What has become ready since the last call; where `wait`, waits until nothing is left to do.
    std::vector<Done> take(bool wait);

  private:
    struct Task {
        ProgramKey key;
        std::function<Program()> build;
    };
    void run();

    SharedContext context_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Task> tasks_;
    std::vector<Done> done_;
    bool busy_ = false;
    bool leave_ = false;
    std::thread thread_;
};

}  // namespace render
