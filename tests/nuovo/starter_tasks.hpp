// Reads tasks.json: what a starter says in place of the lines that it takes away.
// SPDX-License-Identifier: MIT
#pragma once

#include "input.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace nuovo {

/// A text by language: "it", "en"; reading makes sure that both are there.
using ByLanguage = std::map<std::string, std::string>;

/// NUOVO lines of a lesson that belong together. A run ends at an old line, at another tag, and before a comment that
/// opens the next run. Blank lines inside belong to it.
struct NewRun {
    Citation cites;
    std::size_t begin = 0;  ///< index into Lesson::lines
    std::size_t end = 0;  ///< behind the last NUOVO line
};

/// The runs of a lesson, in order.
std::vector<NewRun> runsOf(const Lesson& lesson);

/// What is to be done in one lesson.
struct LessonTasks {
    std::vector<ByLanguage> runs;  ///< one for each of runsOf()
    std::map<std::string, ByLanguage> terms;  ///< shader exercises: what to write, by the name of the term
};

/// The tasks of a lesson, read from tasks.json. Throws InputError, with the place in the file, if one is missing in a
/// language, or a tag has more or fewer texts than the lesson has runs of it.
LessonTasks readTasks(const std::filesystem::path& file, const Lesson& lesson);

}  // namespace nuovo
