// One check of the student's page: what was found, why, where, and how it looks.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/html_parts.hpp"

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

std::string described(const char* term, const std::string& html) {
    return html.empty() ? "" : std::string("<dt>") + term + "</dt><dd>" + html + "</dd>\n";
}

std::string advice(Language language, const Check& check) {
    std::string slides;
    for (const int slide : check.slides)
        slides += "<span class=\"chip\">slide " + std::to_string(slide) + "</span>";
    const std::string list = described(say(language, "Expected", "Atteso"), escaped(check.expected)) +
                             described(say(language, "Next step", "Prossimo passo"), escaped(check.hint)) +
                             described(say(language, "To reread", "Da rileggere"),
                                       check.status == CheckStatus::pass ? "" : slides);
    return list.empty() ? "" : "<dl>\n" + list + "</dl>\n";
}

std::string explanation(Language language, const Explanation& why) {
    return std::string("<div class=\"why\">\n<h3>") + say(language, "This looks like", "Sembra questo") +
           "</h3>\n" + element("p", why.name, "name") + "<div class=\"measure\">" + bar(why.explained) +
           "<span class=\"small\">" + say(language, "explains ", "spiega il ") + percent(why.explained) +
           say(language, " of the wrong pixels", " dei pixel sbagliati") + "</span></div>\n" +
           element("p", why.hint) +
           element("p",
                   why.convention.empty() ? "" : say(language, "Elsewhere: ", "Altrove: ") + why.convention,
                   "soft small") +
           "</div>\n";
}

std::string swatch(const std::array<double, 3>& color) {
    std::string codes;
    for (const double channel : color)
        codes += (codes.empty() ? "" : ",") +
                 number(std::isfinite(channel) ? std::round(255 * std::clamp(channel, 0.0, 1.0)) : 0);
    return "<span class=\"swatch\" style=\"background:rgb(" + codes + ")\" aria-hidden=\"true\"></span>";
}

std::string channels(Language language, const WorstPixel& worst) {
    std::string rows = std::string("<tr><th scope=\"row\">") + say(language, "colour", "colore") +
                       "</th><td>" + swatch(worst.found) + "</td><td>" + swatch(worst.expected) +
                       "</td></tr>\n";
    for (std::size_t i = 0; i < 3; ++i)
        rows += std::string("<tr><th scope=\"row\">") + "RGB"[i] + "</th><td class=\"value\">" +
                number(std::round(worst.found[i] * 1e4) / 1e4) + "</td><td class=\"value\">" +
                number(std::round(worst.expected[i] * 1e4) / 1e4) + "</td></tr>\n";
    return std::string("<table><thead><tr><td></td><th scope=\"col\">") + say(language, "found", "trovato") +
           "</th><th scope=\"col\">" + say(language, "expected", "atteso") + "</th></tr></thead>\n<tbody>" +
           rows + "</tbody></table>\n";
}

std::string terms(Language language, const WorstPixel& worst) {
    if (worst.numbers.empty())
        return "";
    std::string rows;
    for (const TermNumber& term : worst.numbers)
        rows += "<tr><th scope=\"row\" class=\"symbol\">" + escaped(oneLine(term.symbol)) +
                "</th><td class=\"value\">" + escaped(oneLine(term.value)) + "</td></tr>\n";
    return std::string("<table><thead><tr><th scope=\"col\">") +
           say(language, "in the equation", "nell'equazione") + "</th><th scope=\"col\">" +
           (worst.ownScene ? say(language, "in your scene, there", "nella tua scena, lì")
                           : say(language, "as it should be", "come dovrebbe essere")) +
           "</th></tr></thead>\n<tbody>" + rows + "</tbody></table>\n";
}

std::string worstPixel(Language language, const WorstPixel& worst) {
    return std::string("<h3>") + say(language, "The worst pixel", "Il pixel peggiore") +
           "</h3>\n<p class=\"soft small\">" + escaped(oneLine(worst.frame)) + ", x " +
           std::to_string(worst.x) + ", y " + std::to_string(worst.y) + ", " +
           escaped(regionName(language, worst.region)) +
           say(language, "; linear colours from 0 to 1", "; colori lineari da 0 a 1") +
           "</p>\n<div class=\"two\">\n" + channels(language, worst) + terms(language, worst) + "</div>\n";
}

std::string regions(Language language, const std::vector<RegionShare>& shares) {
    std::string rows;
    for (const RegionShare& share : shares)
        rows += "<tr><th scope=\"row\">" + escaped(regionName(language, share.name)) + "</th><td>" +
                bar(share.right) + "</td><td class=\"num\">" + percent(share.right) +
                "</td><td class=\"num soft\">" + std::to_string(share.pixels) + "</td></tr>\n";
    if (rows.empty())
        return "";
    return std::string("<h3>") + say(language, "Part by part", "Parte per parte") +
           "</h3>\n<table class=\"share\"><thead><tr><th scope=\"col\">" + say(language, "part", "parte") +
           "</th><th scope=\"col\" colspan=\"2\">" + say(language, "as expected", "come atteso") +
           "</th><th scope=\"col\">" + say(language, "pixels", "pixel") + "</th></tr></thead>\n<tbody>" +
           rows + "</tbody></table>\n";
}

std::string roleName(Language language, const std::string& role) {
    return role == "yours"      ? say(language, "Yours", "La tua")
           : role == "expected" ? say(language, "Expected", "Attesa")
                                : say(language, "Difference", "Differenza");
}

std::string pictures(const Report& report, const Check& check, const std::filesystem::path& folder) {
    std::string figures;
    for (const std::string& id : check.images) {
        const ReportImage* image = findImage(report, id);
        const std::string png = image ? pngBytes(*image, folder) : "";
        if (png.empty())
            continue;
        const std::string label = escaped(oneLine(image->label));
        figures += "<figure><img src=\"" + dataUrl(png) + "\" width=\"" + std::to_string(image->width) +
                   "\" height=\"" + std::to_string(image->height) + "\" alt=\"" + label +
                   "\"><figcaption><b>" + roleName(report.language, image->role) + "</b>" + label +
                   "</figcaption></figure>\n";
    }
    return figures.empty() ? ""
                           : std::string("<h3>") + say(report.language, "Pictures", "Immagini") +
                                 "</h3>\n<div class=\"pictures\">\n" + figures + "</div>\n";
}

}  // namespace

bool hasCard(const Check& check) {
    const bool quiet = check.status == CheckStatus::pass || check.status == CheckStatus::skipped;
    return !quiet || check.explanation || check.worst || !check.images.empty();
}

std::string checkCard(const Report& report, const Check& check, std::size_t index,
                      const std::filesystem::path& folder) {
    const Language language = report.language;
    const std::string at = std::to_string(index);
    std::string card = "<section class=\"card check is-" + std::string(classFor(check.status)) +
                       "\" id=\"check-" + at + "\" aria-labelledby=\"title-" + at + "\">\n<header>" +
                       pill(language, check.status) + "<h2 id=\"title-" + at + "\">" +
                       escaped(oneLine(check.title)) + "</h2><span class=\"num\">" + points(check.score) +
                       " / " + points(check.maxScore) + "</span></header>\n";
    card += element("p", check.message, "message") + advice(language, check);
    if (check.explanation)
        card += explanation(language, *check.explanation);
    card += pictures(report, check, folder);
    if (check.worst)
        card += worstPixel(language, *check.worst);
    return card + regions(language, check.regions) + "</section>\n";
}

}  // namespace grader
