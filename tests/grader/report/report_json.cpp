// report.json: one list of fields for each struct, which the writer and the reader both walk along.
// SPDX-License-Identifier: MIT
#include "grader/report/report.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace grader {

namespace {

using Json = nlohmann::ordered_json;

template <class Record, class Plain>
concept is = std::is_same_v<std::remove_const_t<Record>, Plain>;

template <class Enum>
using Names = std::vector<std::pair<Enum, const char*>>;

const Names<Language>& namesOf(Language) {
    static const Names<Language> names = {{Language::it, "it"}, {Language::en, "en"}};
    return names;
}

const Names<ReportStatus>& namesOf(ReportStatus) {
    static const Names<ReportStatus> names = {{ReportStatus::graded, "graded"},
                                              {ReportStatus::notGradable, "not_gradable"},
                                              {ReportStatus::infrastructure, "infrastructure"}};
    return names;
}

const Names<CheckStatus>& namesOf(CheckStatus) {
    static const Names<CheckStatus> names = {{CheckStatus::pass, "pass"},
                                             {CheckStatus::partial, "partial"},
                                             {CheckStatus::fail, "fail"},
                                             {CheckStatus::skipped, "skipped"}};
    return names;
}

template <class Archive>
void fields(Archive& at, is<Explanation> auto& it) {
    at("ids", it.ids);
    at("name", it.name);
    at("hint", it.hint);
    at("convention", it.convention);
    at("explained", it.explained);
    at("confidence", it.confidence);
}

template <class Archive>
void fields(Archive& at, is<TermNumber> auto& it) {
    at("symbol", it.symbol);
    at("term", it.term);
    at("value", it.value);
}

template <class Archive>
void fields(Archive& at, is<WorstPixel> auto& it) {
    at("frame", it.frame);
    at("x", it.x);
    at("y", it.y);
    at("region", it.region);
    at("found", it.found);
    at("expected", it.expected);
    at("own_scene", it.ownScene);
    at("numbers", it.numbers);
}

template <class Archive>
void fields(Archive& at, is<RegionShare> auto& it) {
    at("name", it.name);
    at("pixels", it.pixels);
    at("right", it.right);
}

template <class Archive>
void fields(Archive& at, is<Check> auto& it) {
    at("id", it.id);
    at("title", it.title);
    at("slides", it.slides);
    at("status", it.status);
    at("score", it.score);
    at("max_score", it.maxScore);
    at("is_new", it.isNew);
    at("depends_on", it.dependsOn);
    at("message", it.message);
    at("expected", it.expected);
    at("hint", it.hint);
    at("explanation", it.explanation);
    at("worst", it.worst);
    at("regions", it.regions);
    at("images", it.images);
    at("visibility", it.visibility);
}

template <class Archive>
void fields(Archive& at, is<ReportImage> auto& it) {
    at("id", it.id);
    at("role", it.role);
    at("label", it.label);
    at("file", it.file);
    at("width", it.width);
    at("height", it.height);
}

template <class Archive>
void fields(Archive& at, is<SubmittedFile> auto& it) {
    at("path", it.path);
    at("role", it.role);
    at("note", it.note);
    at("bytes", it.bytes);
    at("sha256", it.sha256);
}

template <class Archive>
void fields(Archive& at, is<Similar> auto& it) {
    at("submission", it.submission);
    at("how", it.how);
}

// "seconds" of a report, which stand in an object of their own.
template <class Record>
struct Seconds {
    Record& report;
};

template <class Archive, class Record>
void fields(Archive& at, const Seconds<Record>& it) {
    at("compile", it.report.compileSeconds);
    at("frames", it.report.framesSeconds);
    at("judge", it.report.judgeSeconds);
}

template <class Archive>
void fields(Archive& at, is<Report> auto& it) {
    at("tool_version", it.toolVersion);
    at("rubric_hash", it.rubricHash);
    at("renderer", it.renderer);
    at("lesson", it.lesson);
    at("lesson_title", it.lessonTitle);
    at("language", it.language);
    at("submission", it.submission);
    at("submission_hash", it.submissionHash);
    at("files", it.files);
    at("status", it.status);
    at("reason", it.reason);
    at("score", it.score);
    at("max_score", it.maxScore);
    at("confinement", it.confinement);
    at("checks", it.checks);
    at("images", it.images);
    at("build_log", it.buildLog);
    at("said", it.said);
    at("similar", it.similar);
    auto seconds = Seconds<std::remove_reference_t<decltype(it)>>{it};
    at("seconds", seconds);
}

class Writer {
  public:
    Json json = Json::object();

    template <class Value>
    void operator()(const char* key, const Value& value) {
        json[key] = toValue(value);
    }

  private:
    static Json toValue(const std::string& text) { return text; }
    static Json toValue(bool value) { return value; }
    static Json toValue(int value) { return value; }
    static Json toValue(long long value) { return value; }
    static Json toValue(double value) { return value; }  // what is not finite is written as null

    template <class Value>
    static Json toValue(const std::optional<Value>& value) {
        return value ? toValue(*value) : Json();
    }
    template <class Value>
    static Json toValue(const std::vector<Value>& list) {
        return array(list);
    }
    static Json toValue(const std::array<double, 3>& list) { return array(list); }

    template <class List>
    static Json array(const List& list) {
        Json result = Json::array();
        for (const auto& item : list)
            result.push_back(toValue(item));
        return result;
    }

    template <class Record>
    static Json toValue(const Record& record) {
        if constexpr (std::is_enum_v<Record>) {
            for (const auto& [value, name] : namesOf(record))
                if (value == record)
                    return name;
            return namesOf(record).back().second;
        } else {
            Writer inner;
            fields(inner, record);
            return std::move(inner.json);
        }
    }
};

[[noreturn]] void refuse(const std::string& where, const std::string& expected, const std::string& found) {
    throw std::runtime_error("report.json: " + where + ": expected " + expected + ", found " + found +
                             "; grade the submission again, or take a report as `grade` wrote it");
}

// A value for a message: short, and all in ASCII.
std::string shown(const Json& value) {
    constexpr std::size_t longest = 60;
    const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

class Reader {
  public:
    Reader(const Json& object, std::string place) : object_(object), place_(std::move(place)) {
        if (!object_.is_object())
            refuse(place_.empty() ? "the file" : place_, "an object", shown(object_));
    }

    template <class Value>
    void operator()(const char* key, Value& value) const {
        const std::string where = place_.empty() ? key : place_ + "." + key;
        const auto found = object_.find(key);
        if (found == object_.end())
            refuse(where, "this field", "none");
        read(*found, where, value);
    }

  private:
    static void read(const Json& json, const std::string& where, std::string& value) {
        if (!json.is_string())
            refuse(where, "a string", shown(json));
        value = json.get<std::string>();
    }
    static void read(const Json& json, const std::string& where, bool& value) {
        if (!json.is_boolean())
            refuse(where, "true or false", shown(json));
        value = json.get<bool>();
    }
    static void read(const Json& json, const std::string& where, double& value) {
        if (!json.is_number() && !json.is_null())
            refuse(where, "a number", shown(json));
        value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
    }
    static void read(const Json& json, const std::string& where, long long& value) {
        constexpr auto most = static_cast<unsigned long long>(std::numeric_limits<long long>::max());
        if (!json.is_number_integer() || (json.is_number_unsigned() && json.get<unsigned long long>() > most))
            refuse(where, "a whole number below 2^63", shown(json));
        value = json.get<long long>();
    }
    static void read(const Json& json, const std::string& where, int& value) {
        long long number = 0;
        read(json, where, number);
        if (!std::in_range<int>(number))
            refuse(where, "a whole number below 2^31", shown(json));
        value = static_cast<int>(number);
    }
    static void read(const Json& json, const std::string& where, std::array<double, 3>& value) {
        if (!json.is_array() || json.size() != value.size())
            refuse(where, "three numbers: R, G, B", shown(json));
        for (std::size_t i = 0; i < value.size(); ++i)
            read(json[i], where + "[" + std::to_string(i) + "]", value[i]);
    }
    template <class Value>
    static void read(const Json& json, const std::string& where, std::optional<Value>& value) {
        value.reset();
        if (!json.is_null())
            read(json, where, value.emplace());
    }
    template <class Value>
    static void read(const Json& json, const std::string& where, std::vector<Value>& value) {
        if (!json.is_array())
            refuse(where, "a list", shown(json));
        value.clear();
        for (std::size_t i = 0; i < json.size(); ++i)
            read(json[i], where + "[" + std::to_string(i) + "]", value.emplace_back());
    }
    template <class Record>
    static void read(const Json& json, const std::string& where, Record& value) {
        if constexpr (std::is_enum_v<Record>) {
            readName(json, where, value);
        } else {
            const Reader inner(json, where);
            fields(inner, value);
        }
    }
    template <class Enum>
    static void readName(const Json& json, const std::string& where, Enum& value) {
        std::string all;
        for (const auto& [known, name] : namesOf(value)) {
            if (json.is_string() && json.get<std::string>() == name) {
                value = known;
                return;
            }
            all += (all.empty() ? "" : " or ") + std::string(name);
        }
        refuse(where, all, shown(json));
    }

    const Json& object_;
    std::string place_;
};

}  // namespace

std::string toJson(const Report& report) {
    Writer writer;
    writer("schema", std::string(reportSchema));
    fields(writer, report);
    return writer.json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Report reportFromJson(const std::string& json) {
    const Json parsed = Json::parse(json, nullptr, false);
    if (parsed.is_discarded())
        refuse("the file", "JSON", json.empty() ? "nothing" : "something else, or only a part of it");
    const Reader reader(parsed, "");
    std::string schema;
    reader("schema", schema);
    if (schema != reportSchema)
        refuse("schema", "\"" + std::string(reportSchema) + "\"", shown(schema));
    Report report;
    fields(reader, report);
    return report;
}

}  // namespace grader
