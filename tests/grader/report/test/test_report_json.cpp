// report.json: read back as it was written, agreeing with its schema, refused with reasons.
// SPDX-License-Identifier: MIT
#include "grader/report/test/samples.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace grader;
using Json = nlohmann::json;

namespace {

Json schemaFile() {
    std::ifstream stream(LAMBERT_SOURCE_DIR "/tests/grader/report.schema.json");
    return Json::parse(stream);
}

bool isOfType(const Json& value, const std::string& type) {
    return type == "integer"  ? value.is_number_integer()
           : type == "number" ? value.is_number()
                              : type == value.type_name();
}

// As much of JSON Schema as report.schema.json is written in. Returns what is wrong, or "".
std::string complaint(const Json& value, const Json& schema, const Json& root, const std::string& where) {
    if (schema.contains("$ref"))
        return complaint(value, root.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))),
                         root, where);
    if (schema.contains("anyOf"))
        return complaint(value, schema["anyOf"][value.is_null() ? 1 : 0], root, where);
    if (schema.contains("const") && schema["const"] != value)
        return where + " is not " + schema["const"].dump();
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
        return where + " is none of " + schema["enum"].dump();
    if (schema.contains("type")) {
        const Json types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
        if (std::none_of(types.begin(), types.end(), [&](const Json& type) { return isOfType(value, type); }))
            return where + " is no " + schema["type"].dump();
    }
    if (value.is_number() &&
        (value < schema.value("minimum", -1e300) || value > schema.value("maximum", 1e300)))
        return where + " is out of range";
    if (value.is_array()) {
        if (value.size() < schema.value("minItems", 0U) || value.size() > schema.value("maxItems", 1000U))
            return where + " has another length";
        for (std::size_t i = 0; i < value.size(); ++i)
            if (const auto bad =
                    complaint(value[i], schema.at("items"), root, where + "[" + std::to_string(i) + "]");
                !bad.empty())
                return bad;
    }
    if (!value.is_object())
        return "";
    for (const auto& [key, inner] : value.items()) {
        if (!schema.at("properties").contains(key))
            return where + "." + key + " is not in the schema";
        if (const auto bad = complaint(inner, schema["properties"][key], root, where + "." + key);
            !bad.empty())
            return bad;
    }
    for (const Json& key : schema.at("required"))
        if (!value.contains(key.get<std::string>()))
            return where + "." + key.get<std::string>() + " is missing";
    return "";
}

// Objects in the schema that describe a field without a word, or leave one optional.
void findUndescribed(const Json& schema, const std::string& where, std::vector<std::string>& found) {
    if (!schema.is_object() || !schema.contains("properties"))
        return;
    for (const auto& [key, inner] : schema["properties"].items()) {
        if (!inner.contains("description") || inner["description"].get<std::string>().empty())
            found.push_back(where + "." + key);
        findUndescribed(inner, where + "." + key, found);
    }
    if (schema["required"].size() != schema["properties"].size())
        found.push_back(where + " leaves fields optional");
}

std::string without(const std::string& text, const std::string& key) {
    Json json = Json::parse(text);
    json.erase(key);
    return json.dump();
}

std::string refusal(const std::string& text) {
    try {
        reportFromJson(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "not refused";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(ReportJson, readsBackAsItWasWritten) {
    for (const Report& report : samples::all()) {
        const std::string once = toJson(report);
        EXPECT_EQ(toJson(reportFromJson(once)), once) << report.submission;
    }
}

TEST(ReportJson, keepsEveryValue) {
    const Report read = reportFromJson(toJson(samples::partialMarks()));
    EXPECT_EQ(read.submission, "bianchi_luca.zip");
    EXPECT_EQ(read.status, ReportStatus::graded);
    EXPECT_EQ(read.score, 9.5);
    EXPECT_EQ(read.checks.at(4).status, CheckStatus::partial);
    EXPECT_EQ(read.checks.at(3).explanation->ids, (std::vector<std::string>{"B3", "B5"}));
    EXPECT_EQ(read.checks.at(3).worst->expected[1], 0.5333);
    EXPECT_EQ(read.checks.at(3).worst->x, 117);
    EXPECT_FALSE(read.checks.at(2).worst);
    EXPECT_EQ(read.judgeSeconds, 0.75);
}

TEST(ReportJson, onlySecondsDifferFromRunToRun) {
    Report report = samples::partialMarks();
    const std::string before = toJson(report);
    report.compileSeconds = 99;
    EXPECT_NE(toJson(report), before);
    EXPECT_EQ(without(toJson(report), "seconds"), without(before, "seconds"));
    EXPECT_LT(before.rfind("similar"), before.rfind("\"seconds\""));
}

TEST(ReportJson, numbersAreWrittenInTheirShortestForm) {
    Report report = samples::fullMarks();
    report.score = 0.1 + 0.2;
    EXPECT_TRUE(holds(toJson(report), "\"score\": 0.30000000000000004"));
    report.score = 0.1;
    EXPECT_TRUE(holds(toJson(report), "\"score\": 0.1,"));
}

TEST(ReportJson, isUtf8WhateverItHolds) {
    const std::string text = toJson(samples::hostile());
    const Json parsed = Json::parse(text);  // throws on invalid UTF-8
    EXPECT_TRUE(holds(parsed["submission"], "\xEF\xBF\xBD"));
    EXPECT_TRUE(parsed["checks"][3]["worst"]["found"][0].is_null());
    EXPECT_TRUE(std::isnan(reportFromJson(text).checks.at(3).worst->found[0]));
}

TEST(ReportJson, agreesWithItsSchema) {
    const Json schema = schemaFile();
    for (const Report& report : samples::all())
        EXPECT_EQ(complaint(Json::parse(toJson(report)), schema, schema, "report"), "");
    Json spoilt = Json::parse(toJson(samples::fullMarks()));
    spoilt["checks"][0]["status"] = "passed";
    EXPECT_EQ(complaint(spoilt, schema, schema, "report").substr(0, 23), "report.checks[0].status");
    spoilt.erase("checks");
    EXPECT_EQ(complaint(spoilt, schema, schema, "report"), "report.checks is missing");
}

TEST(ReportJson, theSchemaDescribesEveryField) {
    const Json schema = schemaFile();
    std::vector<std::string> found;
    findUndescribed(schema, "report", found);
    for (const auto& [name, inner] : schema["$defs"].items())
        findUndescribed(inner, name, found);
    EXPECT_EQ(found, std::vector<std::string>{});
}

TEST(ReportJson, refusalsNameFieldExpectedAndFound) {
    Json json = Json::parse(toJson(samples::partialMarks()));
    json["schema"] = "lambert-lab/report/2";
    const std::string version = refusal(json.dump());
    EXPECT_TRUE(holds(version, "schema: expected \"lambert-lab/report/1\", found \"lambert-lab/report/2\""))
        << version;
    json["schema"] = reportSchema;
    json["checks"][3]["worst"]["numbers"][1]["value"] = 0.25;
    const std::string deep = refusal(json.dump());
    EXPECT_TRUE(holds(deep, "checks[3].worst.numbers[1].value: expected a string, found 0.25")) << deep;
    json["checks"] = Json::array({Json::array()});
    EXPECT_TRUE(holds(refusal(json.dump()), "checks[0]: expected an object, found []"));
    json["checks"] = Json::array();
    json["status"] = "fine";
    EXPECT_TRUE(holds(refusal(json.dump()),
                      "status: expected graded or not_gradable or infrastructure, found \"fine\""));
    EXPECT_TRUE(holds(refusal(without(toJson(samples::fullMarks()), "score")),
                      "score: expected this field, found none"));
}

TEST(ReportJson, brokenFilesAreRefused) {
    const std::string whole = toJson(samples::fullMarks());
    EXPECT_TRUE(holds(refusal(""), "the file: expected JSON, found nothing"));
    EXPECT_TRUE(holds(refusal("[]"), "the file: expected an object, found []"));
    EXPECT_TRUE(holds(refusal(std::string(200000, '[')), "expected JSON"));
    for (std::size_t size = 0; size < whole.size() - 1; size += 97)
        EXPECT_TRUE(holds(refusal(whole.substr(0, size)), "expected JSON")) << size;
    Json json = Json::parse(whole);
    json["files"][0]["bytes"] = 18446744073709551615ULL;
    EXPECT_TRUE(holds(refusal(json.dump()), "files[0].bytes: expected a whole number"))
        << refusal(json.dump());
    json["files"][0]["bytes"] = 1.5;
    EXPECT_TRUE(holds(refusal(json.dump()), "files[0].bytes"));
}
