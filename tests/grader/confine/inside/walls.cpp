// The walls that a process puts up around itself: user, limits, Landlock, and system calls.
// SPDX-License-Identifier: MIT
#include "grader/confine/inside/task.hpp"

#include <linux/landlock.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <grp.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace grader::inside {

namespace {

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + ": " + std::strerror(errno));
}

void require(bool done, const std::string& what) {
    if (!done) {
        fail(what);
    }
}

void limit(decltype(RLIMIT_AS) resource, std::uint64_t soft, std::uint64_t hard, const char* what) {
    const rlimit value{soft, hard};
    require(::setrlimit(resource, &value) == 0, std::string("cannot limit ") + what);
}

void becomeUser(std::int64_t user) {
    const auto id = static_cast<uid_t>(user);
    require(::setgroups(0, nullptr) == 0 && ::setresgid(id, id, id) == 0 && ::setresuid(id, id, id) == 0,
            "cannot become user " + std::to_string(user));
}

void setLimits(const Task& task) {
    limit(RLIMIT_CORE, 0, 0, "core files");
    limit(RLIMIT_CPU, task.cpuSeconds, task.cpuSeconds + 1, "the processor time");
    limit(RLIMIT_FSIZE, task.fileBytes, task.fileBytes, "the size of files");
    limit(RLIMIT_NOFILE, 256, 256, "the number of open files");
    limit(RLIMIT_MEMLOCK, 1 << 16, 1 << 16, "locked memory");
    limit(RLIMIT_MSGQUEUE, 0, 0, "message queues");
    limit(RLIMIT_NPROC, task.processes, task.processes, "the number of processes");
    limit(RLIMIT_AS, task.memoryBytes, task.memoryBytes, "the memory");
}

// Landlock is younger than glibc's and Debian's headers know; these are its numbers in the kernel's interface.
constexpr std::uint64_t truncateFile = 1ULL << 14;  // from version 3
constexpr std::uint64_t deviceControl = 1ULL << 15;  // 5
constexpr std::uint64_t scopes = (1ULL << 0) | (1ULL << 1);  // 6: abstract sockets, signals
struct Ruleset {
    std::uint64_t files = 0;
    std::uint64_t network = 0;
    std::uint64_t scoped = 0;
};

constexpr std::uint64_t readAndRun =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;

Ruleset rulesOf(long version) {
    Ruleset rules;
    rules.files = (1ULL << 13) - 1;
    if (version >= 2) {
        rules.files |= LANDLOCK_ACCESS_FS_REFER;
    }
    if (version >= 3) {
        rules.files |= truncateFile;
    }
    if (version >= 4) {
        rules.network = 3;  // bind and connect, TCP
    }
    if (version >= 5) {
        rules.files |= deviceControl;
    }
    if (version >= 6) {
        rules.scoped = scopes;
    }
    return rules;
}

// What is not there cannot be used either.
void allow(int ruleset, const std::string& path, std::uint64_t access) {
    const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
    if (file < 0) {
        return;
    }
    struct stat status {};
    require(::fstat(file, &status) == 0, path);
    if (!S_ISDIR(status.st_mode)) {
        access &= LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;
    }
    const landlock_path_beneath_attr rule{access, file};
    require(::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0,
            "Landlock refuses a rule for " + path);
    ::close(file);
}

void restrictFiles(const Task& task) {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    require(version >= 1, "the kernel has no Landlock");
    const Ruleset rules = rulesOf(version);
    const auto ruleset = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &rules, sizeof(rules), 0));
    require(ruleset >= 0, "Landlock refuses its rules");
    for (const std::string& path : task.readable) {
        allow(ruleset, path, readAndRun);
    }
    for (const char* device : {"/dev/null", "/dev/zero", "/dev/urandom", "/dev/random"}) {
        allow(ruleset, device, LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE);
    }
    const std::uint64_t devices =
        LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_BLOCK | deviceControl;
    allow(ruleset, task.box, rules.files & ~devices);
    require(::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0, "Landlock cannot begin");
    ::close(ruleset);
}

}  // namespace

void putUpWalls(const Task& task, pid_t supervisor) {
    if (task.user >= 0) {
        becomeUser(task.user);
    }
    setLimits(task);
    require(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "no_new_privs");
    for (const std::string& path : task.readable) {
        require(::access(path.c_str(), R_OK) == 0 || errno == ENOENT,
                "user " + std::to_string(::getuid()) + " cannot read " + path);
    }
    if (task.landlock) {
        restrictFiles(task);
    }
    refuseSystemCalls(task, supervisor);
}

}  // namespace grader::inside
