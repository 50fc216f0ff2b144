// Failure: whatever goes wrong, as the status that the command line promises and one message.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace lab {

/// A program's exit status.
enum Status { done = 0, wrongUsage = 2, noRenderer = 3, unusableScene = 4, cannotWrite = 5 };

/// What the command line or a line of --frames-from asks for cannot be meant.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What went wrong.
struct Failure {
    Status status;
    std::string message;  ///< what, where, expected and found, what to do next
};

/// The message, with the scene file's name before it where the file is what is wrong.
inline std::string messageOf(const Failure& failure, const std::string& sceneFile) {
    const bool file = failure.status == unusableScene && !sceneFile.empty();
    return (file ? sceneFile + ": " : "") + failure.message;
}

/// Does `work`; what it throws becomes a Failure.
std::optional<Failure> attempt(const std::function<void()>& work);

}  // namespace lab
