// Creates, removes and renames the temporary file that a frame is written to.
// SPDX-License-Identifier: MIT
#include "image/temporary_file.hpp"

#include "image/frame.hpp"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace image {

namespace {

// Process id and counter keep apart the processes and threads that write to one directory. The name does not
// grow from the target's, which may already be as long as names can be.
std::filesystem::path uniqueName(const std::filesystem::path& directory) {
    static std::atomic<unsigned> counter = 0;
    const std::string number = std::to_string(counter.fetch_add(1));
    return directory / (".lambert-" + std::to_string(::getpid()) + "-" + number + ".tmp");
}

}  // namespace

std::string systemReason(int error) { return std::generic_category().message(error); }

void throwWriteError(int error) {
    throw Error(systemReason(error) +
                " while writing; expected room for the whole picture; free space on that disk or " +
                "choose another directory");
}

TemporaryFile::TemporaryFile(std::filesystem::path target) : target_(std::move(target)) {
    const std::filesystem::path directory = target_.has_parent_path() ? target_.parent_path() : ".";
    int descriptor = -1;
    do {  // a file of this name can only be left over from a killed process that had our id
        name_ = uniqueName(directory);
        descriptor = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
    if (descriptor < 0) {
        const int error = errno;
        throw Error(systemReason(error) + "; expected a directory '" + directory.string() +
                    "' that you may write to; create it or choose another");
    }
    stream_ = ::fdopen(descriptor, "wb");
    if (stream_ == nullptr) {
        const int error = errno;
        ::close(descriptor);
        ::unlink(name_.c_str());
        throwWriteError(error);
    }
}

TemporaryFile::~TemporaryFile() {
    if (stream_ != nullptr) {
        std::fclose(stream_);
    }
    if (!name_.empty()) {
        ::unlink(name_.c_str());
    }
}

void TemporaryFile::commit() {
    // fclose flushes: what did not fit the disk shows here at the latest.
    if (std::fclose(std::exchange(stream_, nullptr)) != 0) {
        throwWriteError(errno);
    }
    if (::rename(name_.c_str(), target_.c_str()) != 0) {
        const int error = errno;
        throw Error(systemReason(error) +
                    " while naming the finished file; expected a name that can be replaced; " +
                    "choose another name or directory");
    }
    name_.clear();
}

}  // namespace image
