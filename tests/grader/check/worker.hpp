// Judges in a thread of its own, so that a window stays awake.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/grading/grader.hpp"

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace grader {

/// What came of looking at the file once.
struct Round {
    Graded graded;
    std::string trouble;  ///< why there is no verdict: the file cannot be read; else empty
    std::exception_ptr fatal;  ///< the grader itself cannot be made: there will be no more rounds
};

class Worker {
  public:
    /// Looks at the file for the first time. `wake` is called from the thread whenever busy() changes or there is something to take.
    Worker(const GraderOptions& options, std::filesystem::path file, std::function<void()> wake);
    /// Waits until what is being done is done.
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Something was saved: judges what is there if it is not what was judged last, after what is being done. `again`: in any case.
    void look(bool again = false);
    /// Whether something is being built.
    bool busy() const;
    /// The latest round that was not taken yet.
    std::optional<Round> take();

  private:
    void run();
    void judge(const Grader& grader, bool again);
    void tell(Round round);

    const GraderOptions options_;
    const std::filesystem::path file_;
    const std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable asks_;
    bool asked_ = true, again_ = true, busy_ = true, quit_ = false;
    std::optional<Round> round_;
    std::string judged_;  // the hash; of the thread alone
    std::thread thread_;  // last: it uses all of the above
};

}  // namespace grader
