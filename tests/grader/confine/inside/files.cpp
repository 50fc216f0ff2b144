// Gives the wanted files back, and only those: nothing that is a link, a device, somebody else's, or of another size.
// SPDX-License-Identifier: MIT
#include "grader/confine/inside/task.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace grader::inside {

namespace {

struct Found {
    wire::FileHead head;
    std::string bytes;
};

Found problem(wire::File file, std::uint64_t number = 0) {
    Found found;
    found.head.file = file;
    found.head.number = number;
    return found;
}

Found cannotOpen(int reason) {
    switch (reason) {
    case ENOENT:
        return problem(wire::File::missing);
    case ELOOP:
        return problem(wire::File::link);
    case ENXIO:  // a socket
        return problem(wire::File::notPlain);
    default:
        return problem(wire::File::unreadable, static_cast<std::uint64_t>(reason));
    }
}

Found readFile(int file, const Wanted& wanted, uid_t owner) {
    struct stat status {};
    if (::fstat(file, &status) != 0) {
        return problem(wire::File::unreadable, static_cast<std::uint64_t>(errno));
    }
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (!S_ISREG(status.st_mode)) {
        return problem(wire::File::notPlain);
    }
    if (status.st_nlink != 1) {
        return problem(wire::File::hardLink);
    }
    if (status.st_uid != owner) {
        return problem(wire::File::foreign);
    }
    if (wanted.exactly ? size != wanted.bytes : size > wanted.bytes) {
        return problem(wire::File::size, size);
    }
    Found found = problem(wire::File::here, size);
    found.bytes.resize(size);
    std::size_t have = 0;
    while (have < size) {
        const ssize_t got = ::read(file, found.bytes.data() + have, size - have);
        if (got <= 0) {
            return problem(wire::File::unreadable, static_cast<std::uint64_t>(got < 0 ? errno : EIO));
        }
        have += static_cast<std::size_t>(got);
    }
    return found;
}

}  // namespace

void send(int pipe, const void* bytes, std::size_t size) {
    const char* next = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t sent = ::write(pipe, next, size);
        if (sent < 0 && errno == EINTR) {
            continue;
        }
        if (sent <= 0) {
            ::_exit(1);
        }
        next += sent;
        size -= static_cast<std::size_t>(sent);
    }
}

void sendFiles(const Task& task, int out, int pipe) {
    const uid_t owner = task.user >= 0 ? static_cast<uid_t>(task.user) : ::getuid();
    for (const Wanted& wanted : task.wanted) {
        const int file =
            ::openat(out, wanted.name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
        const Found found = file < 0 ? cannotOpen(errno) : readFile(file, wanted, owner);
        if (file >= 0) {
            ::close(file);
        }
        send(pipe, &found.head, sizeof(found.head));
        send(pipe, found.bytes.data(), found.bytes.size());
    }
}

}  // namespace grader::inside
