// Results on disk.
// SPDX-License-Identifier: MIT
#include "grader/class/result.hpp"

#include "grader/report/formats/formats.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

namespace grader {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* keyFile = "grading.json";
constexpr const char* keySchema = "lambert-lab/grading/1";

Json object(const std::map<std::string, std::string>& texts, const Grader& grader) {
    Json all = Json::object();
    for (const auto& [name, hash] : texts)
        if (!grader.isCommon(hash))
            all[name] = hash;
    return all;
}

std::string keyText(const Graded& graded, const ResultKey& key, const Grader& grader) {
    Json json;
    json["schema"] = keySchema;
    json["submission"] = key.submission;
    json["tool"] = key.tool;
    json["rubric"] = key.rubric;
    json["sources"] = object(graded.sources, grader);
    json["files"] = object(graded.files, grader);
    json["frames"] = graded.frames;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

fs::path resultsFolder(const fs::path& report) { return report / "results"; }

void writeResult(const Graded& graded, const ResultKey& key, const Grader& grader, const fs::path& folder,
                 const std::string& formats) {
    writeReport(graded, folder, formats, {{keyFile, keyText(graded, key, grader)}});
}

std::optional<Result> readResult(const fs::path& folder) {
    try {
        Result result;
        result.report = reportFromJson(fileBytes(folder / "report.json"));
        const Json json = Json::parse(fileBytes(folder / keyFile));
        if (json.at("schema") != keySchema)
            return std::nullopt;
        result.key = {json.at("submission"), json.at("tool"), json.at("rubric")};
        result.sources = json.at("sources");
        result.files = json.at("files");
        result.frames = json.at("frames");
        result.folder = folder.filename().string();
        return result;
    } catch (const std::exception&) {  // cut short, or of another version: it is graded again
        return std::nullopt;
    }
}

bool hasAllFiles(const Result& result, const fs::path& folder, const std::string& formats) {
    std::error_code none;
    const auto isThere = [&](const fs::path& file) { return fs::is_regular_file(folder / file, none); };
    const std::vector<Format> chosen = parseFormats(formats);
    return std::all_of(result.report.images.begin(), result.report.images.end(),
                       [&](const ReportImage& image) { return isThere(image.file); }) &&
           std::all_of(chosen.begin(), chosen.end(), [&](Format one) { return isThere(fileNameOf(one)); });
}

}  // namespace grader
