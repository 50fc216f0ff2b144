// Reads the lessons' directory and slides.json; everything unreadable ends in one InputError.
// SPDX-License-Identifier: MIT
#include "input.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace nuovo {
namespace {

constexpr std::size_t kLessonLimit = std::size_t{1} << 20U;  // bytes; a lesson has some five thousand
constexpr std::size_t kSlidesLimit = std::size_t{1} << 24U;

/// A JSON value with its file and its path in it, so that every complaint can name both.
struct Field {
    const fs::path& file;
    std::string path;
    const Json& value;

    [[noreturn]] void refuse(const std::string& expected) const {
        // Only plain values are printed: writing a nested one recurses as deep as a hostile file likes.
        const std::string found =
            value.is_primitive() ? value.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, 60)
                                 : "";
        throw InputError(file.string() + ": " + (path.empty() ? "the whole" : path) + ": expected " +
                         expected + ", found " + value.type_name() +
                         (found.empty() || found == "null" ? "" : " " + found) + "; correct slides.json");
    }
    Field member(const char* name) const {
        static const Json none;
        if (!value.is_object()) {
            refuse("an object");
        }
        const auto found = value.find(name);
        return {file, path.empty() ? name : path + "." + name, found == value.end() ? none : *found};
    }
    std::vector<Field> elements() const {
        if (!value.is_array()) {
            refuse("an array");
        }
        std::vector<Field> result;
        for (std::size_t i = 0; i < value.size(); ++i) {
            result.push_back({file, path + "[" + std::to_string(i) + "]", value[i]});
        }
        return result;
    }
    std::string text() const {
        if (!value.is_string()) {
            refuse("a string");
        }
        return value.get<std::string>();
    }
};

CodeItem readItem(const Field& field) {
    CodeItem item{field.member("item").text(), field.member("lesson").text(), {}};
    if (!parseCitation(item.item)) {
        field.member("item").refuse("a slide and item such as \"36.1\"");
    }
    for (const Field& line : field.member("cpp").elements()) {
        item.cpp.push_back(line.text());
    }
    if (item.cpp.empty()) {
        field.member("cpp").refuse("the item's lines of C++");
    }
    return item;
}

Titles readTitles(const Field& title) {
    Titles titles;
    if (title.value.is_object()) {
        for (const char* const lang : {"it", "en"}) {
            if (title.value.contains(lang)) {
                titles[lang] = title.member(lang).text();
            }
        }
    } else if (title.value.is_string()) {
        titles["it"] = titles["en"] = title.text();
    }
    return titles;
}

void readSlide(const Field& slide, Slides& slides) {
    const Field number = slide.member("number");
    if (!number.value.is_number_integer() || number.value < 1 || number.value > 9999) {
        number.refuse("the number printed on the slide, 1 to 9999");
    }
    if (!slides.titles.emplace(number.value.get<int>(), readTitles(slide.member("title"))).second) {
        number.refuse("every slide once");
    }
    const Field code = slide.member("code");
    if (code.value.is_null()) {
        return;
    }
    for (const Field& element : code.elements()) {
        CodeItem item = readItem(element);
        if (slides.find(item.item) != nullptr) {
            element.member("item").refuse("every item once");
        }
        if (parseCitation(item.item)->slide != number.value) {
            element.member("item").refuse("an item of slide " + number.value.dump());
        }
        slides.items.push_back(std::move(item));
    }
}

}  // namespace

// A regular file only: a pipe or a device could go on for ever.
std::string readText(const fs::path& file, std::size_t limit) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        throw InputError(file.string() + ": expected a file, found " +
                         (fs::exists(file, error) ? "something else" : "nothing") + "; check the path");
    }
    const auto size = fs::file_size(file, error);
    if (error || size > limit) {
        throw InputError(file.string() + ": expected at most " + std::to_string(limit) + " bytes, found " +
                         (error ? error.message() : std::to_string(size)) + "; is this the right file?");
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.is_open() || stream.bad()) {
        throw InputError(file.string() + ": cannot be read; check its permissions");
    }
    return text;
}

const CodeItem* Slides::find(std::string_view item) const {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const CodeItem& i) { return i.item == item; });
    return found == items.end() ? nullptr : &*found;
}

LessonSet readLessons(const fs::path& directory) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->path().extension() == ".cpp") {
            files.push_back(entry->path());
        }
    }
    if (error) {
        throw InputError(directory.string() + ": expected the lessons' directory, found: " + error.message() +
                         "; say where it is with --lessons DIR");
    }
    std::sort(files.begin(), files.end());  // the chain's numbers have two digits: by name is by number
    LessonSet set;
    for (const fs::path& file : files) {
        Lesson lesson = parseLesson(file, readText(file, kLessonLimit));
        (lesson.number < 0 ? set.others : set.chain).push_back(std::move(lesson));
    }
    if (set.chain.empty()) {
        throw InputError(directory.string() +
                         ": expected lesson_00_*.cpp, lesson_01_*.cpp, ..., found none; " +
                         "say where the lessons are with --lessons DIR");
    }
    return set;
}

Slides readSlides(const fs::path& file) { return parseSlides(file, readText(file, kSlidesLimit)); }

Slides parseSlides(const fs::path& file, std::string_view text) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::exception& error) {
        throw InputError(file.string() + ": expected JSON, found: " + error.what() + "; correct slides.json");
    }
    Slides slides;
    slides.file = file;
    for (const Field& slide : Field{file, "", json}.member("slides").elements()) {
        readSlide(slide, slides);
    }
    return slides;
}

}  // namespace nuovo
