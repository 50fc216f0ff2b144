// Users that own nothing, one for each job at a time, also between graders that know nothing of each other.
// SPDX-License-Identifier: MIT
#include "grader/confine/start.hpp"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace grader {

namespace {

constexpr int firstUser = 64000;  // Debian gives these to nobody
constexpr int users = 500;

// A name that the kernel keeps for one process at a time, and gives back however that ends. It is no file.
Descriptor take(int number) {
    Descriptor mark(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string name = "lambert-grader-user-" + std::to_string(number);
    std::memcpy(address.sun_path + 1, name.data(), name.size());  // the first stays 0
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    if (mark.open() && ::bind(mark.number(), reinterpret_cast<const sockaddr*>(&address), size) == 0) {
        return mark;
    }
    if (mark.open() && errno == EADDRINUSE) {
        return {};
    }
    throw std::runtime_error(std::string("cannot mark a user as taken: ") + std::strerror(errno));
}

}  // namespace

Lease::Lease(int slot) {
    if (::geteuid() != 0) {
        return;
    }
    for (int tried = 0; tried < users && !mark_.open(); ++tried) {
        const int number = ((slot + tried) % users + users) % users;
        mark_ = take(number);
        user_ = static_cast<uid_t>(firstUser + number);
    }
    if (!mark_.open()) {
        throw std::runtime_error("all " + std::to_string(users) +
                                 " users are taken; let fewer jobs run at a time");
    }
}

}  // namespace grader
