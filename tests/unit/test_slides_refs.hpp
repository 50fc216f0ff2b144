// What the tests of slides_refs/ share: slides.json, the files beside it, and what must be there in both languages.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace slides_refs {

using nlohmann::json;
using Strings = std::vector<std::string>;

inline const std::string root = LAMBERT_SOURCE_DIR;

// The slides whose text says something; the others of 1-45 are title pages, pictures, or missing from the extract.
inline const std::vector<int> slidesWithText{3,  4,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18,
                                             20, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32,
                                             33, 34, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45};

inline const std::map<std::string, int> termKeys{{"albedo", 1},      {"cosine", 2},      {"clamp", 3},
                                                 {"light_color", 4}, {"attenuation", 5}, {"directional", 6},
                                                 {"point", 7},       {"ambient", 8},     {"specular", 9}};

inline std::string readText(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("cannot read " + path);
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

inline const json& refs() {
    static const json document = json::parse(readText(root + "/slides_refs/slides.json"));
    return document;
}

/// The slide of this number; fails the test if there is none.
inline json slideOf(int number) {
    for (const json& slide : refs().at("slides")) {
        if (slide.at("number") == number) {
            return slide;
        }
    }
    ADD_FAILURE() << "slides.json has no slide " << number;
    return json::object();
}

inline std::string slideName(const json& slide) { return "slide " + slide.at("number").dump(); }

/// Lessons and interludes by name, with their text: what stands in lessons/, whatever it is. scene_viewer is none.
inline const std::map<std::string, std::string>& lessonTexts() {
    static const std::map<std::string, std::string> texts = [] {
        std::map<std::string, std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(root + "/lessons")) {
            if (entry.path().extension() == ".cpp" && entry.path().stem() != "scene_viewer") {
                found[entry.path().stem()] = readText(entry.path());
            }
        }
        return found;
    }();
    return texts;
}

inline std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

inline Strings linesOf(const std::string& text) {
    Strings lines;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return lines;
}

inline bool holds(const json& list, const std::string& text) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

inline bool isText(const json& value) {
    return value.is_string() && !trimmed(value.get<std::string>()).empty();
}

/// Both languages, both with something in them.
inline void expectBilingual(const json& value, const std::string& where) {
    ASSERT_TRUE(value.is_object()) << where;
    EXPECT_TRUE(value.contains("it") && isText(value["it"])) << where << ".it";
    EXPECT_TRUE(value.contains("en") && isText(value["en"])) << where << ".en";
}

}  // namespace slides_refs
