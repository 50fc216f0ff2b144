// Paragraphs, the numbers in <pre>, and pictures.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/rich_text.hpp"

namespace grader {

std::string richText(const Report& report, const Check& check,
                     const std::function<std::string(const ReportImage&)>& source) {
    std::string html;
    std::string numbers;
    const auto endNumbers = [&] {
        if (!numbers.empty())
            html += "<pre>" + numbers + "</pre>";
        numbers.clear();
    };
    for (const std::string& line : feedbackLines(report, check)) {
        if (line.starts_with("    ")) {
            numbers += (numbers.empty() ? "" : "\n") + escaped(line.substr(4));
            continue;
        }
        endNumbers();
        html += "<p>" + escaped(line) + "</p>";
    }
    endNumbers();
    for (const std::string& id : check.images) {
        const ReportImage* image = findImage(report, id);
        const std::string url = image ? source(*image) : "";
        if (!url.empty())
            html += "<p><img src=\"" + escaped(url) + "\" alt=\"" + escaped(oneLine(image->label)) +
                    "\"><br>" + escaped(oneLine(image->label)) + "</p>";
    }
    return html;
}

}  // namespace grader
