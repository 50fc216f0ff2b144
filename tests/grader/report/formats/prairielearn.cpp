// PrairieLearn's results.json, which takes pictures, and at most 1 MB in all.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/common.hpp"
#include "grader/report/formats/shrink.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

namespace grader {

namespace {

using Json = nlohmann::ordered_json;
using Pictures = std::map<std::string, std::string>;  // PNGs by an image's id

constexpr std::size_t most = 1000000;  // bytes of the whole file
constexpr std::size_t mostPictures = 60;
constexpr std::size_t longestLog = 40000;
constexpr std::size_t smallest = 2000;  // bytes of a PNG that is not worth making smaller

Json testOf(const Report& report, const Check& check, const Pictures& pictures) {
    std::string output;
    for (const std::string& line : feedbackLines(report, check))
        output += line + "\n";
    Json images = Json::array();
    for (const std::string& id : check.images)
        if (const auto png = pictures.find(id); png != pictures.end())
            images.push_back(
                {{"label", oneLine(findImage(report, id)->label)}, {"url", dataUrl(png->second)}});
    return {{"name", oneLine(check.title)},
            {"description", slidesToReread(report.language, check.slides)},
            {"points", check.score},
            {"max_points", check.maxScore},
            {"message", signFor(check.status) + std::string(" ") + wordFor(report.language, check.status)},
            {"output", output},
            {"images", images}};
}

std::string write(const Report& report, const Pictures& pictures) {
    Json json;
    if (report.status != ReportStatus::graded) {  // uses up no attempt
        json = {{"gradable", false}, {"message", headline(report)}, {"format_errors", {headline(report)}}};
    } else {
        const std::string hidden = hiddenSentence(report);
        json = {{"gradable", true},
                {"score", fraction(report)},
                {"message", headline(report) + (hidden.empty() ? "" : "\n" + hidden)},
                {"output", shortened(harmless(report.buildLog + report.said), longestLog)},
                {"tests", Json::array()}};
        for (const Check& check : report.checks)
            if (isShown(check))
                json["tests"].push_back(testOf(report, check, pictures));
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// The shown checks' pictures, in the order in which they matter: of what is wrong before of what is right.
std::vector<std::string> wantedImages(const Report& report) {
    std::vector<std::string> ids;
    for (const bool passed : {false, true})
        for (const Check& check : report.checks)
            for (const std::string& id : check.images)
                if (isShown(check) && (check.status == CheckStatus::pass) == passed &&
                    findImage(report, id) && std::find(ids.begin(), ids.end(), id) == ids.end())
                    ids.push_back(id);
    return ids;
}

// Halves the largest picture as long as that helps. False: none can become smaller.
bool shrinkLargest(Pictures& pictures) {
    const auto largest = std::max_element(pictures.begin(), pictures.end(), [](const auto& a, const auto& b) {
        return a.second.size() < b.second.size();
    });
    if (largest == pictures.end() || largest->second.size() < smallest)
        return false;
    std::string small = halved(largest->second);
    if (small.empty() || small.size() >= largest->second.size())
        return false;
    largest->second = std::move(small);
    return true;
}

}  // namespace

std::string prairielearn(const Report& report, const std::filesystem::path& folder) {
    std::vector<std::string> ids = wantedImages(report);
    ids.resize(std::min(ids.size(), mostPictures));
    Pictures pictures;
    for (const std::string& id : ids)
        if (std::string png = pngBytes(*findImage(report, id), folder); !png.empty())
            pictures[id] = std::move(png);
    std::string text = write(report, pictures);
    while (text.size() >= most && !ids.empty()) {
        if (!shrinkLargest(pictures)) {
            pictures.erase(ids.back());
            ids.pop_back();
        }
        text = write(report, pictures);
    }
    return text;
}

}  // namespace grader
