// An open file that closes itself, and files that lie in memory only.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

namespace grader {

/// Owns a file descriptor. None of them reaches a program that is started, unless it is told to.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    bool open() const { return number_ >= 0; }
    void close();

  private:
    int number_ = -1;
};

/// A file without a name that holds these bytes and stands at its beginning. Throws std::runtime_error.
Descriptor inMemory(const std::string& bytes);
/// Both ends of a pipe: to read, to write. Throws std::runtime_error.
std::pair<Descriptor, Descriptor> makePipe();
/// /dev/null, for both.
Descriptor nothing();

}  // namespace grader
