// The formats by name, for the command line.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/formats.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace grader {

namespace {

struct Row {
    Format format;
    const char *name, *file;
};

constexpr Row rows[] = {
    {Format::gradescope, "gradescope", "gradescope.json"},
    {Format::prairielearn, "prairielearn", "prairielearn.json"},
    {Format::autolab, "autolab", "autolab.txt"},
    {Format::coderunner, "coderunner", "coderunner.json"},
    {Format::vpl, "vpl", "vpl.txt"},
    {Format::junit, "junit", "junit.xml"},
    {Format::csv, "csv", "report.csv"},
    {Format::html, "html", "report.html"},
};

const Row& rowOf(Format format) {
    return *std::find_if(std::begin(rows), std::end(rows),
                         [&](const Row& row) { return row.format == format; });
}

}  // namespace

const char* nameOf(Format format) { return rowOf(format).name; }

const char* fileNameOf(Format format) { return rowOf(format).file; }

std::vector<Format> allFormats() {
    std::vector<Format> all;
    for (const Row& row : rows)
        all.push_back(row.format);
    return all;
}

std::vector<Format> parseFormats(const std::string& list) {
    std::vector<Format> formats;
    std::istringstream stream(list + ",");
    for (std::string name; std::getline(stream, name, ',');) {
        const auto row = std::find_if(std::begin(rows), std::end(rows),
                                      [&](const Row& each) { return name == each.name; });
        if (row == std::end(rows)) {
            std::string known;
            for (const Row& each : rows)
                known += std::string(known.empty() ? "" : ", ") + each.name;
            throw std::runtime_error("--format: expected some of " + known +
                                     ", with commas between them, found '" + name + "'");
        }
        if (std::find(formats.begin(), formats.end(), row->format) == formats.end())
            formats.push_back(row->format);
    }
    return formats;
}

std::string format(const Report& report, const std::filesystem::path& folder, Format format) {
    switch (format) {
    case Format::gradescope:
        return gradescope(report, folder);
    case Format::prairielearn:
        return prairielearn(report, folder);
    case Format::autolab:
        return autolab(report);
    case Format::coderunner:
        return coderunner(report, folder);
    case Format::vpl:
        return vpl(report);
    case Format::junit:
        return junit(report);
    case Format::csv:
        return csv(report);
    case Format::html:
        break;
    }
    return html(report, folder);
}

}  // namespace grader
