// Counting, and the two charts.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/overview_parts.hpp"

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

void countCheck(ClassNumbers& numbers, const Check& check) {
    auto found = std::find_if(numbers.checks.begin(), numbers.checks.end(),
                              [&](const CheckCount& each) { return each.id == check.id; });
    if (found == numbers.checks.end())
        found = numbers.checks.insert(found, {check.id, oneLine(check.title), {}});
    ++found->with[static_cast<std::size_t>(check.status)];
}

void countMisconception(ClassNumbers& numbers, const Explanation& why, const std::string& submission) {
    std::string ids;
    for (const std::string& id : why.ids)
        ids += (ids.empty() ? "" : " ") + id;
    auto found = std::find_if(numbers.misconceptions.begin(), numbers.misconceptions.end(),
                              [&](const MisconceptionCount& each) { return each.ids == ids; });
    if (found == numbers.misconceptions.end())
        found = numbers.misconceptions.insert(found, {ids, oneLine(why.name), {}});
    auto& names = found->submissions;
    if (std::find(names.begin(), names.end(), submission) == names.end())
        names.push_back(submission);
}

std::string text(double x, double y, const std::string& words, const char* more = "") {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"middle\" font-size=\"13\" " +
           more + ">" + words + "</text>";
}

}  // namespace

ClassNumbers count(const std::vector<const ClassMember*>& members) {
    ClassNumbers numbers;
    for (const ClassMember* member : members) {
        const Report& report = member->report;
        numbers.compileSeconds += report.compileSeconds;
        numbers.framesSeconds += report.framesSeconds;
        numbers.judgeSeconds += report.judgeSeconds;
        if (report.status != ReportStatus::graded)
            continue;
        numbers.shares.push_back(fraction(report));
        for (const Check& check : report.checks) {
            countCheck(numbers, check);
            if (check.explanation)
                countMisconception(numbers, *check.explanation, report.submission);
        }
    }
    std::sort(numbers.shares.begin(), numbers.shares.end());
    std::stable_sort(
        numbers.misconceptions.begin(), numbers.misconceptions.end(),
        [](const auto& a, const auto& b) { return a.submissions.size() > b.submissions.size(); });
    return numbers;
}

std::string histogram(Language language, const std::vector<double>& shares) {
    constexpr std::size_t columns = 10;
    constexpr double step = 56, base = 170, height = 140;
    std::array<std::size_t, columns> counts{};
    for (const double share : shares)
        ++counts[std::min(columns - 1, static_cast<std::size_t>(share * columns + 1e-9))];
    const std::size_t most = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
    std::string words, bars;
    for (std::size_t i = 0; i < columns; ++i) {
        const double x = 4 + step * static_cast<double>(i);
        const double tall = height * static_cast<double>(counts[i]) / static_cast<double>(most);
        if (counts[i] > 0)
            bars += "<rect x=\"" + number(x + 3) + "\" y=\"" + number(std::round(10 * (base - tall)) / 10) +
                    "\" width=\"" + number(step - 6) + "\" height=\"" + number(std::round(10 * tall) / 10) +
                    "\" rx=\"5\" fill=\"var(--accent)\"/>" +
                    text(x + step / 2, base - tall - 6, std::to_string(counts[i]),
                         "fill=\"var(--ink)\" font-weight=\"600\"");
        const std::string range = std::to_string(10 * i) + "–" + std::to_string(10 * i + 10);
        bars += text(x + step / 2, base + 19, range, "fill=\"var(--soft)\"");
        words += (words.empty() ? "" : ", ") + range + " %: " + std::to_string(counts[i]);
    }
    return "<svg viewBox=\"0 0 568 196\" role=\"img\" style=\"width:100%;height:auto;max-width:46rem\" "
           "aria-label=\"" +
           std::string(say(language, "Submissions by percentage of the points: ",
                           "Consegne per percentuale dei punti: ")) +
           words + "\">" + bars +
           "<line x1=\"4\" x2=\"564\" y1=\"170\" y2=\"170\" stroke=\"var(--line)\"/></svg>\n";
}

std::string checkBars(Language language, const std::vector<CheckCount>& checks) {
    std::string rows;
    for (const CheckCount& check : checks) {
        std::string parts, cells;
        for (std::size_t i = 0; i < check.with.size(); ++i) {
            const auto status = static_cast<CheckStatus>(i);
            const double share = static_cast<double>(check.with[i]) / static_cast<double>(check.all());
            if (check.with[i] > 0)
                parts += "<i style=\"width:" + number(std::round(1000 * share) / 10) + "%;background:var(--" +
                         classFor(status) + ")\"></i>";
            cells += "<td class=\"num\">" + std::to_string(check.with[i]) + "</td>";
        }
        rows += "<tr><th scope=\"row\">" + escaped(check.title) +
                "</th><td><span class=\"stack\" aria-hidden=\"true\">" + parts + "</span></td>" + cells +
                "</tr>\n";
    }
    std::string head;
    for (const CheckStatus status :
         {CheckStatus::pass, CheckStatus::partial, CheckStatus::fail, CheckStatus::skipped})
        head += std::string("<th scope=\"col\" class=\"num\">") + pill(language, status) + "</th>";
    return std::string("<div class=\"scroll\"><table class=\"checks\"><thead><tr><th scope=\"col\">") +
           say(language, "check", "controllo") + "</th><td></td>" + head + "</tr></thead>\n<tbody>" + rows +
           "</tbody></table></div>\n";
}

}  // namespace grader
