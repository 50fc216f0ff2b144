// Document, pills, bars, ring.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/html_parts.hpp"

#include "grader/report/formats/html_style.hpp"

#include <algorithm>
#include <cmath>

namespace grader {

std::string page(Language language, const std::string& title, const std::string& mainClass,
                 const std::string& body, const std::string& script, const std::string& scriptHash) {
    const std::string allowed = script.empty() ? "" : "; script-src 'sha256-" + scriptHash + "'";
    return std::string("<!DOCTYPE html>\n<html lang=\"") + say(language, "en", "it") +
           "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
           "initial-scale=1\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
           "style-src 'unsafe-inline'; "
           "base-uri 'none'; form-action 'none'" +
           allowed + "\">\n<meta name=\"referrer\" content=\"no-referrer\">\n<title>" +
           escaped(oneLine(title)) + "</title>\n<style>" + pageStyle +
           "</style>\n</head>\n<body>\n<main class=\"" + mainClass + "\">\n" + body + "</main>\n" +
           (script.empty() ? "" : "<script>" + script + "</script>\n") + "</body>\n</html>\n";
}

const char* classFor(CheckStatus status) {
    switch (status) {
    case CheckStatus::pass:
        return "pass";
    case CheckStatus::partial:
        return "partial";
    case CheckStatus::fail:
        return "fail";
    case CheckStatus::skipped:
        break;
    }
    return "skipped";
}

std::string pill(Language language, CheckStatus status) {
    return std::string("<span class=\"pill ") + classFor(status) + "\"><span aria-hidden=\"true\">" +
           signFor(status) + "</span>" + wordFor(language, status) + "</span>";
}

std::string bar(double share, const char* color) {
    const double filled = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0;
    return "<span class=\"bar\" aria-hidden=\"true\"><i style=\"width:" +
           number(std::round(1000 * filled) / 10) + "%" +
           (*color ? std::string(";background:") + color : "") + "\"></i></span>";
}

std::string scoreRing(const Report& report) {
    const bool graded = report.status == ReportStatus::graded;
    constexpr double length = 2 * 3.14159265358979 * 50;  // of the ring
    const double share = graded ? fraction(report) : 0;
    const char* color = share >= 1 ? "var(--pass)" : "var(--accent)";
    std::string svg =
        "<svg class=\"ring\" viewBox=\"0 0 116 116\" role=\"img\" aria-label=\"" + escaped(headline(report)) +
        "\"><circle cx=\"58\" cy=\"58\" r=\"50\" fill=\"none\" stroke=\"var(--track)\" stroke-width=\"10\"/>";
    if (share > 0)
        svg += std::string("<circle cx=\"58\" cy=\"58\" r=\"50\" fill=\"none\" stroke=\"") + color +
               "\" stroke-width=\"10\" stroke-linecap=\"round\" transform=\"rotate(-90 58 58)\" "
               "stroke-dasharray=\"" +
               number(std::round(10 * length * share) / 10) + " 400\"/>";
    if (!graded)
        return svg + "<text x=\"58\" y=\"69\" font-size=\"32\">–</text></svg>";
    return svg + "<text x=\"58\" y=\"62\" font-size=\"27\">" + points(report.score) +
           "</text><text x=\"58\" y=\"81\" font-size=\"13\" style=\"fill:var(--soft);font-weight:400\">" +
           say(report.language, "of ", "su ") + points(report.maxScore) + "</text></svg>";
}

std::string element(const std::string& tag, const std::string& text, const std::string& styleClass) {
    if (text.empty())
        return "";
    return "<" + tag + (styleClass.empty() ? "" : " class=\"" + styleClass + "\"") + ">" + escaped(text) +
           "</" + tag + ">\n";
}

}  // namespace grader
