// Reads the parts' JSON files and tells people what is in them.
// SPDX-License-Identifier: MIT
#include "bench/summary.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace bench {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* order[] = {"error",  "cold",    "steady",    "scaling",
                                 "toggle", "compile", "reference", "threejs"};
constexpr const char *beginMark = "<!-- bench:begin -->\n", *endMark = "<!-- bench:end -->";

PartResults readPart(const fs::path& file) {
    try {
        std::ifstream in(file);
        const Json json = Json::parse(in);
        PartResults part{json.at("part"),
                         json.at("machine"),
                         json.at("driver"),
                         json.at("version"),
                         json.at("date"),
                         json.at("cores"),
                         {}};
        for (const Json& row : json.at("results")) {
            Result result{row.at("name"), row.at("value"), row.at("unit"), std::nullopt, std::nullopt};
            if (!row.at("target").is_null())
                result.target = row.at("target").get<double>();
            if (!row.at("ok").is_null())
                result.ok = row.at("ok").get<bool>();
            part.results.push_back(result);
        }
        return part;
    } catch (const Json::exception& error) {
        throw std::runtime_error(file.string() + " is no report of a part of tests/bench: " + error.what());
    }
}

// What a reader wants to see of the many numbers.
bool matters(const PartResults& part, const Result& result) {
    return result.target || result.unit == "ratio" || part.part == "toggle" ||
           result.name.find(": per ") != std::string::npos;
}

std::string targetText(const Result& result) {
    if (!result.target)
        return "";
    // Where a value lies on the good side of its target, that side tells whether it is a ceiling.
    const bool ceiling = (result.value <= *result.target) == result.ok.value_or(true);
    return (ceiling ? "at most " : "at least ") + digits(*result.target);
}

std::string rowsOf(const PartResults& part) {
    std::vector<Result> shown;
    int met = 0, targets = 0;
    for (const Result& result : part.results)
        if (matters(part, result)) {
            shown.push_back(result);
            targets += result.ok ? 1 : 0;
            met += result.ok.value_or(false) ? 1 : 0;
        }
    std::string rows;
    if (shown.size() > 16) {  // then those that were missed say most
        rows += "| " + part.part + " | targets met | " + std::to_string(met) + " of " +
                std::to_string(targets) + " | all |\n";
        std::erase_if(shown, [](const Result& result) { return result.ok.value_or(true); });
    }
    for (const Result& result : shown)
        rows += "| " + part.part + " | " + result.name + " | " + digits(result.value) +
                (result.unit == "ratio" || result.unit == "yes=1" ? "" : " " + result.unit) + " | " +
                targetText(result) + (result.ok.value_or(true) ? "" : " (missed)") + " |\n";
    return rows;
}

}  // namespace

std::vector<PartResults> readParts(const fs::path& directory) {
    std::vector<PartResults> parts;
    for (const std::string part : order)
        if (fs::exists(directory / (part + ".json")))
            parts.push_back(readPart(directory / (part + ".json")));
    return parts;
}

std::string terminalTable(const std::vector<PartResults>& parts) {
    std::string text;
    for (const PartResults& part : parts)
        for (const Result& result : part.results) {
            if (!matters(part, result))
                continue;
            std::string line =
                part.part + std::string(11 - std::min<std::size_t>(10, part.part.size()), ' ') + result.name;
            line.resize(std::max<std::size_t>(line.size() + 1, 78), ' ');
            text += line + digits(result.value) + ' ' + result.unit;
            if (result.ok)
                text += "   " + targetText(result) + (*result.ok ? ": met" : ": MISSED");
            text += '\n';
        }
    return text;
}

std::string readmeSection(const fs::path& directory, const std::string& pictures) {
    const std::vector<PartResults> parts = readParts(directory);
    std::map<std::string, std::string> where;  // parts by machine and day
    std::string rows, images;
    for (const PartResults& part : parts) {
        std::string& names =
            where[part.machine + ", " + std::to_string(part.cores) + " cores, driver: " + part.driver +
                  ", version " + part.version + ", " + part.date];
        names += (names.empty() ? "" : ", ") + part.part;
        rows += rowsOf(part);
        if (fs::exists(directory / (part.part + ".png")))
            images += "![" + part.part + "](" + pictures + "/" + part.part + ".png)\n";
    }
    std::string text = "| part | what | measured | target |\n|---|---|---|---|\n" + rows +
                       "\nMeasured by `tests/bench/run`:\n\n";
    for (const auto& [machine, names] : where)
        text += "* " + names + ": " + machine + "\n";
    return text + "\n" + images;
}

std::string markedPart(const std::string& text) {
    const std::size_t begin = text.find(beginMark);
    const std::size_t end = text.find(endMark);
    if (begin == std::string::npos || end == std::string::npos || end < begin)
        throw std::runtime_error(std::string("expected the lines ") + "<!-- bench:begin --> and " + endMark +
                                 ", in this order; put them where the section belongs");
    const std::size_t start = begin + std::char_traits<char>::length(beginMark);
    return text.substr(start, end - start);
}

std::string withMarkedPart(const std::string& text, const std::string& section) {
    const std::string old = markedPart(text);
    const std::size_t start = text.find(beginMark) + std::char_traits<char>::length(beginMark);
    return text.substr(0, start) + section + text.substr(start + old.size());
}

}  // namespace bench
