// The texts of a starter: the lesson without its new lines, its CMake file, its README, and shader terms to be written.
// SPDX-License-Identifier: MIT
#pragma once

#include "starter_tasks.hpp"

#include <string>
#include <string_view>

namespace nuovo {

/// The lesson before its step, with a TODO comment where each run of NUOVO lines stood, in that language ("it" or "en").
std::string starterLesson(const Lesson& lesson, const LessonTasks& tasks, const std::string& lang);

/// A shader term to be written: in each `#if TERM_X ... #else ... #endif` what stands before the #else gives way to a copy
/// of what stands after it (nothing, if there is no #else), so that the term is its neutral element whether it is switched
/// on or off. The last of these places gets the TODO; others without an #else, which hold helpers, vanish. Throws
/// InputError, naming `file`, if there is no such place or one that this rule does not fit.
std::string starterTerm(std::string_view glsl, const std::string& term, const std::string& todo,
                        const std::string& file);

/// The CMakeLists.txt and the README.md of a starter.
std::string starterCMake(const Lesson& lesson, const std::string& lang);
std::string starterReadme(const Lesson& lesson, const LessonTasks& tasks, const std::string& lang);

/// `text` as comment lines of at most 100 columns: the first begins with `first`, the others are further in.
std::string commented(const std::string& indent, const std::string& first, std::string_view text);
/// `text` with plain blanks for the no-break ones that keep a formula on one line.
std::string withPlainBlanks(std::string text);

}  // namespace nuovo
