// Memory that belongs to no process: files without a name, shared segments.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <sys/shm.h>

int main() {
    refused("memfd_create", ::syscall(SYS_memfd_create, "x", 0U));
    refused("shmget", ::shmget(IPC_PRIVATE, 1 << 20, IPC_CREAT | 0600));
    refused("/dev/shm", ::open("/dev/shm/x", O_RDWR | O_CREAT, 0600));
}
