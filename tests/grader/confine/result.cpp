// Reads what came back from inside. It is taken for what anybody may have sent.
// SPDX-License-Identifier: MIT
#include "grader/confine/start.hpp"

#include <csignal>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace grader {

namespace {

class Bytes {
  public:
    explicit Bytes(const std::string& all) : all_(all) {}

    std::string take(std::uint64_t count) {
        if (count > all_.size() - at_) {
            throw std::runtime_error("what came back from inside ends too soon");
        }
        at_ += count;
        return all_.substr(at_ - count, count);
    }
    template <typename T>
    T head() {
        T value;
        std::memcpy(static_cast<void*>(&value), take(sizeof(T)).data(), sizeof(T));
        return value;
    }
    bool atEnd() const { return at_ == all_.size(); }

  private:
    const std::string& all_;
    std::size_t at_ = 0;
};

std::string megabytes(std::uint64_t bytes) {
    std::ostringstream text;
    text << static_cast<double>(bytes >> 10) / 1024 << " MB";
    return text.str();
}

std::string inWords(wire::Limit limit, const Limits& limits) {
    std::ostringstream text;
    switch (limit) {
    case wire::Limit::clock:
        text << "more than " << limits.wallSeconds << " s on the clock";
        break;
    case wire::Limit::processor:
        text << "more than " << limits.cpuSeconds << " s of processor time";
        break;
    case wire::Limit::memory:
        text << "more than " << megabytes(limits.memoryBytes) << " of memory";
        break;
    case wire::Limit::folder:
        text << "wrote more than " << megabytes(limits.fileBytes) << " to a file or "
             << megabytes(limits.folderBytes) << " in all";
        break;
    case wire::Limit::files:
        text << "made more than " << limits.files << " files";
        break;
    case wire::Limit::none:
        break;
    }
    return text.str();
}

Returned readFile(Bytes& bytes, const Wanted& wanted) {
    const auto head = bytes.head<wire::FileHead>();
    Returned file;
    const auto wrongSize = [&] {
        return "is " + std::to_string(head.number) + " bytes long, expected " +
               (wanted.exactly ? "" : "at most ") + std::to_string(wanted.bytes);
    };
    switch (head.file) {
    case wire::File::here:
        if (wanted.exactly ? head.number != wanted.bytes : head.number > wanted.bytes) {
            throw std::runtime_error("what came back from inside " + wrongSize());
        }
        file.bytes = bytes.take(head.number);
        return file;
    case wire::File::missing:
        file.problem = "was not written";
        return file;
    case wire::File::link:
        file.problem = "is a symbolic link";
        return file;
    case wire::File::hardLink:
        file.problem = "has other names (hard links)";
        return file;
    case wire::File::notPlain:
        file.problem = "is no plain file (a folder, a pipe, a socket or a device)";
        return file;
    case wire::File::foreign:
        file.problem = "belongs to another user";
        return file;
    case wire::File::size:
        file.problem = wrongSize();
        return file;
    case wire::File::unreadable:
        file.problem =
            std::string("cannot be read: ") + std::strerror(static_cast<int>(head.number & 0xFFFF));
        return file;
    }
    throw std::runtime_error("what came back from inside names no kind of file that there is");
}

void readParts(const std::string& result, const Job& job, Outcome& outcome) {
    Bytes bytes(result);
    const auto head = bytes.head<wire::Head>();
    const wire::Head expected;
    if (std::memcmp(head.magic, expected.magic, sizeof(head.magic)) != 0 || head.end > wire::End::trouble ||
        head.limit > wire::Limit::files) {
        throw std::runtime_error("what came back from inside has another form");
    }
    const std::string text = bytes.take(head.textBytes);
    if (head.end == wire::End::trouble) {
        throw std::runtime_error(text);
    }
    for (const Wanted& wanted : job.wanted) {
        outcome.files.push_back(readFile(bytes, wanted));
    }
    if (!bytes.atEnd()) {
        throw std::runtime_error("more came back from inside than was wanted");
    }
    const bool timeIsUp = head.limit == wire::Limit::clock || head.limit == wire::Limit::processor;
    outcome.how = timeIsUp ? Ended::outOfTime : head.end == wire::End::exited ? Ended::exited : Ended::killed;
    outcome.status = head.status;
    outcome.limit = inWords(head.limit, job.limits);
}

}  // namespace

void readResult(const Gathered& gathered, const Job& job, Outcome& outcome) {
    outcome.said = harmless(gathered.said);
    outcome.saidMore = gathered.saidMore;
    try {
        if (gathered.late) {
            throw std::runtime_error(
                "nothing came back from inside although the command's time was long over");
        }
        if (gathered.result.empty()) {
            throw std::runtime_error("the confinement did not start: " +
                                     (outcome.said.empty() ? "it said nothing" : outcome.said));
        }
        readParts(gathered.result, job, outcome);
    } catch (const std::exception& error) {
        outcome.how = Ended::notStarted;
        outcome.status = 0;
        outcome.trouble = harmless(error.what());
        outcome.files.assign(job.wanted.size(), {"", "was not written"});
    }
}

}  // namespace grader
