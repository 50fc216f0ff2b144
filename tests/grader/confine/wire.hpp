// What the grader and grade_inside say to each other: a job in, an end and some files back.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace grader::wire {

/// Which limit ended a command.
enum class Limit : std::uint8_t { none, clock, processor, memory, folder, files };

/// How the command ended. `trouble`: it could not be started; `status` is then an errno and a text follows.
enum class End : std::uint8_t { exited, killed, trouble };

/// What became of a wanted file. `unreadable`: `number` is an errno; `size`: `number` is how long it is.
enum class File : std::uint8_t { here, missing, link, hardLink, notPlain, size, foreign, unreadable };

/// The first thing that comes back: these bytes, then a text of `textBytes`, then a FileHead and bytes for each file.
struct Head {
    char magic[4] = {'L', 'L', 'G', '1'};
    End end = End::trouble;
    Limit limit = Limit::none;
    std::uint16_t textBytes = 0;
    std::int32_t status = 0;
};

/// Before each file: `number` is its length, unless File says what else.
struct FileHead {
    File file = File::missing;
    std::uint8_t unused[7] = {};
    std::uint64_t number = 0;
};

/// The job on its way in: texts and numbers, each ended by a NUL.
class Writer {
  public:
    void text(const std::string& value) { text_.append(value).push_back('\0'); }
    void number(std::uint64_t value) { text(std::to_string(value)); }
    void list(const std::vector<std::string>& values) {
        number(values.size());
        for (const std::string& value : values) {
            text(value);
        }
    }
    const std::string& bytes() const { return text_; }

  private:
    std::string text_;
};

/// The same, read. Throws std::runtime_error if it ends too soon.
class Reader {
  public:
    explicit Reader(std::string bytes) : bytes_(std::move(bytes)) {}

    std::string text() {
        const std::size_t end = bytes_.find('\0', at_);
        if (end == std::string::npos) {
            throw std::runtime_error("the job ends too soon");
        }
        std::string value = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return value;
    }
    std::uint64_t number() { return std::stoull(text()); }
    std::vector<std::string> list() {
        std::vector<std::string> values(number());
        for (std::string& value : values) {
            value = text();
        }
        return values;
    }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

}  // namespace grader::wire
