// Refuses the system calls that neither a compiler nor a frame needs: networks, other processes, namespaces, memory of no process.
// SPDX-License-Identifier: MIT
#include "grader/confine/inside/task.hpp"

#include <sched.h>
#include <seccomp.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/socket.h>

namespace grader::inside {

namespace {

class Filter {
  public:
    Filter() : filter_(::seccomp_init(SCMP_ACT_ALLOW)) {
        if (filter_ == nullptr) {
            throw std::runtime_error("seccomp: no memory");
        }
    }
    ~Filter() { ::seccomp_release(filter_); }
    Filter(const Filter&) = delete;
    Filter& operator=(const Filter&) = delete;

    void refuse(const char* call, int error) { add(call, error, 0, nullptr); }
    void refuse(const char* call, int error, scmp_arg_cmp argument) { add(call, error, 1, &argument); }
    void begin() { check(::seccomp_load(filter_), "load"); }

  private:
    void add(const char* call, int error, unsigned count, const scmp_arg_cmp* arguments) {
        const int number = ::seccomp_syscall_resolve_name(call);
        if (number != __NR_SCMP_ERROR) {  // one that this libseccomp does not know yet
            check(::seccomp_rule_add_array(filter_, SCMP_ACT_ERRNO(static_cast<unsigned>(error)), number,
                                           count, arguments),
                  call);
        }
    }
    void check(int result, const char* what) {
        if (result < 0) {
            throw std::runtime_error(std::string("seccomp: ") + what + ": " + std::strerror(-result));
        }
    }

    scmp_filter_ctx filter_;
};

scmp_arg_cmp whenEqual(unsigned argument, std::uint64_t value) { return {argument, SCMP_CMP_EQ, value, 0}; }

// Other processes, other namespaces, and the machine's own affairs.
const char* const refused[] = {"ptrace",
                               "process_vm_readv",
                               "process_vm_writev",
                               "process_madvise",
                               "pidfd_getfd",
                               "kcmp",
                               "unshare",
                               "setns",
                               "mount",
                               "umount2",
                               "pivot_root",
                               "chroot",
                               "open_tree",
                               "move_mount",
                               "fsopen",
                               "fsmount",
                               "fsconfig",
                               "fspick",
                               "mount_setattr",
                               "bpf",
                               "perf_event_open",
                               "userfaultfd",
                               "keyctl",
                               "add_key",
                               "request_key",
                               "init_module",
                               "finit_module",
                               "delete_module",
                               "kexec_load",
                               "name_to_handle_at",
                               "open_by_handle_at",
                               "quotactl",
                               "acct",
                               "swapon",
                               "swapoff",
                               "fanotify_init",
                               "sched_setscheduler",
                               "sched_setattr",
                               "setpriority",
                               "ioprio_set",
                               "io_setup"};

void refuseWaysOut(Filter& filter) {
    for (const char* call : refused) {
        filter.refuse(call, EPERM);
    }
    for (const char* call : {"io_uring_setup", "io_uring_enter", "io_uring_register"}) {
        filter.refuse(call, ENOSYS);
    }
    filter.refuse("personality", EPERM, {0, SCMP_CMP_NE, 0xFFFFFFFF, 0});  // but one may ask for it
    filter.refuse("prlimit64", EPERM, {0, SCMP_CMP_NE, 0, 0});  // of another process
    filter.refuse("clone3", ENOSYS);  // its flags cannot be looked at; the C library then takes clone
    filter.refuse("clone", EPERM, {0, SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER});
    filter.refuse("socket", EACCES);
    filter.refuse("socketpair", EACCES, {0, SCMP_CMP_NE, AF_UNIX, 0});
    filter.refuse("ioctl", EPERM,
                  {1, SCMP_CMP_MASKED_EQ, 0xFFFFFFFF, 0x5412});  // TIOCSTI types into a terminal
}

// Memory that belongs to no process, where nobody would count it.
void refuseHiddenMemory(Filter& filter) {
    for (const char* call : {"memfd_create", "memfd_secret", "shmget", "semget", "msgget", "mq_open"}) {
        filter.refuse(call, ENOSYS);
    }
}

// Without a PID namespace: signals to whoever supervises, or to everybody. abort() and raise() signal themselves with tgkill.
void refuseSignals(Filter& filter, pid_t supervisor) {
    for (const char* call : {"kill", "tkill", "rt_sigqueueinfo", "rt_tgsigqueueinfo", "pidfd_send_signal"}) {
        filter.refuse(call, EPERM);
    }
    filter.refuse("tgkill", EPERM, whenEqual(0, static_cast<std::uint64_t>(supervisor)));
    // A guardian that dies with its parent may not be told otherwise, and nobody else becomes one.
    filter.refuse("prctl", EPERM, whenEqual(0, PR_SET_CHILD_SUBREAPER));
}

}  // namespace

void refuseSystemCalls(const Task& task, pid_t supervisor) {
    Filter filter;
    refuseWaysOut(filter);
    refuseHiddenMemory(filter);
    if (!task.namespaces) {
        refuseSignals(filter, supervisor);
    }
    filter.begin();
}

}  // namespace grader::inside
