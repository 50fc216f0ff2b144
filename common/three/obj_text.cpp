// Wavefront .obj and .mtl as text: checked line by line before tinyobjloader reads them.
// SPDX-License-Identifier: MIT
#include "three/obj_text.hpp"

#include "three/geometries.hpp"
#include "three/scene_file.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace THREE {

namespace {

constexpr std::size_t mostCorners = 1000;  // cutting a polygon into triangles takes the cube of this

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t begin = 0;
    while ((begin = line.find_first_not_of(" \t", begin)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

// Calls `read` with the words of every line that is not empty and no comment. Lines end as they do for tinyobjloader: at
// \n, \r\n or \r.
template <class Read>
void forEachLine(std::string_view text, Read read) {
    std::size_t number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        ++number;
        const std::vector<std::string_view> words = wordsOf(text.substr(0, end));
        if (!words.empty() && words[0][0] != '#')
            read(words, number);
        text.remove_prefix(text.substr(end).starts_with("\r\n") ? end + 2 : std::min(end + 1, text.size()));
    }
}

// The words again as a line: tinyobjloader reads exactly what was checked.
void appendLine(std::string& text, const std::vector<std::string_view>& words) {
    for (const std::string_view word : words)
        text.append(word).append(" ");
    text.back() = '\n';
}

class Checker {
  public:
    explicit Checker(const std::string& file) : file_(file) {}

    void number(std::string_view word, std::size_t line) const {
        if (word.starts_with('+'))
            word.remove_prefix(1);
        double x = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
        if (error != std::errc() || end != word.data() + word.size() || !(std::abs(x) <= largestNumber))
            fail(line, "a number of at most 1e36", word);
    }
    void numbers(const std::vector<std::string_view>& words, std::size_t atLeast, std::size_t line) const {
        if (words.size() < atLeast + 1)
            fail(line, std::to_string(atLeast) + " numbers after " + std::string(words[0]),
                 std::to_string(words.size() - 1));
        for (std::size_t i = 1; i < words.size(); ++i)
            number(words[i], line);
    }
    [[noreturn]] void fail(std::size_t line, const std::string& expected, std::string_view found) const {
        throw SceneError(file_ + ": line " + std::to_string(line) + ": expected " + expected + ", found " +
                         printable(found));
    }

  private:
    const std::string& file_;
};

// Vertices, texture coordinates and normals: how many there are, and the highest number that a face asked for.
struct List {
    const char* keyword;
    long long count = 0;
    long long highest = 0;
    std::size_t highestLine = 0;
};

class ObjChecker {
  public:
    explicit ObjChecker(const std::string& file) : check_(file) {}

    void line(const std::vector<std::string_view>& words, std::size_t number) {
        const std::string_view keyword = words[0];
        if (words.back().ends_with('\\'))
            check_.fail(number, "each statement on one line", "a line continued by a backslash");
        if (isOneOf(keyword, {"v", "vt", "vn"})) {
            coordinates(words, number);
        } else if (keyword == "f") {
            face(words, number);
        } else if (isOneOf(keyword, {"l", "p"})) {
            note(result.notes, "lines and points (l, p) are left out: only faces are drawn");
            return;
        } else if (isOneOf(keyword, {"vp", "vw", "bevel", "c_interp", "d_interp", "lod", "mg", "shadow_obj",
                                     "trace_obj", "maplib", "usemap"})) {
            return;
        } else if (keyword == "s") {
            result.hasSmoothing = true;
        } else if (!isOneOf(keyword, {"o", "g", "usemtl", "mtllib"})) {
            check_.fail(
                number,
                "a Wavefront keyword such as v, vn, f or usemtl (free-form surfaces are not supported)",
                keyword);
        }
        appendLine(result.text, words);
    }

    void finish(const std::string& file) {
        for (const List& list : lists_)
            if (list.highest > list.count)
                check_.fail(list.highestLine,
                            "a number up to " + std::to_string(list.count) + ", how many lines " +
                                list.keyword + " there are",
                            std::to_string(list.highest));
        if (faces_ == 0)
            throw SceneError(file + ": expected faces (lines that begin with f), found none; is it a mesh?");
    }

    static void note(std::vector<std::string>& notes, const std::string& text) {
        if (std::find(notes.begin(), notes.end(), text) == notes.end())
            notes.push_back(text);
    }

    ObjText result;

  private:
    void coordinates(const std::vector<std::string_view>& words, std::size_t number) {
        const bool isTexture = words[0] == "vt";
        check_.numbers(words, isTexture ? 1 : 3, number);
        List& list = lists_[words[0] == "v" ? 0 : isTexture ? 1 : 2];
        if (static_cast<double>(++list.count) > maxVertices)
            check_.fail(number, "at most 50 million vertices", "one more");
        if (words[0] == "v" && words.size() >= 7)
            note(result.notes, "colours per vertex are left out: the material's colour counts");
    }

    void face(const std::vector<std::string_view>& words, std::size_t number) {
        ++faces_;
        if (words.size() < 4 || words.size() > mostCorners + 1)
            check_.fail(number, "a face of 3 to 1000 corners", std::to_string(words.size() - 1) + " corners");
        for (std::size_t i = 1; i < words.size(); ++i)
            corner(words[i], number);
    }

    // i, i/j, i//k or i/j/k; 1 is the first, -1 the latest.
    void corner(std::string_view word, std::size_t number) {
        std::string_view rest = word;
        for (std::size_t part = 0; part < 3; ++part) {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const std::string_view digits = rest.substr(0, slash);
            const bool mayBeMissing = part == 1 && slash < rest.size();
            if (!(digits.empty() && mayBeMissing))
                reference(digits, lists_[part], word, number);
            if (slash == rest.size())
                return;
            rest.remove_prefix(slash + 1);
        }
        check_.fail(number, "a corner as v, v/vt, v//vn or v/vt/vn", word);
    }

    void reference(std::string_view digits, List& list, std::string_view word, std::size_t number) {
        long long index = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (error != std::errc() || end != digits.data() + digits.size() || index == 0)
            check_.fail(number, "a corner as v, v/vt, v//vn or v/vt/vn, counted from 1", word);
        if (index < -list.count || index > 2147483647)
            check_.fail(number,
                        "a corner whose numbers exist (" + std::to_string(list.count) + " lines " +
                            list.keyword + " so far)",
                        word);
        if (index > list.highest) {
            list.highest = index;
            list.highestLine = number;
        }
    }

    Checker check_;
    std::array<List, 3> lists_{List{"v"}, List{"vt"}, List{"vn"}};
    std::size_t faces_ = 0;
};

}  // namespace

ObjText checkObj(const std::string& text, const std::string& file) {
    ObjChecker checker(file);
    forEachLine(text, [&](const std::vector<std::string_view>& words, std::size_t number) {
        checker.line(words, number);
    });
    checker.finish(file);
    return std::move(checker.result);
}

ObjText checkMtl(const std::string& text, const std::string& file) {
    ObjText result;
    const Checker check(file);
    forEachLine(text, [&](const std::vector<std::string_view>& words, std::size_t number) {
        const std::string_view keyword = words[0];
        if (isOneOf(keyword, {"Kd", "Ke", "Ks"}))
            check.numbers(words, 3, number);
        if (isOneOf(keyword, {"d", "Tr", "Ns", "illum"}))
            check.numbers(words, 1, number);
        if (keyword.starts_with("map_"))
            ObjChecker::note(result.notes, file + ": textures (map_...) are left out");
        if (isOneOf(keyword, {"d", "Tr"}))
            ObjChecker::note(result.notes, file + ": transparency (d, Tr) is left out");
        if (!isOneOf(keyword, {"newmtl", "Kd", "Ke", "Ks", "Ns", "illum"}))
            return;
        appendLine(result.text, words);
        // A material without Kd is white, one without Ns has three.js's exponent; tinyobjloader would have them black and 1.
        if (keyword == "newmtl")
            result.text += "Kd 1 1 1\nNs 30\n";
    });
    return result;
}

}  // namespace THREE
