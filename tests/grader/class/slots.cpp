// Each number is a socket's name: the kernel gives a name to one process only, and takes it back from one that died.
// SPDX-License-Identifier: MIT
#include "grader/class/slots.hpp"

#include <cstddef>
#include <cstring>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>

namespace grader {

namespace {

constexpr int first = 1, last = 498;  // 0 is who grades one submission, 499 tries the walls

bool claim(const Descriptor& socket, int number) {
    const std::string name = "lambert-lab/grade/" + std::to_string(number);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;  // the name's first byte is 0: it is no file
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    return bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), size) == 0;
}

}  // namespace

Slots::Slots(int count) {
    for (int number = first; number <= last && numbers_.size() < static_cast<std::size_t>(count); ++number) {
        Descriptor file(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
        if (file.open() && claim(file, number)) {
            numbers_.push_back(number);
            held_.push_back(std::move(file));
        }
    }
    for (int number = first; numbers_.size() < static_cast<std::size_t>(count); ++number)
        numbers_.push_back(number);
}

}  // namespace grader
