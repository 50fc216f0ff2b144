// What the tool reads from disk: the lessons' directory and slides.json.
// SPDX-License-Identifier: MIT
#pragma once

#include "lesson_file.hpp"

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace nuovo {

/// Input that cannot be read or understood; the message says what, where and what to do. Exit status 4.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The lessons' directory: the chain by number, then every other .cpp file.
struct LessonSet {
    std::vector<Lesson> chain;  ///< lesson_NN_name.cpp, sorted by number, then by name
    std::vector<Lesson>
        others;  ///< interludes, scene_viewer, and lesson_* files that are not named as the chain is
};

/// One piece of code on a slide, as `slides[].code[]` of slides.json has it.
struct CodeItem {
    std::string item;  ///< as a tag names it: "36.1"
    std::string lesson;  ///< the stem of the lesson that has its lines
    std::vector<std::string> cpp;  ///< its lines in C++, in order
};

/// A slide's title by language ("it", "en"); empty where slides.json has none.
using Titles = std::map<std::string, std::string>;

/// What the rules need of slides.json.
struct Slides {
    std::filesystem::path file;
    std::map<int, Titles> titles;  ///< by the number printed on the slide
    std::vector<CodeItem> items;  ///< in the file's order

    /// The item of this name; null when no slide has it.
    const CodeItem* find(std::string_view item) const;
};

/// The text of a regular file of at most `limit` bytes. Throws InputError.
std::string readText(const std::filesystem::path& file, std::size_t limit);
/// Reads the .cpp files of `directory`, not below it. Throws InputError: no directory, no lesson, no access.
LessonSet readLessons(const std::filesystem::path& directory);
/// Reads slides.json. Throws InputError: unreadable, no JSON, a field missing or of the wrong type, a slide
/// or item twice, an item of another slide.
Slides readSlides(const std::filesystem::path& file);
/// The same from text; `file` is for messages.
Slides parseSlides(const std::filesystem::path& file, std::string_view text);

}  // namespace nuovo
