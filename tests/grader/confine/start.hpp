// Starting grade_inside behind its walls, and gathering what comes back. Internal to grader/confine.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/confine.hpp"
#include "grader/confine/descriptor.hpp"
#include "grader/confine/wire.hpp"

#include <optional>
#include <sys/types.h>

namespace grader {

/// A program to start. {job} and {result} among its words become the numbers of those descriptors.
struct Start {
    std::vector<std::string> command;
    std::vector<std::string> environment;
    std::vector<Descriptor> files;  ///< open in it under the same numbers
    std::optional<uid_t> user;  ///< to become first
};

/// What came back over the pipes, before anything of it is believed.
struct Gathered {
    std::string said;
    bool saidMore = false;
    std::string result;
    bool late = false;  ///< it had to be killed from here
};

/// Who runs a job: where we are root, a user that no file belongs to and that no other grader has while this exists.
class Lease {
  public:
    /// Looks from the slot's on. Throws std::runtime_error if all are taken.
    explicit Lease(int slot);
    std::optional<uid_t> user() const { return user_; }

  private:
    std::optional<uid_t> user_;
    Descriptor mark_;
};

/// What a program needs of the machine: compiler, libraries, drivers. Not all of /usr: a lab may be installed in it.
const std::vector<std::string>& systemFolders();
/// The bytes of lib/lambert-lab/grade_inside. Throws std::runtime_error.
const std::string& gradeInside();
/// The words with {root} replaced.
std::vector<std::string> rooted(const std::vector<std::string>& words, const std::string& root);

/// Says all of the job that grade_inside needs to know; `readable` is for Landlock.
std::string taskOf(const Job& job, Walls walls, const std::string& root, std::optional<uid_t> user,
                   const std::vector<std::string>& readable);

/// In namespaces of its own.
Gathered runInBubblewrap(const Job& job, int slot);
/// In a private folder.
Gathered runInFolder(const Job& job, Walls walls, int slot);
/// Starts it, reads to the end or until it is late.
Gathered gather(Start start, const std::string& task, const Job& job);
/// Reads what grade_inside sent; every number of it is checked.
void readResult(const Gathered& gathered, const Job& job, Outcome& outcome);

}  // namespace grader
