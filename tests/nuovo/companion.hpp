// What slides.json says beside code: the ideas, pictures, questions and errata that slides_refs/README.md shows.
// SPDX-License-Identifier: MIT
#pragma once

#include "input.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace nuovo {

/// The same in both languages.
struct BothLanguages {
    std::string it;
    std::string en;
};

/// A line of some file, found by what it says, so that it may move.
struct CodeLine {
    std::string file;  ///< from the repository's root, as "shaders/terms/clamp.glsl"
    std::string code;  ///< stands in exactly one line of it
};

/// A picture that a program of the lab draws.
struct Picture {
    std::string file;  ///< in slides_refs/pictures
    std::string
        command;  ///< program and options, words between blanks; without --frame, --size and --renderer
    std::string size;  ///< "240x240"
    BothLanguages alt;  ///< what one sees
    bool isAnswer = false;  ///< shown with the answer, not before
};

/// One slide with text.
struct CompanionSlide {
    int number = 0;  ///< as printed on it
    BothLanguages title;
    BothLanguages says;
    std::string equation;  ///< plain text; empty where the slide has none
    std::vector<std::string> lessons;  ///< program names
    std::vector<std::string> terms;  ///< as --terms calls them
    std::vector<std::string> views;  ///< options ("--space view") and keys ("key V") that show it
    std::vector<CodeLine> lines;  ///< beside its NUOVO lines and its terms
    std::vector<Picture> pictures;
    BothLanguages question;
    BothLanguages answer;
};

/// What a slide should have said.
struct Erratum {
    std::vector<int> slides;  ///< ascending
    std::string kind;
    BothLanguages says;
    BothLanguages shouldSay;
    BothLanguages reason;
};

/// All of it.
struct Companion {
    std::filesystem::path file;
    std::vector<CompanionSlide> slides;
    std::map<std::string, CodeLine> termLines;  ///< by term: where the shaders write it
    std::map<std::string, BothLanguages> kinds;  ///< of errata
    std::vector<Erratum> errata;
    std::vector<Picture> otherPictures;  ///< for other pages, without alt
    std::vector<std::string> picturesElsewhere;  ///< files that other scripts make
};

/// Reads slides.json. Throws InputError, which names the field.
Companion readCompanion(const std::filesystem::path& file);

/// Every picture once, sorted by file: those of slides and other pages, and NAME.png for each lesson and interlude, 320x320.
/// Throws InputError where one file has two commands, or one that another script makes.
std::vector<Picture> picturesToDraw(const Companion& companion, const LessonSet& lessons);

}  // namespace nuovo
