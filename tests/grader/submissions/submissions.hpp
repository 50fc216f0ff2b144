// What students would hand in: for each row of the catalogue the shader files, or the lesson, that draw its equation.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// Complete files by name: "terms/clamp.glsl", or "lesson_02_directional_light.cpp".
using Files = std::map<std::string, std::string>;

/// Gives the text of a file by its name. Throws std::runtime_error if there is none.
using ReadFile = std::function<std::string(const std::string&)>;

/// Changes files as an .edit text says, line by line:
///
///     # a comment
///     file terms/clamp.glsl
///     - return max(0.0, cosine);
///     + return cosine;
///
/// "-" lines must stand in the file exactly once, one after the other; the "+" lines after them take their place, as far to
/// the right. Blanks at the beginning and the end of a line do not count. An empty line ends a change. `files` are changed where
/// they have a file of that name, else `original` gives it. Throws std::runtime_error with `name`, line, and what was expected.
Files edited(Files files, std::string_view edit, const std::string& name, const ReadFile& original);

/// The shader files, named from the shaders' folder, of a student with this misconception (of the catalogue's id), or with
/// a right equation of his own: those of submissions/terms/ID, changed as terms/ID.edit says, which may begin with "from OTHER".
/// Throws std::runtime_error: no such id, or an edit that does not fit the lab's shaders any more.
Files shaderSubmission(const std::string& id);
/// The ids that shaderSubmission() knows, sorted.
std::vector<std::string> shaderSubmissions();

/// The same for wrong shaders that are no row of the catalogue, though some come near one: nothing explains them.
Files unnamedSubmission(const std::string& name);
std::vector<std::string> unnamedSubmissions();

/// The same for lessons: files of lessons/.
Files lessonSubmission(const std::string& id);
std::vector<std::string> lessonSubmissions();

/// The rows of the catalogue that no shader of a student can draw, and why.
const std::map<std::string, std::string>& cannotBeWritten();

}  // namespace grader
