// Reads slides.json for the companion; JSON's own messages name the field that is missing or wrong.
// SPDX-License-Identifier: MIT
#define JSON_DIAGNOSTICS 1  // "(/slides/3/predict) key 'answer' not found"
#include "companion.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace nuovo {
namespace {

using Json = nlohmann::json;
using Strings = std::vector<std::string>;

BothLanguages bothLanguages(const Json& value) {
    return {value.at("it").get<std::string>(), value.at("en").get<std::string>()};
}

CodeLine codeLine(const Json& value) {
    return {value.at("file").get<std::string>(), value.at("code").get<std::string>()};
}

Picture picture(const Json& value) {
    Picture result;
    result.file = value.at("file").get<std::string>();
    result.command = value.at("command").get<std::string>();
    result.size = value.value("size", "240x240");
    result.isAnswer = value.value("answer", false);
    if (value.contains("alt"))
        result.alt = bothLanguages(value.at("alt"));
    return result;
}

CompanionSlide companionSlide(const Json& value) {
    CompanionSlide slide;
    slide.number = value.at("number").get<int>();
    slide.title = bothLanguages(value.at("title"));
    slide.says = bothLanguages(value.at("says"));
    if (!value.at("equation").is_null())
        slide.equation = value.at("equation").at("text").get<std::string>();
    slide.lessons = value.at("lessons").get<Strings>();
    slide.terms = value.at("terms").get<Strings>();
    slide.views = value.at("views").get<Strings>();
    for (const Json& line : value.at("lines"))
        slide.lines.push_back(codeLine(line));
    for (const Json& one : value.at("pictures"))
        slide.pictures.push_back(picture(one));
    slide.question = bothLanguages(value.at("predict").at("question"));
    slide.answer = bothLanguages(value.at("predict").at("answer"));
    return slide;
}

Erratum erratum(const Json& value) {
    Erratum result{value.at("also").get<std::vector<int>>(), value.at("kind").get<std::string>(),
                   bothLanguages(value.at("says")), bothLanguages(value.at("should_say")),
                   bothLanguages(value.at("reason"))};
    result.slides.push_back(value.at("slide").get<int>());
    std::sort(result.slides.begin(), result.slides.end());
    return result;
}

Companion companion(const Json& json, const std::filesystem::path& file) {
    Companion result;
    result.file = file;
    for (const Json& slide : json.at("slides"))
        result.slides.push_back(companionSlide(slide));
    for (const auto& [term, line] : json.at("term_lines").items())
        result.termLines[term] = codeLine(line);
    for (const auto& [kind, text] : json.at("errata_kinds").items())
        result.kinds[kind] = bothLanguages(text);
    for (const Json& one : json.at("errata"))
        result.errata.push_back(erratum(one));
    for (const Json& one : json.at("other_pictures"))
        result.otherPictures.push_back(picture(one));
    result.picturesElsewhere = json.at("pictures_elsewhere").get<Strings>();
    return result;
}

}  // namespace

Companion readCompanion(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream)
        throw InputError(file.string() + ": cannot be read; say where slides.json is with --slides FILE");
    try {
        return companion(Json::parse(text), file);
    } catch (const Json::exception& error) {
        throw InputError(file.string() + ": " + error.what() + "; correct slides.json");
    }
}

std::vector<Picture> picturesToDraw(const Companion& companion, const LessonSet& lessons) {
    std::map<std::string, Picture> all;
    const auto add = [&](const Picture& one) {
        const auto [place, isNew] = all.emplace(one.file, one);
        const Picture& first = place->second;
        if (!isNew && (first.command != one.command || first.size != one.size))
            throw InputError(companion.file.string() + ": " + one.file + " is drawn in two ways, \"" +
                             first.command + "\" at " + first.size + " and \"" + one.command + "\" at " +
                             one.size + "; give one of them another name");
    };
    for (const CompanionSlide& slide : companion.slides)
        std::for_each(slide.pictures.begin(), slide.pictures.end(), add);
    std::for_each(companion.otherPictures.begin(), companion.otherPictures.end(), add);
    for (const auto* list : {&lessons.chain, &lessons.others})
        for (const Lesson& lesson : *list)
            if (lesson.stem != "scene_viewer")  // it has no scene of its own
                add({lesson.stem + ".png", lesson.stem, "320x320", {}, false});
    for (const std::string& file : companion.picturesElsewhere)
        if (all.count(file) != 0)
            throw InputError(companion.file.string() + ": " + file +
                             " is in pictures_elsewhere, yet has a command here; take one of them away");
    std::vector<Picture> result;
    for (const auto& [file, one] : all)
        result.push_back(one);
    return result;
}

}  // namespace nuovo
