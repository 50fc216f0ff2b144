// slides_refs/README.md: the parts of it that follow from slides.json, the lessons and the shaders.
// SPDX-License-Identifier: MIT
#pragma once

#include "companion.hpp"

#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>

namespace nuovo {

/// The parts by name: "lines" (slide -> line of code), "slides" (the companion), "errata".
/// `root` is the repository: the line of every CodeLine is looked for in its file there. Throws InputError where a file
/// has no such line, or several.
std::map<std::string, std::string> refsBlocks(const Companion& companion, const LessonSet& lessons,
                                              const std::filesystem::path& root);

/// `readme` with each part in its place: between the lines `<!-- nuovo refs: NAME -->` and `<!-- end of NAME -->`.
/// Throws InputError, which names `file`, where such a line is missing, stands twice, or is unknown.
std::string renewed(const std::filesystem::path& file, std::string_view readme,
                    const std::map<std::string, std::string>& blocks);

/// Renews `readme`, or, with `isCheck`, only compares it. Returns the first line that differs, 0 if none did.
/// The repository is the folder above the one that `readme` stands in. Throws InputError; std::runtime_error where it
/// cannot be written.
int renewReadme(const Companion& companion, const LessonSet& lessons, const std::filesystem::path& readme,
                bool isCheck);

/// One line a picture: its file, a tab, and the command with its --size; nothing after the tab where another script draws it.
void printPictures(const Companion& companion, const LessonSet& lessons, std::ostream& out);

/// The number of the only line of `file` that contains `code`. Throws InputError where there is none, or several.
int lineOf(const std::filesystem::path& file, std::string_view code);

}  // namespace nuovo
