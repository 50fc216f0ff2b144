// Reads lesson files into lines with their NUOVO and PRIMA marks, and undoes the marks.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The marks, exactly (anything that resembles one and is none is reported):
//
//     <code>  // NUOVO <slide>[.<item>]   a line that this lesson adds; comment lines are tagged alike
//     // PRIMA <old line>                 what the NUOVO line just above replaces, from the previous lesson
//
// A PRIMA comment stands at the indentation of the old line: it restores to its own indentation followed by
// all that comes after "// PRIMA ", so further blanks there are further indentation. Several old lines take
// as many PRIMA lines, one below the other.
namespace nuovo {

/// What a tag names: a slide (1..9999, as printed on it) and one of its numbered code items, 0 for none.
struct Citation {
    int slide = 0;
    int item = 0;
    friend bool operator==(const Citation&, const Citation&) = default;
};

/// "36" or "36.3".
std::string toString(const Citation& citation);
/// Reads exactly "36" or "36.3" (no blanks, no leading zero); nothing otherwise.
std::optional<Citation> parseCitation(std::string_view text);

/// From `first` to `last`, both included; a slide without an item stands for all its items.
struct SlideRange {
    Citation first;
    Citation last;
    bool contains(const Citation& citation) const;
};

/// "16-30", "36.3-36.4" or "38".
std::string toString(const SlideRange& range);

enum class LineKind {
    Header,  ///< of the leading run of // comments; no part of the promise
    Blank,  ///< empty or blanks only; no part of the promise
    Same,  ///< without a mark: the previous lesson has it too
    New,  ///< tagged NUOVO
    Old,  ///< a PRIMA comment
    Faulty  ///< resembles a mark but is none; stands as it is, and `problem` says why
};

/// One line of a lesson file.
struct Line {
    int number = 0;  ///< from 1
    LineKind kind = LineKind::Same;
    std::string raw;  ///< as in the file, without the line end
    std::string code;  ///< without its mark: for New the text before the tag, for Old the old line, else raw
    Citation cites;  ///< of a New line
    std::string problem;  ///< of a Faulty line
};

/// One .cpp file of the lessons' directory.
struct Lesson {
    std::filesystem::path file;
    std::string stem;  ///< lesson_03_point_light
    int number = -1;  ///< 3; -1 for what is not of the chain
    std::string title;  ///< the header's first line, without the stem before its colon; may be empty
    std::vector<SlideRange> slides;  ///< the header's line "Slides 16-30, 36.3-36.4"; empty when it has none
    std::vector<Line> lines;

    /// How many lines are of this kind.
    int count(LineKind kind) const;
};

/// A lesson's line after its marks were undone; `number` is where it stands in the file.
struct PlainLine {
    int number = 0;
    std::string text;
};

/// The lesson as the next one finds it: tags taken off; PRIMA, header and blank lines left out.
std::vector<PlainLine> plain(const Lesson& lesson);
/// The lesson before its step: NUOVO lines left out, PRIMA lines restored, header and blank lines left out.
std::vector<PlainLine> before(const Lesson& lesson);

/// `text` with `stem`, where it is a whole word, replaced by a neutral mark: lessons may say their own name.
std::string withoutOwnName(std::string_view text, std::string_view stem);
/// Where the line's // comment starts, outside quotes; npos when it has none.
std::size_t commentStart(std::string_view code);
/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// NN of the stem lesson_NN_name; -1 for any other.
int chainNumber(std::string_view stem);
/// Reads a lesson's text; never fails, what is wrong with it ends in Faulty lines.
Lesson parseLesson(const std::filesystem::path& file, std::string_view text);

}  // namespace nuovo
