// Which walls can be tested on this machine.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/confine.hpp"

#include <gtest/gtest.h>

#include <exception>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader {

/// Whether the kernel gives namespaces to a user of no rights, without which there is no bubblewrap: not in most containers, never
/// in a chroot. Asked here without bubblewrap, so that its own failures are none of the machine's.
inline bool namespacesAllowed() {
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t nobody = 65534;
        const bool becomes = ::geteuid() != 0 || ::setuid(nobody) == 0;
        ::_exit(becomes && ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0 ? 0 : 1);
    }
    int status = 1;
    return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) &&
           WEXITSTATUS(status) == 0;
}

/// Whether bubblewrap is to be tested: it works, or nothing of the machine's keeps it from working.
inline bool bubblewrapIsDue() {
    if (namespacesAllowed())
        return true;
    try {
        const Confinement works(Walls::bubblewrap);
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

/// Those that guard files, the best first. ConfineWalls.AreAllTestedHere says which are left out.
inline std::vector<Walls> testableWalls() {
    static const bool all = bubblewrapIsDue();
    return all ? std::vector{Walls::bubblewrap, Walls::landlock} : std::vector{Walls::landlock};
}

/// In the names of tests.
inline std::string wallsName(const testing::TestParamInfo<Walls>& walls) { return name(walls.param); }

}  // namespace grader
