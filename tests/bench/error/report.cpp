// Writes tables as CSV for charts, and everything as JSON.
// SPDX-License-Identifier: MIT
#include "bench/error/report.hpp"

#include "bench/report.hpp"
#include "image/write.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace bench::error {

namespace {

using Json = nlohmann::ordered_json;

// In quotes, because some names have commas.
std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string titleOf(const std::string& scene) {
    for (const SceneInfo& info : sceneTable())
        if (scene == info.id)
            return scene + ": " + info.title;
    return "medians over the scenes S0 to S8 (large), each scene (small)";
}

const char* verdict(const Row& row) {
    return row.method != defaultMethod ? "" : row.boundBroken() ? "no" : "yes";
}

std::string casesCsv(const std::vector<Row>& rows) {
    std::ostringstream out;
    out.precision(6);
    out << "scene,case,method,title,reference,size,lights,values,max_uS,p999_uS,max_R1_uS,bound_uS,bound_"
           "held,"
           "max_codes,mean_codes,wrong_share,frame_ms,lighting_ms,spread_ms,cost_ratio,frame_over_floor,"
           "rounds\n";
    for (const Row& row : rows) {
        const Method& method = methods()[row.method];
        out << row.scene << ',' << quoted(row.name) << ',' << method.id << ',' << method.title << ','
            << shortName(row.reference) << ',' << row.size << ',' << row.lights << ',' << row.error.values
            << ',' << row.error.max << ',' << row.error.p999 << ',' << row.shadingError << ',' << row.bound
            << ',' << verdict(row) << ',' << row.codes.max << ',' << row.codes.mean << ',' << row.codes.wrong
            << ',' << row.cost.frame << ',' << row.cost.lighting << ',' << row.cost.spread << ',' << row.ratio
            << ',' << row.cost.overFloor << ',' << row.cost.rounds << '\n';
    }
    return out.str();
}

std::string scenesCsv(const std::vector<SceneRow>& rows) {
    std::ostringstream out;
    out.precision(6);
    out << "scene,number,method,title,cost_ratio,max_uS,p999_uS,max_codes,mean_codes,wrong_share,on_front,"
           "on_front_codes,scene_title\n";
    for (const SceneRow& row : rows) {
        const Method& method = methods()[row.method];
        out << row.scene << ',' << row.method + 1 << ',' << method.id << ',' << method.title << ','
            << row.ratio << ',' << row.error.max << ',' << row.error.p999 << ',' << row.codes.max << ','
            << row.codes.mean << ',' << row.codes.wrong << ',' << row.onFront << ',' << row.onFrontCodes
            << ',' << quoted(titleOf(row.scene)) << '\n';
    }
    return out.str();
}

std::string frontCsv(const std::vector<SceneRow>& rows) {
    std::ostringstream out;
    out.precision(6);
    out << "scene,panel,cost_ratio,error\n";
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end =
            std::find_if(begin, rows.end(), [&](const SceneRow& row) { return row.scene != begin->scene; });
        const std::vector<SceneRow> scene(begin, end);
        const auto write = [&](const char* panel, const std::function<double(const SceneRow&)>& error) {
            for (const SceneRow* row : frontLine(scene, error))
                out << row->scene << ',' << panel << ',' << row->ratio << ',' << error(*row) << '\n';
        };
        write("floats", [](const SceneRow& row) { return row.error.max; });
        write("codes", [](const SceneRow& row) { return row.codes.max; });
        begin = end;
    }
    return out.str();
}

Json toJson(const Row& row) {
    Json json = {{"scene", row.scene},
                 {"case", row.name},
                 {"method", methods()[row.method].id},
                 {"reference", shortName(row.reference)},
                 {"size", row.size},
                 {"lights", row.lights},
                 {"values", row.error.values},
                 {"max_uS", row.error.max},
                 {"p999_uS", row.error.p999},
                 {"max_R1_uS", row.shadingError},
                 {"bound_uS", row.bound},
                 {"max_codes", row.codes.max},
                 {"mean_codes", row.codes.mean},
                 {"wrong_share", row.codes.wrong},
                 {"frame_ms", row.cost.frame},
                 {"lighting_ms", row.cost.lighting},
                 {"spread_ms", row.cost.spread},
                 {"cost_ratio", row.ratio},
                 {"frame_over_floor", row.cost.overFloor},
                 {"rounds", row.cost.rounds}};
    if (row.method == defaultMethod)
        json["bound_held"] = !row.boundBroken();
    return json;
}

Json toJson(const SceneRow& row) {
    return {{"scene", row.scene},
            {"method", methods()[row.method].id},
            {"cost_ratio", row.ratio},
            {"cost_counts", countsFromFloor(row.scene) ? "frame over flat-colour frame"
                                                       : "lighting over that of three.js's order"},
            {"max_uS", row.error.max},
            {"p999_uS", row.error.p999},
            {"max_codes", row.codes.max},
            {"mean_codes", row.codes.mean},
            {"wrong_share", row.codes.wrong},
            {"on_front", row.onFront},
            {"on_front_codes", row.onFrontCodes}};
}

// What tests/bench/run shows, in the form that all parts share: of each scene the default's cost and whether it is on the front.
Json results(const std::vector<Row>& rows, const std::vector<SceneRow>& scenes) {
    Json all = Json::array();
    const auto add = [&all](const std::string& name, double value, const char* unit, const Json& target,
                            const Json& ok) {
        all.push_back({{"name", name}, {"value", value}, {"unit", unit}, {"target", target}, {"ok", ok}});
    };
    for (const SceneRow& row : scenes) {
        if (row.method != defaultMethod)
            continue;
        add(row.scene + (countsFromFloor(row.scene) ? ": frame to the flat-colour frame"
                                                    : ": lighting cost to three.js's order"),
            row.ratio, "ratio", nullptr, nullptr);
        // In floats: 8 bits do not tell formulas in float from each other, only the coarser methods from them.
        add(row.scene + ": default on the front", row.onFront ? 1 : 0, "yes=1", 1, row.onFront);
    }
    double worst = 0;
    for (const Row& row : rows)
        if (row.method == defaultMethod)
            worst = std::max(worst, row.shadingError / row.bound);
    add("largest error to the promised bound", worst, "ratio", 1, worst <= 1);
    return all;
}

}  // namespace

const char* shortName(Reference reference) {
    return reference == Reference::shading ? "R1" : reference == Reference::surface ? "R2" : "R3";
}

void write(const std::filesystem::path& directory, const Run& run, const std::vector<Row>& rows,
           const std::vector<SceneRow>& scenes) {
    Json json = {{"part", "error"},
                 {"machine", processorName()},
                 {"driver", run.driver},
                 {"version", LAMBERT_VERSION},
                 {"date", today()},
                 {"quick", run.quick},
                 {"cores", std::thread::hardware_concurrency()},
                 {"results", results(rows, scenes)}};
    for (const Method& method : methods())
        json["methods"].push_back({{"method", method.id},
                                   {"title", method.title},
                                   {"known_wrong", method.known},
                                   {"approximate", method.approximate}});
    for (const SceneRow& row : scenes)
        json["scenes"].push_back(toJson(row));
    std::vector<SceneRow> all = scenes;
    for (const SceneRow& row : medians(scenes)) {
        json["medians"].push_back(toJson(row));
        all.push_back(row);
    }
    for (const Row& row : rows)
        json["cases"].push_back(toJson(row));
    image::writeText((directory / "error.csv").string(), casesCsv(rows));
    image::writeText((directory / "error_scenes.csv").string(), scenesCsv(all));
    image::writeText((directory / "error_front.csv").string(), frontCsv(all));
    image::writeText((directory / "error.json").string(), json.dump(1) + "\n");
}

}  // namespace bench::error
