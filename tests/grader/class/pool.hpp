// A pool of processes: each piece of work in a process of its own, so that none can spoil another.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace grader {

/// Runs work(i) for i from 0 to count - 1 in forked processes, at most `jobs` at a time. Where work returns false, throws or dies,
/// failed(i, why) is called here; `why` is empty for false. What runs longer than `limitSeconds` is ended. Shows progress with the time
/// left. At SIGINT, SIGTERM or SIGHUP all are ended, and this process by the same signal. Must be called while the process has one thread.
void runPool(std::size_t count, int jobs, const std::function<bool(std::size_t i)>& work,
             const std::function<void(std::size_t i, const std::string& why)>& failed,
             double limitSeconds = 600);

}  // namespace grader
