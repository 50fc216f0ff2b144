// The class on one page: what needs a hand first, then how it went, what was misunderstood, and everybody.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/overview_parts.hpp"

#include <algorithm>

namespace grader {

namespace {

using Members = std::vector<const ClassMember*>;

// Sorts the table by the column whose head is pressed; numbers as numbers. The policy lets only this text run.
constexpr const char* sortScript = R"js(
document.querySelectorAll("table.sortable th button").forEach(function (button) {
  button.addEventListener("click", function () {
    var head = button.parentNode, table = head.closest("table"), body = table.tBodies[0], column = head.cellIndex;
    var down = head.getAttribute("aria-sort") === "ascending";
    table.querySelectorAll("th").forEach(function (other) { other.removeAttribute("aria-sort"); });
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    function key(row) { var cell = row.cells[column]; return cell.dataset.key === undefined ? cell.textContent : Number(cell.dataset.key); }
    Array.from(body.rows).sort(function (a, b) {
      var x = key(a), y = key(b), order = typeof x === "number" ? x - y : x.localeCompare(y);
      return down ? -order : order;
    }).forEach(function (row) { body.appendChild(row); });
  });
});
)js";
constexpr const char* sortScriptHash =
    "hoO098/8ztWkPfIJ73wFow6KMBCkbSdtZbTPdmowYEE=";  // its SHA-256: the test report.files says which

// A path as a relative URL: every byte that could mean something else is written as %XX.
std::string url(const std::string& path) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string result = "./";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_' || c == '.' || c == '/';
        result += plain ? std::string(1, c) : std::string{'%', digits[byte >> 4U], digits[byte & 15U]};
    }
    return result;
}

std::string link(const ClassMember& member) {
    return "<a href=\"" + url(member.page) + "\">" + escaped(oneLine(member.report.submission)) + "</a>";
}

std::string section(const char* title, const std::string& content) {
    return content.empty()
               ? ""
               : std::string("<section class=\"card\">\n<h2>") + title + "</h2>\n" + content + "</section>\n";
}

std::string troubles(Language language, const Members& members) {
    std::string rows;
    for (const ReportStatus status : {ReportStatus::infrastructure, ReportStatus::notGradable})
        for (const ClassMember* member : members)
            if (member->report.status == status)
                rows += "<tr><th scope=\"row\">" + link(*member) + "</th><td>" +
                        (status == ReportStatus::infrastructure
                             ? say(language, "grade again", "da correggere di nuovo")
                             : say(language, "nothing to judge", "nulla da giudicare")) +
                        "</td><td>" + escaped(oneLine(member->report.reason)) + "</td></tr>\n";
    return rows.empty() ? ""
                        : "<section class=\"card notice\">\n<h2>" +
                              std::string(say(language, "Without marks", "Senza voto")) +
                              "</h2>\n<div class=\"scroll\"><table><tbody>" + rows +
                              "</tbody></table></div>\n</section>\n";
}

std::string misconceptions(Language language, const std::vector<MisconceptionCount>& counts,
                           std::size_t graded) {
    std::string rows;
    for (const MisconceptionCount& each : counts) {
        std::string names;
        for (const std::string& name : each.submissions)
            names += (names.empty() ? "" : ", ") + escaped(oneLine(name));
        const double share = static_cast<double>(each.submissions.size()) /
                             static_cast<double>(std::max<std::size_t>(1, graded));
        rows += "<tr><th scope=\"row\">" + escaped(each.name) + "<br><span class=\"soft small\">" +
                escaped(oneLine(each.ids)) + "</span></th><td class=\"num\">" +
                std::to_string(each.submissions.size()) + "</td><td>" + bar(share) +
                "</td><td class=\"small\">" + names + "</td></tr>\n";
    }
    if (rows.empty())
        return "";
    return std::string("<div class=\"scroll\"><table class=\"wrong\"><thead><tr><th scope=\"col\">") +
           say(language, "misconception", "equivoco") + "</th><th scope=\"col\" colspan=\"2\">" +
           say(language, "how many", "quanti") + "</th><th scope=\"col\">" + say(language, "who", "chi") +
           "</th></tr></thead>\n<tbody>" + rows + "</tbody></table></div>\n";
}

std::string similarities(Language language, const Members& members) {
    std::string rows;
    for (const ClassMember* member : members)
        for (const Similar& other : member->report.similar)
            rows += "<tr><th scope=\"row\">" + link(*member) + "</th><td>" +
                    escaped(oneLine(other.submission)) + "</td><td>" + escaped(oneLine(other.how)) +
                    "</td></tr>\n";
    return rows.empty() ? ""
                        : element("p",
                                  say(language, "These render from the same source: reported, never judged.",
                                      "Queste disegnano dallo stesso sorgente: segnalate, mai giudicate."),
                                  "soft") +
                              "<div class=\"scroll\"><table><tbody>" + rows + "</tbody></table></div>\n";
}

std::string sortHead(const char* words) {
    return std::string("<th scope=\"col\"><button type=\"button\">") + words + "</button></th>";
}

std::string everybody(Language language, const Members& members, const ClassNumbers& numbers) {
    std::string rows;
    for (const ClassMember* member : members) {
        const Report& report = member->report;
        const bool graded = report.status == ReportStatus::graded;
        std::string row = "<tr><th scope=\"row\">" + link(*member) + "</th><td class=\"num\" data-key=\"" +
                          number(graded ? fraction(report) : -1) + "\">" +
                          (graded ? points(report.score) + " / " + points(report.maxScore)
                                  : std::string(say(language, "no marks", "senza voto"))) +
                          "</td>";
        for (const CheckCount& column : numbers.checks) {
            const auto check = std::find_if(report.checks.begin(), report.checks.end(),
                                            [&](const Check& each) { return each.id == column.id; });
            if (!graded || check == report.checks.end())
                row += "<td data-key=\"-1\"></td>";
            else
                row += "<td data-key=\"" + number(check->score) + "\"><span class=\"sign " +
                       classFor(check->status) + "\" title=\"" + escaped(wordFor(language, check->status)) +
                       "\">" + signFor(check->status) + "</span> <span class=\"num\">" +
                       points(check->score) + "</span></td>";
        }
        rows += row + "</tr>\n";
    }
    std::string head =
        sortHead(say(language, "submission", "consegna")) + sortHead(say(language, "points", "punti"));
    for (const CheckCount& column : numbers.checks)
        head += sortHead(escaped(oneLine(column.id)).c_str());
    return "<div class=\"scroll\"><table class=\"sortable\"><thead><tr>" + head + "</tr></thead>\n<tbody>" +
           rows + "</tbody></table></div>\n";
}

std::string headOf(Language language, const Members& members, const ClassNumbers& numbers) {
    const std::string lesson = members.empty() ? "" : oneLine(members[0]->report.lessonTitle);
    std::string facts = std::to_string(members.size()) + say(language, " submissions", " consegne") + ", " +
                        std::to_string(numbers.shares.size()) + say(language, " with marks", " con voto");
    if (!numbers.shares.empty()) {
        const std::size_t middle = numbers.shares.size() / 2;
        const double median = numbers.shares.size() % 2
                                  ? numbers.shares[middle]
                                  : (numbers.shares[middle - 1] + numbers.shares[middle]) / 2;
        facts += std::string(". ") + say(language, "Median: ", "Mediana: ") + percent(median) +
                 say(language, " of the points.", " dei punti.");
    }
    return "<header class=\"card\">\n" +
           element("p", members.empty() ? "" : oneLine(members[0]->report.lesson), "eyebrow") +
           element("h1", lesson.empty() ? say(language, "The class", "La classe") : lesson) +
           element("p", facts, "verdict") +
           element("p",
                   say(language, "For the instructor: it names who misunderstood what.",
                       "Per il docente: dice chi ha frainteso che cosa."),
                   "soft small") +
           "</header>\n";
}

std::string times(Language language, const ClassNumbers& numbers) {
    const double all = numbers.compileSeconds + numbers.framesSeconds + numbers.judgeSeconds;
    return element(
        "footer",
        std::string(say(language, "Time, in seconds: building ", "Tempo, in secondi: compilazione ")) +
            points(numbers.compileSeconds) + say(language, ", rendering ", ", disegno ") +
            points(numbers.framesSeconds) + say(language, ", judging ", ", giudizio ") +
            points(numbers.judgeSeconds) + say(language, "; in all ", "; in tutto ") + points(all) + ".");
}

}  // namespace

std::string overview(const std::vector<ClassMember>& members, Language language) {
    Members sorted;
    for (const ClassMember& member : members)
        sorted.push_back(&member);
    std::stable_sort(sorted.begin(), sorted.end(), [](const ClassMember* a, const ClassMember* b) {
        return a->report.submission < b->report.submission;
    });
    const ClassNumbers numbers = count(sorted);
    std::string body = headOf(language, sorted, numbers) + troubles(language, sorted);
    if (!numbers.shares.empty()) {
        body += section(say(language, "Points, in percent", "Punti, in percentuale"),
                        histogram(language, numbers.shares));
        body += section(say(language, "Check by check", "Controllo per controllo"),
                        checkBars(language, numbers.checks));
    }
    body += section(say(language, "Commonest misconceptions", "Gli equivoci più comuni"),
                    misconceptions(language, numbers.misconceptions, numbers.shares.size()));
    body += section(say(language, "Similar submissions", "Consegne simili"), similarities(language, sorted));
    body += section(say(language, "Everybody", "Tutti"), everybody(language, sorted, numbers)) +
            times(language, numbers);
    return page(language, say(language, "The class", "La classe"), "wide", body, sortScript, sortScriptHash);
}

}  // namespace grader
