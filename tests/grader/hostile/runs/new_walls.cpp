// Makes namespaces, mounts and system calls of its own, to be root in them.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <csignal>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/sysmacros.h>

int main() {
    refused("unshare", ::unshare(CLONE_NEWUSER));
    refused("unshare", ::unshare(CLONE_NEWNS));
    refused("clone", ::syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0));
    refused("mount", ::mount("none", "/box", "tmpfs", 0, ""));
    refused("umount", ::umount2("/box", 0));
    refused("chroot", ::chroot("."));
    refused("setns", ::setns(0, 0));
    refused("io_uring", ::syscall(SYS_io_uring_setup, 1, nullptr));
    refused("bpf", ::syscall(SYS_bpf, 0, nullptr, 0));
    refused("keyctl", ::syscall(SYS_keyctl, 0, 0, 0, 0, 0));
    refused("perf", ::syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0));
    refused("userfaultfd", ::syscall(SYS_userfaultfd, 0));
    refused("setuid", ::setuid(0));
    refused("mknod", ::mknod("disk", S_IFBLK | 0600, makedev(8, 0)));
    const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    refused("setrlimit", ::setrlimit(RLIMIT_NPROC, &more));
    refused("write", ::open("../lab/bin/program", O_WRONLY));
    refused("write", ::open("../lab/share/lambert-lab/shaders/mesh.frag", O_WRONLY));
    refused("write", ::open("../lab/new", O_WRONLY | O_CREAT, 0600));
}
