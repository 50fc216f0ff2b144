// Makes starters: a lesson without its step, to be completed by a student, in a folder that builds against the lab.
// SPDX-License-Identifier: MIT
#pragma once

#include "starter_tasks.hpp"

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace nuovo {

/// A lesson that does not exist or has nothing to complete. Exit status 2.
class NoStarter : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A folder that cannot be written. Exit status 5.
class FolderError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Files by their path below a folder.
using Folder = std::map<std::string, std::string>;

/// The lesson that is meant, as lessons/run understands it: a name, a part of one, or a number. Throws NoStarter, listing
/// the lessons, unless it is exactly one, and of the chain, and not the first.
const Lesson& findStarter(const LessonSet& lessons, const std::string& asked);

/// The files of a starter in a language, "it" or "en": the lesson with TODOs, CMakeLists.txt, README.md, and the terms of
/// its shader exercises as neutral elements. `shaders` is the lab's folder. Throws InputError.
Folder makeStarter(const Lesson& lesson, const std::filesystem::path& tasks,
                   const std::filesystem::path& shaders, const std::string& lang);

/// Writes the folder: all of it or, with a FolderError, nothing. It must be new or empty.
void writeFolder(const Folder& folder, const std::filesystem::path& directory);

}  // namespace nuovo
