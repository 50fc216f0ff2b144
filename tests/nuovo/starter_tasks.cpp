// Reads tasks.json, and matches its texts with a lesson's runs of NUOVO lines.
// SPDX-License-Identifier: MIT
#include "starter_tasks.hpp"

#include <nlohmann/json.hpp>

namespace nuovo {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kTasksLimit = std::size_t{1} << 20U;  // bytes

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
    throw InputError(where + ": expected " + what + "; correct tasks.json");
}

const Json& member(const Json& json, const std::string& name, const std::string& where) {
    if (!json.is_object() || !json.contains(name)) {
        refuse(where, "a member \"" + name + "\", found none");
    }
    return json[name];
}

ByLanguage readBilingual(const Json& json, const std::string& where) {
    ByLanguage text;
    for (const char* const lang : {"it", "en"}) {
        const Json& value = member(json, lang, where);
        if (!value.is_string() || trimmed(value.get<std::string>()).empty()) {
            refuse(where + "." + lang, "a text");
        }
        text[lang] = value.get<std::string>();
    }
    return text;
}

bool isComment(const Line& line) { return trimmed(line.code).substr(0, 2) == "//"; }

std::map<std::string, int> countByTag(const std::vector<NewRun>& runs) {
    std::map<std::string, int> counts;
    for (const NewRun& run : runs) {
        ++counts[toString(run.cites)];
    }
    return counts;
}

}  // namespace

std::vector<NewRun> runsOf(const Lesson& lesson) {
    std::vector<NewRun> runs;
    bool open = false;  // whether the last run goes on
    bool hasCode = false;  // whether it has more than comments
    for (std::size_t i = 0; i < lesson.lines.size(); ++i) {
        const Line& line = lesson.lines[i];
        if (line.kind == LineKind::Blank) {
            continue;
        }
        if (line.kind != LineKind::New) {
            open = false;
            continue;
        }
        const bool comment = isComment(line);
        if (!open || !(runs.back().cites == line.cites) || (comment && hasCode)) {
            runs.push_back({line.cites, i, i});
            hasCode = false;
        }
        open = true;
        hasCode = hasCode || !comment;
        runs.back().end = i + 1;
    }
    return runs;
}

LessonTasks readTasks(const std::filesystem::path& file, const Lesson& lesson) {
    Json json;
    try {
        json = Json::parse(readText(file, kTasksLimit));
    } catch (const Json::exception& error) {
        refuse(file.string(), std::string("JSON, found: ") + error.what());
    }
    const std::string where = file.string() + ": lessons." + lesson.stem;
    const Json& all =
        member(member(json, "lessons", file.string()), lesson.stem, file.string() + ": lessons");
    const Json& byTag = member(all, "tasks", where);
    const std::vector<NewRun> runs = runsOf(lesson);
    for (const auto& [tag, count] : countByTag(runs)) {
        const Json& texts = member(byTag, tag, where + ".tasks");
        if (!texts.is_array() || texts.size() != static_cast<std::size_t>(count)) {
            refuse(where + ".tasks." + tag,
                   "an array of " + std::to_string(count) +
                       " texts, as many as the lesson has runs of NUOVO lines with that tag");
        }
    }
    LessonTasks tasks;
    std::map<std::string, std::size_t> used;
    for (const NewRun& run : runs) {
        const std::string tag = toString(run.cites);
        const std::size_t n = used[tag]++;
        tasks.runs.push_back(
            readBilingual(byTag[tag][n], where + ".tasks." + tag + "[" + std::to_string(n) + "]"));
    }
    for (const Json& term : member(all, "terms", where)) {
        if (!term.is_string()) {
            refuse(where + ".terms", "names of terms");
        }
        const std::string name = term.get<std::string>();
        const std::string terms = file.string() + ": terms";
        tasks.terms[name] =
            readBilingual(member(member(json, "terms", file.string()), name, terms), terms + "." + name);
    }
    return tasks;
}

}  // namespace nuovo
