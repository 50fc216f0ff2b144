// Open files that close themselves.
// SPDX-License-Identifier: MIT
#include "grader/confine/descriptor.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

namespace grader {

namespace {

// 0, 1 and 2 are given anew to what is started, and so may be none of these.
Descriptor owned(int number, const char* what) {
    if (number >= 0 && number < 3) {
        const int higher = ::fcntl(number, F_DUPFD_CLOEXEC, 3);
        ::close(number);
        number = higher;
    }
    if (number < 0) {
        throw std::runtime_error(std::string("cannot open ") + what + ": " + std::strerror(errno));
    }
    return Descriptor(number);
}

}  // namespace

void Descriptor::close() {
    if (number_ >= 0) {
        ::close(std::exchange(number_, -1));
    }
}

Descriptor inMemory(const std::string& bytes) {
    Descriptor file = owned(::memfd_create("grader", MFD_CLOEXEC), "a file in memory");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t wrote = ::write(file.number(), bytes.data() + done, bytes.size() - done);
        if (wrote <= 0) {
            throw std::runtime_error(std::string("cannot fill a file in memory: ") + std::strerror(errno));
        }
        done += static_cast<std::size_t>(wrote);
    }
    ::lseek(file.number(), 0, SEEK_SET);
    return file;
}

std::pair<Descriptor, Descriptor> makePipe() {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) {
        throw std::runtime_error(std::string("cannot open a pipe: ") + std::strerror(errno));
    }
    Descriptor read = owned(ends[0], "a pipe");
    return {std::move(read), owned(ends[1], "a pipe")};
}

Descriptor nothing() { return owned(::open("/dev/null", O_RDWR | O_CLOEXEC), "/dev/null"); }

}  // namespace grader
