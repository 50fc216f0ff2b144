// Puts the numbers of a frame into JSON.
// SPDX-License-Identifier: MIT
#include "lab/stats.hpp"

#include "lab/light_cost.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <unistd.h>

namespace lab {

using Json = nlohmann::ordered_json;

std::string variantText(const lighting::Variant& v) {
    std::ostringstream out;
    out << (v.lit ? "lit" : "unlit");
    if (v.perVertex)
        out << " per-vertex";
    if (v.blinn)
        out << " blinn";
    if (v.doubleSided)
        out << " double-sided";
    if (v.directional > 0)
        out << " directional=" << v.directional;
    const std::pair<const char*, int> groups[] = {
        {"k0", v.decay0}, {"k1", v.decay1}, {"k2", v.decay2}, {"k*", v.decayOther}};
    for (const auto& [name, count] : groups)
        if (count > 0)
            out << " point:" << name << '=' << count;
    if (v.window)
        out << " window";
    for (unsigned group = 0; group < 4; ++group)
        if ((v.clustered >> group & 1U) != 0)
            out << " clustered:" << groups[group].first;
    if (v.lit && v.storage != lighting::LightStorage::uniforms)
        out << (v.storage == lighting::LightStorage::constants ? " constants" : " texture");
    if (v.scaled)
        out << " scaled";
    if (v.ambient)
        out << " ambient";
    if (v.lit) {
        std::string names;
        for (const lighting::TermInfo& row : lighting::terms())
            if (v.has(row.term))
                names += (names.empty() ? "" : ",") + std::string(row.name);
        out << " terms=" << (names.empty() ? "none" : names);
    }
    return out.str();
}

double millisecondsSinceProcessStart() {
    std::ifstream in("/proc/self/stat");
    std::string text;
    std::getline(in, text);
    std::istringstream fields(
        text.substr(std::min(text.rfind(')'), text.size() - 1) + 1));  // the name may hold spaces
    std::string field;
    for (int number = 3; number <= 22; ++number)  // field 22 is the start, in ticks since the machine's
        fields >> field;
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    const double ticks = std::strtod(field.c_str(), nullptr);
    const double started = ticks / static_cast<double>(sysconf(_SC_CLK_TCK)) * 1000;
    return static_cast<double>(now.tv_sec) * 1000 + static_cast<double>(now.tv_nsec) / 1e6 - started;
}

namespace {

std::string oneLine(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json nameOrNull(const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); }

}  // namespace

std::string failureJson(const std::string& frame, int line, const Failure& failure) {
    Json json;
    json["frame"] = nameOrNull(frame);
    json["line"] = line;
    json["status"] = static_cast<int>(failure.status);
    json["error"] = failure.message;
    return oneLine(json);
}

std::string statsJson(const StatsReport& report, const render::FrameStats& frame) {
    std::set<std::string> variants;
    for (const lighting::Variant& variant : frame.variants)
        variants.insert(variantText(variant));
    std::string variantList;
    for (const std::string& variant : variants)
        variantList += (variantList.empty() ? "" : "; ") + variant;
    Json skipped = Json::array();
    for (const lighting::Skipped& s : frame.skipped)
        skipped.push_back({{"what", THREE::describe(*s.object)}, {"why", s.share + s.why.en}});
    std::vector<double> times = report.frameMilliseconds;
    std::sort(times.begin(), times.end());
    const std::size_t n = times.size();
    Json json;
    json["frame"] = nameOrNull(report.frame);
    json["renderer"] = report.renderer;
    json["width"] = report.width;
    json["height"] = report.height;
    json["shader_variant"] = variantList;
    json["meshes"] = {{"drawn", frame.meshesDrawn}, {"skipped", frame.meshesSkipped}};
    json["lights"] = {
        {"used", frame.lightsUsed}, {"skipped", frame.lightsSkipped}, {"pairs_skipped", frame.pairsSkipped}};
    json["back_faces_skipped"] = frame.sidesSkipped;
    json["clusters"] = {{"count", frame.clusters}, {"entries", frame.clusterEntries}};
    json["light_cut_codes"] = frame.cutCodes;
    json["skipped"] = skipped;
    json["draw_calls"] = frame.drawCalls;
    json["triangles"] = frame.triangles;
    json["uploads_bytes"] = frame.uploadedBytes;
    json["compile_ms"] = frame.compileMilliseconds;
    json["first_frame_ms"] = report.firstFrameMilliseconds;
    json["frame_ms"] = {{"median", median(times)},
                        {"min", n == 0 ? 0 : times.front()},
                        {"max", n == 0 ? 0 : times.back()},
                        {"n", n}};
    json["light_ms"] = report.millisecondsPerLight ? Json(*report.millisecondsPerLight) : Json(nullptr);
    json["sliders"] = Json::object();
    for (const Slider& slider : report.controls.sliders())
        json["sliders"][slider.name] = slider.value;
    json["readings"] = Json::array();  // in English whatever the language is, as everything here
    for (const Reading& reading : report.controls.readings)
        json["readings"].push_back({{"what", reading.label.en}, {"value", reading.value}});
    json["nonfinite"] = frame.nonfinite ? Json(*frame.nonfinite) : Json(nullptr);
    json["phases_ms"] = Json::object();
    for (const auto& [name, milliseconds] : report.phases.all())
        json["phases_ms"][name] = milliseconds;
    return oneLine(json);
}

}  // namespace lab
